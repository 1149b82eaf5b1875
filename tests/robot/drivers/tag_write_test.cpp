// SPDX-License-Identifier: MIT
#include "robot/drivers/tag_write.hpp"

#include <gtest/gtest.h>

#include "tests/robot/drivers/card_transcript.hpp"

namespace sensotwin::robot {
namespace {

using namespace sensotwin::testing;  // NOLINT(google-build-using-namespace): the transcripts' words

TagWrite::Job job_of(std::uint8_t first_block, std::size_t bytes) {
  return {.uid = kTranscriptUid,
          .first_block = first_block,
          .data = Bytes(kNewData.begin(), kNewData.begin() + static_cast<std::ptrdiff_t>(bytes))};
}
/// Says the next command, checks it, answers.
void exchange(TagWrite& write, const CardExchange& expected) {
  ASSERT_FALSE(write.outcome());
  EXPECT_EQ(encode(write.command()), expected.command);
  write.answered(*decode_response(expected.response));
}
void run(TagWrite& write, const CardTranscript& transcript) {
  SCOPED_TRACE(transcript.name);
  for (const CardExchange& e : transcript.exchanges) {
    exchange(write, e);
  }
}
const CardExchange kStrangerSaysItsUid{kSaysItsUid.command, {0xE0, 4, 1, 0, 0, 0, 0, 0x2B, 0x90, 0x00}};
const CardExchange kGivesTornData{kReadRecord,
                                  {0x58, 0x01, 0x20, 0x26, 0x00, 0x01, 0x80, 0x02, 0, 0, 0, 0, 0x90, 0x00}};

TEST(TagWrite, IdentifiesWritesReadsBackAndIdentifiesAgain) {
  TagWrite write{job_of(0, 12)};
  run(write, kWriteAndVerify);
  ASSERT_TRUE(write.outcome() && *write.outcome());
  EXPECT_EQ((**write.outcome()).attempts, 1);
}

TEST(TagWrite, MakesSureOfTheTagBeforeEachPiece) {
  TagWrite::Job job = job_of(3, 8);
  job.blocks_per_command = 1;
  TagWrite write{std::move(job)};
  run(write, kWriteBlockwise);
  ASSERT_TRUE(write.outcome() && *write.outcome());
}

TEST(TagWrite, NeverWritesToAStranger) {
  TagWrite write{job_of(0, 12)};
  exchange(write, kStrangerSaysItsUid);
  ASSERT_TRUE(write.outcome());
  EXPECT_EQ(write.outcome()->error(), (WriteError{WriteFailure::kTagLeft, {}}));
}

TEST(TagWrite, ThatAStrangerConfirmsIsNotDone) {
  TagWrite write{job_of(0, 12)};
  exchange(write, kSaysItsUid);
  exchange(write, kTakesNewData);
  exchange(write, kGivesNewData);
  exchange(write, kStrangerSaysItsUid);
  ASSERT_TRUE(write.outcome());
  EXPECT_EQ(write.outcome()->error().failure, WriteFailure::kTagLeft);
}

TEST(TagWrite, RepeatsAfterATornBlock) {
  TagWrite write{job_of(0, 12)};
  exchange(write, kSaysItsUid);
  exchange(write, kTakesNewData);
  exchange(write, kGivesTornData);
  run(write, kWriteAndVerify);
  ASSERT_TRUE(write.outcome() && *write.outcome());
  EXPECT_EQ((**write.outcome()).attempts, 2);
}

TEST(TagWrite, GivesUpWhenTheLastAttemptDoesNotHold) {
  TagWrite write{job_of(0, 12)};
  for (int attempt = 0; attempt < 3; ++attempt) {
    exchange(write, kSaysItsUid);
    exchange(write, kTakesNewData);
    exchange(write, kGivesOldData);
  }
  ASSERT_TRUE(write.outcome());
  EXPECT_EQ(write.outcome()->error().failure, WriteFailure::kVerifyFailed);
}

TEST(TagWrite, PassesOnTheWordOfARefusalAtOnce) {
  TagWrite locked{job_of(9, 4)};
  run(locked, kWriteLocked);
  EXPECT_EQ(locked.outcome()->error(), (WriteError{WriteFailure::kRefused, {0x6986}}));
  TagWrite beyond{job_of(28, 4)};
  run(beyond, kWriteBeyond);
  EXPECT_EQ(beyond.outcome()->error(), (WriteError{WriteFailure::kRefused, {0x6A82}}));
}

TEST(TagWrite, TriesAgainAfterAMemoryFailure) {
  TagWrite write{job_of(0, 12)};
  exchange(write, kSaysItsUid);
  exchange(write, {kTakesNewData.command, {0x65, 0x81}});
  run(write, kWriteAndVerify);
  EXPECT_TRUE(write.outcome() && *write.outcome());
}

TEST(TagWrite, AMemoryFailureInEachAttemptIsARefusal) {
  TagWrite write{job_of(0, 12)};
  for (int attempt = 0; attempt < 3; ++attempt) {
    exchange(write, kSaysItsUid);
    exchange(write, {kTakesNewData.command, {0x65, 0x81}});
  }
  ASSERT_TRUE(write.outcome());
  EXPECT_EQ(write.outcome()->error(), (WriteError{WriteFailure::kRefused, {0x6581}}));
}

TEST(TagWrite, TriesAgainAfterATimeoutAndSaysSoAtLast) {
  TagWrite write{job_of(0, 12)};
  write.failed(CardError::kTimeout);
  write.failed(CardError::kTimeout);
  EXPECT_FALSE(write.outcome());
  write.failed(CardError::kTimeout);
  EXPECT_EQ(write.outcome()->error().failure, WriteFailure::kTimeout);
}

TEST(TagWrite, EndsWhenTagOrReaderAreGone) {
  TagWrite left{job_of(0, 12)};
  left.failed(CardError::kRemoved);
  EXPECT_EQ(left.outcome()->error().failure, WriteFailure::kTagLeft);
  TagWrite gone{job_of(0, 12)};
  gone.failed(CardError::kReaderGone);
  EXPECT_EQ(gone.outcome()->error().failure, WriteFailure::kReaderGone);
}

}  // namespace
}  // namespace sensotwin::robot
