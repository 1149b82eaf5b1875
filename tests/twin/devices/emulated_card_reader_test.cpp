// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_card_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "card_reader_bench.hpp"

namespace sensotwin::twin {
namespace {

using namespace sensotwin::testing;  // NOLINT(google-build-using-namespace): the transcripts' words
using robot::CardError;
using robot::CardPresence;
using robot::Instant;
using robot::kTick;
using robot::RandomStream;
using world::TagMemory;

class CardReaderInVirtualTime : public CardReaderBench {
 protected:
  /// One whole exchange over `tag`, which stays.
  std::optional<robot::Result<Bytes, CardError>> exchange(const Bytes& command, TagMemory& tag) {
    EXPECT_TRUE(reader_.begin(command));
    step(&tag);
    return reader_.poll();
  }
  void answers(const CardTranscript& transcript, TagMemory& tag) {
    SCOPED_TRACE(transcript.name);
    step(&tag);
    for (const CardExchange& e : transcript.exchanges) {
      const auto answer = exchange(e.command, tag);
      ASSERT_TRUE(answer && *answer);
      EXPECT_EQ(**answer, e.response);
    }
  }
};

TEST_F(CardReaderInVirtualTime, GivesTheAnswersThatTheDriverIsTestedWith) {
  for (const CardTranscript* transcript :
       {&kIdentifyAndRead, &kWriteAndVerify, &kWriteLocked, &kWriteBeyond, &kWriteBlockwise}) {
    TagMemory tag = transcript_tag();
    answers(*transcript, tag);
    step(nullptr);
  }
}

TEST(CardReaderWithLatency, ReportsATagAWhileAfterItCameAndForgetsItAtOnce) {
  EmulatedCardReader reader({.exchange = robot::from_s(0.012), .latency = robot::from_s(0.1)},
                            RandomStream{1});
  TagMemory tag = transcript_tag();
  const auto at = [&](double t_s, TagMemory* in_field) {
    reader.step(Instant{robot::from_s(t_s)}, in_field);
    return static_cast<robot::CardLink&>(reader).presence();
  };
  EXPECT_EQ(at(1.0, nullptr), CardPresence::kEmpty);
  EXPECT_EQ(at(1.015, &tag), CardPresence::kEmpty);
  EXPECT_EQ(at(1.105, &tag), CardPresence::kEmpty);
  EXPECT_FALSE(static_cast<robot::CardLink&>(reader).begin(kSaysItsUid.command));
  EXPECT_EQ(at(1.12, &tag), CardPresence::kPresent);
  EXPECT_TRUE(static_cast<robot::CardLink&>(reader).begin(kSaysItsUid.command));
  EXPECT_EQ(at(1.135, &tag), CardPresence::kPresent);
  EXPECT_EQ(at(1.15, nullptr), CardPresence::kEmpty);
  // One that is gone before it has answered was never there.
  EXPECT_EQ(at(2.0, &tag), CardPresence::kEmpty);
  EXPECT_EQ(at(2.09, nullptr), CardPresence::kEmpty);
  EXPECT_EQ(at(2.12, nullptr), CardPresence::kEmpty);
}

TEST_F(CardReaderInVirtualTime, AnswersOneExchangeLaterAndNotBefore) {
  TagMemory tag = transcript_tag();
  step(&tag);
  ASSERT_TRUE(reader_.begin(kSaysItsUid.command));
  EXPECT_FALSE(reader_.poll());
  EXPECT_FALSE(reader_.begin(kSaysItsUid.command)) << "one at a time";
  step(&tag, std::chrono::milliseconds{11});
  EXPECT_FALSE(reader_.poll());
  step(&tag, std::chrono::milliseconds{1});
  EXPECT_FALSE(reader_.begin(kSaysItsUid.command)) << "the answer has not been fetched";
  EXPECT_TRUE(reader_.poll());
  EXPECT_FALSE(reader_.poll()) << "an answer is given once";
}

TEST_F(CardReaderInVirtualTime, ShowsWhatIsInTheField) {
  TagMemory tag = transcript_tag();
  EXPECT_EQ(reader_.presence(), CardPresence::kEmpty);
  EXPECT_FALSE(reader_.begin(kSaysItsUid.command));
  step(&tag);
  EXPECT_EQ(reader_.presence(), CardPresence::kPresent);
  step(nullptr);
  EXPECT_EQ(reader_.presence(), CardPresence::kEmpty);
}

TEST_F(CardReaderInVirtualTime, ATagInAnothersPlaceShowsAsAnEmptyFieldOnce) {
  TagMemory one = transcript_tag();
  TagMemory other = transcript_tag();
  step(&one);
  step(&other);
  EXPECT_FALSE(reader_.begin(kSaysItsUid.command)) << "meant for the first";
  EXPECT_EQ(reader_.presence(), CardPresence::kEmpty);
  EXPECT_EQ(reader_.presence(), CardPresence::kPresent);
  EXPECT_TRUE(reader_.begin(kSaysItsUid.command));
}

TEST_F(CardReaderInVirtualTime, SaysWhatIsWrongWithACommand) {
  TagMemory tag = transcript_tag();
  step(&tag);
  const auto status = [&](const Bytes& command) {
    const auto answer = exchange(command, tag);
    return static_cast<int>(robot::decode_response(**answer)->status.raw);
  };
  EXPECT_EQ(status({}), 0x6700);
  EXPECT_EQ(status({0x00, 0xA4, 0x04, 0x00, 0x00}), 0x6E00);
  EXPECT_EQ(status({0xFF, 0x20, 0x00, 0x00, 0x00}), 0x6D00);
  EXPECT_EQ(status({0xFF, 0xCA, 0x01, 0x00, 0x00}), 0x6A81);
  EXPECT_EQ(status({0xFF, 0xCA, 0x00, 0x00, 0x04}), 0x6C08);
  EXPECT_EQ(status({0xFF, 0xCA, 0x00, 0x00, 0x0A}), 0x6282);
  EXPECT_EQ(status({0xFF, 0xB0, 0x00, 0x1C, 0x04}), 0x6A82);
  EXPECT_EQ(status({0xFF, 0xB0, 0x00, 0x1B, 0x08}), 0x6282);
  EXPECT_EQ(status({0xFF, 0xB0, 0x00, 0x00, 0x02}), 0x6C04);
  EXPECT_EQ(status({0xFF, 0xB0, 0x00, 0x00, 0x00}), 0x9000);
  EXPECT_EQ(status({0xFF, 0xD6, 0x00, 0x00, 0x03, 1, 2, 3}), 0x6700);
  EXPECT_EQ(status({0xFF, 0xD6, 0x00, 0x08, 0x08, 1, 2, 3, 4, 5, 6, 7, 8}), 0x6986);
  EXPECT_EQ(record_bytes(tag), kOldData);
  EXPECT_EQ(tag.blocks[8], TagMemory::Block{}) << "nothing is written beside a locked block";
}

TEST_F(CardReaderInVirtualTime, AnExchangeEndsAsRemovedWhenTheTagLeavesBeforeItIsDue) {
  TagMemory tag = transcript_tag();
  step(&tag);
  ASSERT_TRUE(reader_.begin(kReadRecord));
  step(&tag, std::chrono::milliseconds{5});
  step(nullptr, std::chrono::milliseconds{5});
  const auto answer = reader_.poll();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->error(), CardError::kRemoved);
}

// A tick is longer than an exchange: left at an instant uniform in 15 ms, 3 of 15 leave after 12 ms.
TEST_F(CardReaderInVirtualTime, AnExchangeIsCompleteInAFifthOfTheTicksInWhichTheTagLeaves) {
  constexpr int kTrials = 20'000;
  int complete = 0;
  for (int i = 0; i < kTrials; ++i) {
    TagMemory tag = transcript_tag();
    step(&tag);
    ASSERT_TRUE(reader_.begin(kReadRecord));
    step(nullptr);
    complete += reader_.poll()->has_value() ? 1 : 0;
  }
  const double p = 0.2;
  EXPECT_NEAR(complete / static_cast<double>(kTrials), p, 4 * std::sqrt(p * (1 - p) / kTrials));
}

// A cut-off write of one block: torn with the stated 0.25, else old or new alike. All 32 bits differ here, so
// that a torn block looks old or new once in 2^31 times.
TEST_F(CardReaderInVirtualTime, ACutOffWriteLeavesTheBlockOldNewOrTornInTheStatedProportion) {
  constexpr int kTrials = 20'000;
  const Bytes update{0xFF, 0xD6, 0, 3, 4, 0xFF, 0xFF, 0xFF, 0xFF};
  const TagMemory::Block old_block{};
  const TagMemory::Block new_block{0xFF, 0xFF, 0xFF, 0xFF};
  int torn = 0;
  int kept = 0;
  for (int i = 0; i < kTrials; ++i) {
    TagMemory tag = transcript_tag();
    step(&tag);
    ASSERT_TRUE(reader_.begin(update));
    step(nullptr, std::chrono::milliseconds{10});
    EXPECT_EQ(reader_.poll()->error(), CardError::kRemoved);
    kept += tag.blocks[3] == old_block ? 1 : 0;
    torn += tag.blocks[3] != old_block && tag.blocks[3] != new_block ? 1 : 0;
  }
  const auto four_sigma = [](double p) { return 4 * std::sqrt(p * (1 - p) / kTrials); };
  EXPECT_NEAR(torn / static_cast<double>(kTrials), 0.25, four_sigma(0.25));
  EXPECT_NEAR(kept / static_cast<double>(kTrials), 0.375, four_sigma(0.375));
}

TEST_F(CardReaderInVirtualTime, OfACutOffWriteOfThreeBlocksTheFirstOnesAreNewAndTheLastOnesOld) {
  for (int i = 0; i < 2'000; ++i) {
    TagMemory tag = transcript_tag();
    const TagMemory before = tag;
    step(&tag);
    ASSERT_TRUE(reader_.begin(kTakesNewData.command));
    step(&tag, std::chrono::milliseconds{5});  // 4 ms a block: the second one is being programmed
    step(nullptr, std::chrono::milliseconds{2});
    EXPECT_EQ(reader_.poll()->error(), CardError::kRemoved);
    const Bytes after = record_bytes(tag);
    EXPECT_TRUE(std::equal(after.begin(), after.begin() + 4, kNewData.begin()));
    EXPECT_EQ(tag.blocks[2], before.blocks[2]);
  }
}

TEST_F(CardReaderInVirtualTime, UnpluggedItHasNoFieldAndTheExchangeIsLost) {
  TagMemory tag = transcript_tag();
  step(&tag);
  ASSERT_TRUE(reader_.begin(kReadRecord));
  reader_.unplug();
  EXPECT_EQ(reader_.presence(), CardPresence::kNoReader);
  const auto answer = reader_.poll();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->error(), CardError::kReaderGone);
  EXPECT_FALSE(reader_.begin(kReadRecord));
  step(&tag);
  reader_.replug();
  EXPECT_EQ(reader_.presence(), CardPresence::kPresent);
  EXPECT_TRUE(reader_.begin(kReadRecord));
}

