// SPDX-License-Identifier: MIT
#include "robot/wire/storage_card.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

using testing::ElementsAre;

constexpr TagUid kUid = 0xE004'0100'1234'56ABu;

Bytes random_bytes(RandomStream& random, std::uint32_t size_max) {
  Bytes bytes(random.below(size_max + 1));
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(random.below(256));
  }
  return bytes;
}

TEST(StorageCardCommand, GetUidIsThePseudoApduOfPcScPartThree) {
  EXPECT_THAT(encode(GetUid{}), ElementsAre(0xFF, 0xCA, 0x00, 0x00, 0x00));
}

TEST(StorageCardCommand, ReadBinaryNamesItsBlockBigEndianInP1P2AndItsLengthInBytes) {
  EXPECT_THAT(encode(ReadBinary{0x0103, 12}), ElementsAre(0xFF, 0xB0, 0x01, 0x03, 0x0C));
}

TEST(StorageCardCommand, UpdateBinaryCarriesItsDataBehindTheirCount) {
  const Bytes data{1, 2, 3, 4};
  EXPECT_THAT(encode(UpdateBinary{2, data}), ElementsAre(0xFF, 0xD6, 0x00, 0x02, 0x04, 1, 2, 3, 4));
}

TEST(StorageCardCommand, EachCommandComesBackFromItsBytes) {
  const Bytes data{9, 8, 7, 6, 5, 4, 3, 2};
  const auto uid = decode_command(encode(GetUid{8}));
  ASSERT_TRUE(uid);
  EXPECT_EQ(std::get<GetUid>(*uid), GetUid{8});
  const auto read = decode_command(encode(ReadBinary{27, 4}));
  ASSERT_TRUE(read);
  EXPECT_EQ(std::get<ReadBinary>(*read), (ReadBinary{27, 4}));
  const Bytes apdu = encode(UpdateBinary{5, data});
  const auto update = decode_command(apdu);
  ASSERT_TRUE(update);
  EXPECT_EQ(std::get<UpdateBinary>(*update).first_block, 5);
  EXPECT_THAT(std::get<UpdateBinary>(*update).data, testing::ElementsAreArray(data));
}

TEST(StorageCardCommand, NamesEachMistake) {
  const auto error = [](const Bytes& apdu) { return decode_command(apdu).error(); };
  EXPECT_EQ(error({}), CommandError::kTooShort);
  EXPECT_EQ(error({0xFF, 0xCA, 0, 0}), CommandError::kTooShort);
  EXPECT_EQ(error({0x00, 0xCA, 0, 0, 0}), CommandError::kUnknownClass);
  EXPECT_EQ(error({0xFF, 0xA4, 0, 0, 0}), CommandError::kUnknownInstruction);
  EXPECT_EQ(error({0xFF, 0xCA, 1, 0, 0}), CommandError::kWrongParameter);
  EXPECT_EQ(error({0xFF, 0xCA, 0, 0, 0, 0}), CommandError::kWrongLength);
  EXPECT_EQ(error({0xFF, 0xB0, 0, 0, 4, 0}), CommandError::kWrongLength);
  EXPECT_EQ(error({0xFF, 0xD6, 0, 0, 0}), CommandError::kWrongLength);
  EXPECT_EQ(error({0xFF, 0xD6, 0, 0, 4, 1, 2, 3}), CommandError::kWrongLength);
  EXPECT_EQ(error({0xFF, 0xD6, 0, 0, 4, 1, 2, 3, 4, 5}), CommandError::kWrongLength);
}

TEST(StorageCardCommand, WhateverDecodesEncodesToTheSameBytesInAHundredThousandRandomOnes) {
  RandomStream random{20150};
  constexpr std::array<std::uint8_t, 4> kInstructions{0xCA, 0xB0, 0xD6, 0x00};
  int understood = 0;
  for (int i = 0; i < 100'000; ++i) {
    Bytes apdu = random_bytes(random, 12);
    if (apdu.size() > 4) {  // otherwise hardly one in 65536 would be a command
      apdu[0] = 0xFF;
      apdu[1] = kInstructions[random.below(4)];
      apdu[4] = static_cast<std::uint8_t>(random.below(9));
    }
    const auto command = decode_command(apdu);
    if (command) {
      ++understood;
      EXPECT_EQ(encode(*command), apdu);
    }
  }
  EXPECT_GT(understood, 1000);
}

