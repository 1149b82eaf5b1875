// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "card_reader_bench.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/wire/tag_record.hpp"

namespace sensotwin::twin {
namespace {

using namespace sensotwin::testing;  // NOLINT(google-build-using-namespace): the transcripts' words
using robot::Instant;
using robot::kTick;
using robot::RandomStream;
using world::TagMemory;

/// The driver of the machine on the emulated reader.
class TagReaderOnEmulator : public CardReaderBench {
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
    EmulatedCardReader reader{card_reader_settings({}), RandomStream{3}};
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
