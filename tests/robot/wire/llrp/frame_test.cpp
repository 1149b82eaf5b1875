// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/wire/llrp/codec.hpp"

namespace sensotwin::robot::llrp {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

struct Found {
  std::vector<std::uint32_t> ids;
  std::vector<FrameError> errors;
};

/// Feeds `bytes` in pieces of `piece`.
[[nodiscard]] Found feed(FrameDecoder& decoder, ByteView bytes, std::size_t piece) {
  Found found;
  while (!bytes.empty()) {
    const auto room = decoder.room();
    const std::size_t n = std::min({piece, bytes.size(), room.size()});
    EXPECT_GT(n, 0u);
    std::copy_n(bytes.begin(), n, room.begin());
    decoder.received(n);
    bytes = bytes.subspan(n);
    while (const auto frame = decoder.next()) {
      if (*frame) {
        found.ids.push_back((*frame)->header.id);
      } else {
        found.errors.push_back(frame->error());
      }
    }
  }
  return found;
}

[[nodiscard]] Bytes three_messages() {
  Bytes out;
  encode(Keepalive{}, 1, out);
  encode(RoAccessReport{{{.epc_96 = Epc{}}}, {}}, 2, out);
  encode(KeepaliveAck{}, 3, out);
  return out;
}

TEST(LlrpFrames, AreFoundHoweverTheStreamIsCut) {
  const Bytes bytes = three_messages();
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    FrameDecoder decoder;
    const Found found = feed(decoder, bytes, piece);
    EXPECT_THAT(found.ids, ElementsAre(1, 2, 3)) << piece;
    EXPECT_THAT(found.errors, IsEmpty());
  }
}

TEST(LlrpFrames, TellTheirHeader) {
  FrameDecoder decoder;
  const Bytes bytes = encode(CustomMessage{.vendor = 9, .subtype = 1, .payload = {5}}, 0xFFFFFFFEu, 5);
  std::ranges::copy(bytes, decoder.room().begin());
  decoder.received(bytes.size());
  const auto frame = decoder.next();
  ASSERT_TRUE(frame && *frame);
  EXPECT_EQ((*frame)->header, (FrameHeader{5, 1023, 0xFFFFFFFEu}));
  EXPECT_THAT((*frame)->body, ElementsAre(0, 0, 0, 9, 1, 5));
}

TEST(LlrpFrames, WaitForTheRestOfAMessage) {
  FrameDecoder decoder;
  Bytes bytes = three_messages();
  bytes.resize(15);
  EXPECT_THAT(feed(decoder, bytes, 4).ids, ElementsAre(1));
  EXPECT_EQ(decoder.held(), 5u);
}

TEST(LlrpFrames, RefuseALengthBelowTheHeader) {
  FrameDecoder decoder;
  EXPECT_THAT(feed(decoder, Bytes{0x04, 62, 0, 0, 0, 9, 0, 0, 0, 1}, 10).errors,
              ElementsAre(FrameError::kTooShort));
}

// The declared length that a real Speedway answered by closing: 0x000CA1E5 (recorded, r420_recorded/README).
TEST(LlrpFrames, RefuseALengthAboveTheLimitAtTheSixthByte) {
  FrameDecoder decoder;
  EXPECT_THAT(feed(decoder, Bytes{0x04, 0x67, 0, 0x0C, 0xA1, 0xE5}, 1).errors,
              ElementsAre(FrameError::kTooLong));
  EXPECT_TRUE(decoder.is_hunting());
}

TEST(LlrpFrames, RefuseReservedBits) {
  FrameDecoder decoder;
  EXPECT_THAT(feed(decoder, Bytes{0x24, 62, 0, 0, 0, 10, 0, 0, 0, 1}, 10).errors,
              ElementsAre(FrameError::kReservedBits));
}

TEST(LlrpFrames, OfTheLargestSizePassWithRoomForNoMore) {
  FrameDecoder decoder{32};
  const Bytes largest = encode(CustomMessage{.vendor = 9, .subtype = 1, .payload = Bytes(17)}, 4);
  ASSERT_EQ(largest.size(), 32u);
  EXPECT_THAT(feed(decoder, largest, 32).ids, ElementsAre(4));
  const Bytes larger = encode(CustomMessage{.vendor = 9, .subtype = 1, .payload = Bytes(18)}, 5);
  EXPECT_THAT(feed(decoder, larger, 32).errors, ElementsAre(FrameError::kTooLong));
}

TEST(LlrpFrames, AreFoundAgainBehindGarbage) {
  RandomStream random{11};
  for (int round = 0; round < 200; ++round) {
    Bytes bytes(1 + random.below(200));
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(0x80 | random.below(128));  // reserved bit set: never a header
    }
    const Bytes good = three_messages();
    bytes.insert(bytes.end(), good.begin(), good.end());
    FrameDecoder decoder;
    const Found found = feed(decoder, bytes, 1 + random.below(50));
    EXPECT_THAT(found.ids, ElementsAre(1, 2, 3));
    EXPECT_THAT(found.errors, ElementsAre(FrameError::kReservedBits)) << "told once, not for each byte";
    EXPECT_EQ(decoder.bytes_skipped(), bytes.size() - good.size());
  }
}

TEST(LlrpFrames, NeverCrashOnAMillionRandomBytes) {
  RandomStream random{12};
  FrameDecoder decoder{4096};
  std::size_t total = 0;
  while (total < 1000000) {
    Bytes bytes(1 + random.below(3000));
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(random.next_u64());
    }
    total += bytes.size();
    static_cast<void>(feed(decoder, bytes, 1 + random.below(700)));
  }
  EXPECT_GT(decoder.bytes_skipped(), 0u);
}

TEST(LlrpFrames, OfALostConnectionAreForgotten) {
  FrameDecoder decoder;
  const Bytes bytes = three_messages();
  static_cast<void>(feed(decoder, ByteView{bytes}.first(15), 15));
  decoder.reset();
  EXPECT_EQ(decoder.held(), 0u);
  EXPECT_THAT(feed(decoder, bytes, 7).ids, ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace sensotwin::robot::llrp
