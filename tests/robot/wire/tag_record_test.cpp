// SPDX-License-Identifier: MIT
#include "robot/wire/tag_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

using testing::ElementsAre;

constexpr CarpetRecord kRecord{.map_id = 0x2026'0007, .column = 3, .row = -2};

TEST(TagRecord, CarpetTagIsTwelveBytesAsDrawn) {
  EXPECT_THAT(encode(kRecord),
              ElementsAre(0x58, 0x01, 0x20, 0x26, 0x00, 0x03, 0xFF, 0xFE, 0x00, 0x07, 0x79, 0xB5));
}

TEST(TagRecord, ChecksumIsTheOneOfIso13239) {
  const std::string_view digits = "123456789";  // the catalogue's check value for CRC-16/X-25
  EXPECT_EQ(crc16_iso13239(Bytes(digits.begin(), digits.end())), 0x906E);
}

TEST(TagRecord, CarpetTagsComeBackForExtremeTiles) {
  for (const int c : {-32768, -1, 0, 1, 32767}) {
    for (const int r : {-32768, -1, 0, 1, 32767}) {
      const CarpetRecord record{0xFFFF'FFFFu, static_cast<std::int16_t>(c), static_cast<std::int16_t>(r)};
      const auto decoded = decode_tag_record(encode(record));
      ASSERT_TRUE(decoded);
      EXPECT_EQ(std::get<CarpetRecord>(*decoded), record);
    }
  }
}

TEST(TagRecord, LandmarksAreTheBytesOfTableOne) {
  const auto first_two = [](LandmarkKind kind) {
    const auto bytes = encode(LandmarkRecord{kind});
    return std::pair<int, int>{bytes[0], bytes[1]};
  };
  EXPECT_EQ(first_two(LandmarkKind::kDoorOpeningSide), std::pair(0b00000001, 0b00000001));
  EXPECT_EQ(first_two(LandmarkKind::kDoorFixedSide), std::pair(0b00000001, 0b00000000));
  EXPECT_EQ(first_two(LandmarkKind::kFrontDoorOpeningSide), std::pair(0b10000001, 0b00000001));
  EXPECT_EQ(first_two(LandmarkKind::kFrontDoorFixedSide), std::pair(0b10000001, 0b00000000));
  EXPECT_EQ(first_two(LandmarkKind::kWindowLeft), std::pair(0b00000010, 0b00000001));
  EXPECT_EQ(first_two(LandmarkKind::kWindowRight), std::pair(0b00000010, 0b00000000));
  EXPECT_EQ(first_two(LandmarkKind::kPowerOutlet), std::pair(0b00000011, 0b00000000));
  EXPECT_EQ(first_two(LandmarkKind::kClosetLeft), std::pair(0b00000100, 0b00000001));
  EXPECT_EQ(first_two(LandmarkKind::kClosetRight), std::pair(0b00000100, 0b00000000));
}

TEST(TagRecord, EveryLandmarkComesBack) {
  for (int k = 0; k <= static_cast<int>(LandmarkKind::kClosetRight); ++k) {
    const LandmarkRecord record{static_cast<LandmarkKind>(k)};
    const auto decoded = decode_tag_record(encode(record));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(std::get<LandmarkRecord>(*decoded), record);
  }
}

TEST(TagRecord, AnOutletsSecondByteIsNotLookedAt) {
  const auto decoded = decode_tag_record(Bytes{0x03, 0x7E, 0, 0});
  ASSERT_TRUE(decoded);
  EXPECT_EQ(std::get<LandmarkRecord>(*decoded).kind, LandmarkKind::kPowerOutlet);
}

TEST(TagRecord, FurnitureIsFfAndTheFourBytesOfTableTwoInBlockOne) {
  const ObjectRecord table{.category = 3, .length = 12, .width = 8, .color = 5};
  EXPECT_THAT(encode(table), ElementsAre(0xFF, 0, 0, 0, 3, 12, 8, 5));
  const auto decoded = decode_tag_record(encode(table));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(std::get<ObjectRecord>(*decoded), table);
}

TEST(TagRecord, NamesEachMistake) {
  const auto error = [](const Bytes& memory) { return decode_tag_record(memory).error(); };
  EXPECT_EQ(error({}), TagRecordError::kTooShort);
  EXPECT_EQ(error({0x58, 1, 0, 0}), TagRecordError::kTooShort);
  EXPECT_EQ(error({0xFF, 0, 0, 0}), TagRecordError::kTooShort);
  EXPECT_EQ(error({0, 0, 0, 0, 0, 0, 0, 0}), TagRecordError::kBlank);
  EXPECT_EQ(error({0, 0, 0, 1}), TagRecordError::kUnknownFormat);
  EXPECT_EQ(error({0x42, 0, 0, 0}), TagRecordError::kUnknownFormat);
  EXPECT_EQ(error({0x01, 0x02, 0, 0}), TagRecordError::kUnknownLandmark);
  EXPECT_EQ(error({0x58, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), TagRecordError::kUnknownVersion);
  EXPECT_EQ(error({0x58, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), TagRecordError::kBadCrc);
}

TEST(TagRecord, EverySingleFlippedBitBehindTheVersionIsABadCrc) {
  for (std::size_t bit = 16; bit < 8 * kCarpetRecordBytes; ++bit) {
    auto memory = encode(kRecord);
    memory[bit / 8] = static_cast<std::uint8_t>(memory[bit / 8] ^ (1u << (bit % 8)));
    const auto decoded = decode_tag_record(memory);
    ASSERT_FALSE(decoded) << bit;
    EXPECT_EQ(decoded.error(), TagRecordError::kBadCrc) << bit;
  }
}

// A first write that is cut off leaves any mixture of zeros and the record: neither a wrong tile nor a door.
TEST(TagRecord, AMixtureOfABlankTagAndARecordIsNeverTakenForAnything) {
  RandomStream random{7};
  const auto whole = encode(kRecord);
  int decoded_wrong = 0;
  for (int i = 0; i < 200'000; ++i) {
    auto torn = whole;
    for (std::uint8_t& byte : torn) {
      byte = static_cast<std::uint8_t>(byte & random.below(256));
    }
    const auto decoded = decode_tag_record(torn);
    if (decoded && !(std::holds_alternative<CarpetRecord>(*decoded) && torn == whole)) {
      ASSERT_TRUE(std::holds_alternative<CarpetRecord>(*decoded));
      ++decoded_wrong;
    }
  }
  // Marker and version survive 1 time in 16; a 16-bit CRC then lets 1 in 65536 by: 0.2 expected.
  EXPECT_LE(decoded_wrong, 4);
}

TEST(TagRecord, NeverCrashesOnRandomMemoryAndKeepsWhatItAccepts) {
  RandomStream random{99};
  for (int i = 0; i < 200'000; ++i) {
    Bytes memory(random.below(17));
    for (std::uint8_t& byte : memory) {
      byte = static_cast<std::uint8_t>(random.below(256));
    }
    const auto decoded = decode_tag_record(memory);
    if (decoded && std::holds_alternative<ObjectRecord>(*decoded)) {
      const auto again = encode(std::get<ObjectRecord>(*decoded));
      EXPECT_TRUE(std::equal(again.begin() + 4, again.end(), memory.begin() + 4));
    }
  }
}

}  // namespace
}  // namespace sensotwin::robot