TEST_F(CardReaderInVirtualTime, ADelayMakesItSlowAndALongOneMakesItTimeOut) {
  TagMemory tag = transcript_tag();
  step(&tag);
  reader_.set_extra_delay(std::chrono::milliseconds{30});
  ASSERT_TRUE(reader_.begin(kReadRecord));
  step(&tag);
  step(&tag);
  EXPECT_FALSE(reader_.poll());
  step(&tag);
  EXPECT_TRUE(reader_.poll());
  reader_.set_extra_delay(std::chrono::seconds{5});
  ASSERT_TRUE(reader_.begin(kReadRecord));
  step(&tag, std::chrono::seconds{1});
  const auto answer = reader_.poll();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->error(), CardError::kTimeout);
}

TEST_F(CardReaderInVirtualTime, UnpluggedInAnExchangeThatTakesNoTimeHasWrittenNothing) {
  EmulatedCardReader instant{CardReaderSettings{}, robot::RandomStream{1}};
  world::TagMemory tag = transcript_tag();
  instant.step(now_, &tag);
  ASSERT_TRUE(instant.begin(robot::encode(robot::UpdateBinary{0, robot::Bytes(4, 0xEE)})));
  instant.unplug();
  EXPECT_EQ(record_bytes(tag), record_bytes(transcript_tag()));
  const auto answer = instant.poll();
  ASSERT_TRUE(answer && !*answer);
  EXPECT_EQ(answer->error(), robot::CardError::kReaderGone);
}

TEST_F(CardReaderInVirtualTime, NeverCrashesOnRandomCommands) {
  RandomStream random{50};
  TagMemory tag = transcript_tag();
  step(&tag);
  for (int i = 0; i < 50'000; ++i) {
    Bytes command(random.below(14));
    for (std::uint8_t& byte : command) {
      byte = static_cast<std::uint8_t>(random.below(256));
    }
    if (command.size() > 4) {
      constexpr std::array<std::uint8_t, 3> kInstructions{0xCA, 0xB0, 0xD6};
      command[0] = 0xFF;
      command[1] = kInstructions[random.below(3)];
      command[2] = random.chance(0.9) ? 0 : command[2];
      command[3] = static_cast<std::uint8_t>(command[3] & 0x1Fu);
    }
    ASSERT_TRUE(reader_.begin(command));
    const bool leaves = random.chance(0.3);
    step(leaves ? nullptr : &tag);
    EXPECT_TRUE(reader_.poll());
    step(&tag);
  }
}

}  // namespace
}  // namespace sensotwin::twin