TEST(StorageCardStatus, EveryNamedWordIsRecognisedAndWrittenBack) {
  const std::vector<std::pair<std::uint16_t, CardStatus>> words{
      {0x9000, CardStatus::kOk},
      {0x6281, CardStatus::kDataMayBeCorrupt},
      {0x6282, CardStatus::kEndReached},
      {0x6300, CardStatus::kOperationFailed},
      {0x6581, CardStatus::kMemoryFailure},
      {0x6700, CardStatus::kWrongLength},
      {0x6800, CardStatus::kClassNotSupported},
      {0x6981, CardStatus::kCommandIncompatible},
      {0x6982, CardStatus::kSecurityNotSatisfied},
      {0x6986, CardStatus::kCommandNotAllowed},
      {0x6A81, CardStatus::kFunctionNotSupported},
      {0x6A82, CardStatus::kBlockNotFound},
      {0x6B00, CardStatus::kWrongAddress},
      {0x6D00, CardStatus::kInstructionNotSupported},
      {0x6E00, CardStatus::kClassUnknown},
      {0x6F00, CardStatus::kNoDiagnosis},
  };
  for (const auto& [raw, status] : words) {
    EXPECT_EQ(StatusWord{raw}.meaning(), status) << std::hex << raw;
    EXPECT_EQ(status_word(status).raw, raw);
    EXPECT_NE(to_text(status), to_text(CardStatus::kUnknown));
  }
}

TEST(StorageCardStatus, AWrongExpectedLengthSaysTheRightOne) {
  EXPECT_EQ(StatusWord{0x6C08}.meaning(), CardStatus::kWrongExpectedLength);
  EXPECT_EQ(StatusWord{0x6C08}.exact_length(), 8);
  EXPECT_EQ(wrong_expected_length(8).raw, 0x6C08);
}

TEST(StorageCardStatus, OtherWordsAreUnknownAndKept) {
  EXPECT_EQ(StatusWord{0x6283}.meaning(), CardStatus::kUnknown);
  EXPECT_EQ(StatusWord{0x9001}.meaning(), CardStatus::kUnknown);
  EXPECT_FALSE(StatusWord{0x9001}.ok());
}

TEST(StorageCardResponse, EndsInItsStatusWord) {
  const Bytes apdu{0xAA, 0xBB, 0x62, 0x82};
  const auto response = decode_response(apdu);
  ASSERT_TRUE(response);
  EXPECT_THAT(response->data, ElementsAre(0xAA, 0xBB));
  EXPECT_EQ(response->status.meaning(), CardStatus::kEndReached);
  EXPECT_EQ(encode(*response), apdu);
}

TEST(StorageCardResponse, WithoutRoomForAStatusWordIsTooShort) {
  EXPECT_EQ(decode_response(Bytes{0x90}).error(), ResponseError::kTooShort);
  EXPECT_EQ(decode_response(Bytes{}).error(), ResponseError::kTooShort);
}

TEST(StorageCardUid, ComesInEitherOrderByTheReadersSetting) {
  EXPECT_THAT(encode_uid(kUid, UidOrder::kMsbFirst),
              ElementsAre(0xE0, 0x04, 0x01, 0x00, 0x12, 0x34, 0x56, 0xAB));
  EXPECT_THAT(encode_uid(kUid, UidOrder::kLsbFirst),
              ElementsAre(0xAB, 0x56, 0x34, 0x12, 0x00, 0x01, 0x04, 0xE0));
  for (const UidOrder order : {UidOrder::kMsbFirst, UidOrder::kLsbFirst}) {
    EXPECT_EQ(*decode_uid(encode_uid(kUid, order), order), kUid);
  }
}

TEST(StorageCardUid, AWrongSettingIsReportedAsReversed) {
  EXPECT_EQ(decode_uid(encode_uid(kUid, UidOrder::kLsbFirst), UidOrder::kMsbFirst).error(),
            UidError::kReversed);
  EXPECT_EQ(decode_uid(encode_uid(kUid, UidOrder::kMsbFirst), UidOrder::kLsbFirst).error(),
            UidError::kReversed);
}

TEST(StorageCardUid, WithE0AtBothEndsIsTakenByTheSetting) {
  constexpr TagUid kBothEnds = 0xE004'0100'0000'00E0u;
  EXPECT_EQ(*decode_uid(encode_uid(kBothEnds, UidOrder::kLsbFirst), UidOrder::kLsbFirst), kBothEnds);
}

TEST(StorageCardUid, OfAnotherKindOfCardIsRefused) {
  EXPECT_EQ(decode_uid(Bytes{0x04, 1, 2, 3, 4, 5, 6}, UidOrder::kMsbFirst).error(), UidError::kWrongLength);
  EXPECT_EQ(decode_uid(Bytes{4, 1, 2, 3, 4, 5, 6, 7}, UidOrder::kMsbFirst).error(), UidError::kNotIso15693);
}

}  // namespace
}  // namespace sensotwin::robot
