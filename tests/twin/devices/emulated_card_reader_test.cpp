// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_card_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/drivers/tag_reader.hpp"
#include "robot/wire/tag_record.hpp"
#include "tests/robot/drivers/card_transcript.hpp"

namespace sensotwin::twin {
namespace {

using namespace sensotwin::testing;  // NOLINT(google-build-using-namespace): the transcripts' words
using robot::ByteView;
using robot::CardError;
using robot::CardPresence;
using robot::Duration;
using robot::from_s;
using robot::Instant;
using robot::kTick;
using robot::RandomStream;
using world::TagMemory;

const CardReaderSettings kSettings = card_reader_settings({});

TagMemory transcript_tag() {
  TagMemory tag;
  tag.uid = kTranscriptUid;
  for (std::size_t i = 0; i < kOldData.size(); ++i) {
    tag.blocks[i / 4][i % 4] = kOldData[i];
  }
  tag.locked.set(9);
  return tag;
}
Bytes record_bytes(const TagMemory& tag) {
  return joined({Bytes(tag.blocks[0].begin(), tag.blocks[0].end()),
                 Bytes(tag.blocks[1].begin(), tag.blocks[1].end()),
                 Bytes(tag.blocks[2].begin(), tag.blocks[2].end())});
}

class CardReaderInVirtualTime : public ::testing::Test {
 protected:
  void step(TagMemory* tag, Duration dt = kTick) {
    now_ += dt;
    reader_.step(now_, tag);
  }
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

  EmulatedCardReader reader_{kSettings, RandomStream{1}};
  Instant now_{};
};

TEST_F(CardReaderInVirtualTime, GivesTheAnswersThatTheDriverIsTestedWith) {
  for (const CardTranscript* transcript :
       {&kIdentifyAndRead, &kWriteAndVerify, &kWriteLocked, &kWriteBeyond, &kWriteBlockwise}) {
    TagMemory tag = transcript_tag();
    answers(*transcript, tag);
    step(nullptr);
  }
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

/// The driver of the machine on the emulated reader.
class TagReaderOnEmulator : public CardReaderInVirtualTime {
 protected:
  void tick(TagMemory* tag) {
    step(tag);
    driver_.step(now_);
  }
  std::optional<robot::WriteOutcome> outcome() {
    std::optional<robot::WriteOutcome> found;
    while (const auto event = driver_.next_event()) {
      if (const auto* o = std::get_if<robot::WriteOutcome>(&*event)) {
        found = *o;
      }
    }
    return found;
  }
  robot::TagReader driver_{reader_};
};

TEST_F(TagReaderOnEmulator, IdentifiesInOneTickReadsInTwoAndWritesInFour) {
  TagMemory tag = transcript_tag();
  tick(&tag);  // seen, asked
  tick(&tag);
  ASSERT_TRUE(driver_.tag());
  tick(&tag);
  EXPECT_EQ(driver_.tag()->data, kOldData);
  ASSERT_TRUE(driver_.write(kTranscriptUid, 0, kNewData));
  for (int i = 0; i < 5; ++i) {  // one to begin it
    tick(&tag);
  }
  const auto done = outcome();
  ASSERT_TRUE(done && done->result);
  EXPECT_EQ(record_bytes(tag), kNewData);
}

TEST_F(TagReaderOnEmulator, FindsOnTheNextVisitWhatACutOffWriteHasTornAndRepairsIt) {
  int torn = 0;
  for (int visit = 0; visit < 200; ++visit) {
    TagMemory tag;
    tag.uid = kTranscriptUid;
    for (int i = 0; i < 3; ++i) {
      tick(&tag);
    }
    ASSERT_TRUE(driver_.write(kTranscriptUid, 0, kNewData));
    tick(&tag);
    tick(&tag);  // UPDATE BINARY is on its way
    tick(nullptr);
    const auto cut = outcome();
    ASSERT_TRUE(cut && !cut->result);
    EXPECT_EQ(cut->result.error().failure, robot::WriteFailure::kTagLeft);
    for (int i = 0; i < 3; ++i) {
      tick(&tag);
    }
    ASSERT_TRUE(driver_.tag() && driver_.tag()->data);
    const auto found = robot::decode_tag_record(*driver_.tag()->data);
    if (!found) {
      torn += found.error() != robot::TagRecordError::kBlank ? 1 : 0;
      ASSERT_TRUE(driver_.write(kTranscriptUid, 0, kNewData));
      for (int i = 0; i < 5; ++i) {
        tick(&tag);
      }
      const auto repaired = outcome();
      ASSERT_TRUE(repaired && repaired->result);
    }
    EXPECT_EQ(record_bytes(tag), kNewData);
    tick(nullptr);
    outcome();
  }
  EXPECT_GT(torn, 20) << "the test is about something";
}

// Tags change under the antenna at random moments while writes are asked for: no tag ever gets another's
// record.
TEST_F(TagReaderOnEmulator, NeverWritesATagWithAnothersData) {
  RandomStream random{5};
  std::array<TagMemory, 3> tags{};
  for (std::size_t i = 0; i < tags.size(); ++i) {
    tags[i].uid = world::icode_sli_uid(i);
  }
  TagMemory* field = nullptr;
  int written = 0;
  for (int i = 0; i < 100'000; ++i) {
    if (random.chance(0.15)) {
      const std::uint32_t k = random.below(4);
      field = k == 3 ? nullptr : &tags[k];
    }
    tick(field);
    if (driver_.tag() && !driver_.writing()) {
      const auto serial = static_cast<std::int16_t>(driver_.tag()->uid & 0xFFu);
      (void)driver_.write(driver_.tag()->uid, 0, robot::encode(robot::CarpetRecord{7, serial, serial}));
    }
    if (const auto done = outcome()) {
      written += done->result ? 1 : 0;
    }
    for (std::size_t k = 0; k < tags.size(); ++k) {
      const auto record = robot::decode_tag_record(record_bytes(tags[k]));
      if (record) {
        ASSERT_EQ(std::get<robot::CarpetRecord>(*record).column, static_cast<int>(k));
      }
    }
  }
  EXPECT_GT(written, 1000);
}

TEST_F(TagReaderOnEmulator, ComesBackAfterTheReaderWasUnplugged) {
  TagMemory tag = transcript_tag();
  for (int i = 0; i < 3; ++i) {
    tick(&tag);
  }
  ASSERT_TRUE(driver_.write(kTranscriptUid, 3, kNewData));
  tick(&tag);
  reader_.unplug();
  tick(&tag);
  const auto lost = outcome();
  ASSERT_TRUE(lost && !lost->result);
  EXPECT_EQ(lost->result.error().failure, robot::WriteFailure::kReaderGone);
  EXPECT_FALSE(driver_.tag());
  reader_.replug();
  for (int i = 0; i < 3; ++i) {
    tick(&tag);
  }
  ASSERT_TRUE(driver_.tag());
  EXPECT_EQ(driver_.health().vanished, 1u);
  EXPECT_EQ(driver_.health().returned, 1u);
}

TEST_F(TagReaderOnEmulator, TwoEqualRunsAreEqual) {
  const auto run = [] {
    EmulatedCardReader reader{kSettings, RandomStream{3}};
    RandomStream random{4};
    TagMemory tag;
    tag.uid = kTranscriptUid;
    Instant now{};
    for (int i = 0; i < 2'000; ++i) {
      now += kTick;
      reader.step(now, random.chance(0.7) ? &tag : nullptr);
      (void)reader.poll();
      (void)reader.begin(kTakesNewData.command);
    }
    return tag.blocks;
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace sensotwin::twin
