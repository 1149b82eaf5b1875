// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "robot/base/random.hpp"
#include "robot/journal/journal_reader.hpp"
#include "robot/journal/journal_writer.hpp"
#include "robot/journal/recording_links.hpp"
#include "robot/journal/replay.hpp"

namespace sensotwin::robot {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

Instant at(int ms) {
  return Instant{milliseconds{ms}};
}

/// Keeps what a writer gives.
struct Kept {
  Bytes bytes;
  JournalWriter writer{[this](ByteView more) {
                         bytes.insert(bytes.end(), more.begin(), more.end());
                         return true;
                       },
                       "version: 1\n"};
};

/// Says what it is told to say; hears everything.
class FakeWire : public ByteLink {
 public:
  std::deque<Bytes> says;
  bool up{true};

 private:
  bool do_write(ByteView) override { return up; }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    if (says.empty()) {
      return 0;
    }
    const Bytes bytes = says.front();
    says.pop_front();
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  [[nodiscard]] bool do_is_up() const override { return up; }
};

class FakeCard : public CardLink {
 public:
  CardPresence presence_now{CardPresence::kEmpty};
  std::optional<Result<Bytes, CardError>> answer;

 private:
  CardPresence do_presence() override { return presence_now; }
  bool do_begin(ByteView) override { return presence_now == CardPresence::kPresent; }
  std::optional<Result<Bytes, CardError>> do_poll() override { return std::exchange(answer, std::nullopt); }
};

/// A small program: it says back, plus one, what the base says, and asks each tag's name.
class Echo {
 public:
  Echo(ByteLink& base, CardLink& card, std::uint8_t more = 1) : base_(base), card_(card), more_(more) {}
  void step() {
    (void)card_.poll();
    if (card_.presence() == CardPresence::kPresent) {
      (void)card_.begin(Bytes{0xFF, 0xCA});
    }
    if (!base_.is_up()) {
      return;
    }
    Bytes heard(16);
    heard.resize(base_.read(heard));
    for (std::uint8_t& byte : heard) {
      byte = static_cast<std::uint8_t>(byte + more_);
    }
    if (!heard.empty()) {
      (void)base_.write(heard);
    }
  }
  void shut_down() { (void)base_.write(Bytes{173}); }

 private:
  ByteLink& base_;
  CardLink& card_;
  std::uint8_t more_;
};

/// A run of three steps and an end: the base speaks, a tag comes, answers and goes, the base goes.
Bytes recorded_run() {
  Kept kept;
  FakeWire wire;
  FakeCard field;
  RecordingByteLink base(wire, kept.writer, Wire::kBase);
  RecordingCardLink card(field, kept.writer, Wire::kFloorReader);
  Echo program(base, card);
  wire.says = {Bytes{1, 2}};
  program.step();
  kept.writer.end_step(at(15));
  field.presence_now = CardPresence::kPresent;
  program.step();
  kept.writer.end_step(at(31));
  field.answer = Result<Bytes, CardError>{Unexpected{CardError::kRemoved}};
  field.presence_now = CardPresence::kEmpty;
  wire.says = {Bytes{9}};
  program.step();
  kept.writer.end_step(at(45));
  wire.up = false;
  program.step();
  kept.writer.end_step(at(60));
  program.shut_down();
  kept.writer.end_run(at(75));
  return kept.bytes;
}

ReplayOutcome replayed(const Journal& journal, std::uint8_t more = 1) {
  ReplayWires wires;
  Echo program(wires.bytes(Wire::kBase), wires.cards(Wire::kFloorReader), more);
  return wires.run(
      journal, [&](Instant) { program.step(); }, [&] { program.shut_down(); });
}

TEST(Journal, ReadsBackWhatWasWrittenInItsOrderWithItsTimes) {
  const auto journal = read_journal(recorded_run());
  ASSERT_TRUE(journal);
  EXPECT_EQ(journal->robot_file, "version: 1\n");
  EXPECT_EQ(journal->bytes_torn, 0u);
  ASSERT_THAT(journal->blocks, SizeIs(5));
  EXPECT_EQ(journal->blocks[1].at, at(31));
  EXPECT_FALSE(journal->blocks[3].end);
  EXPECT_TRUE(journal->blocks[4].end);
  const auto words = [&](std::size_t block) {
    std::vector<std::string> texts;
    for (const WireRecord& record : journal->blocks[block].records) {
      texts.push_back(text_of(record));
    }
    return texts;
  };
  EXPECT_THAT(words(0),
              ElementsAre("floor reader: field empty", "base: is up", "base: read 1 2", "base: written 2 3"));
  EXPECT_THAT(words(1), ElementsAre("floor reader: tag there", "floor reader: command 255 202"));
  EXPECT_THAT(words(2), ElementsAre("floor reader: tag removed", "floor reader: field empty", "base: read 9",
                                    "base: written 10"));
  EXPECT_THAT(words(3), ElementsAre("base: is down"));
  EXPECT_THAT(words(4), ElementsAre("base: write refused 173"));
}

TEST(Journal, IsGoodUpToTheLastWholeBlockWhereverItIsCutOff) {
  const Bytes whole = recorded_run();
  const std::size_t head = kJournalMagic.size() + 1 + std::string{"version: 1\n"}.size();
  std::size_t last = 0;
  for (std::size_t size = head; size <= whole.size(); ++size) {
    const auto journal = read_journal(ByteView{whole}.first(size));
    ASSERT_TRUE(journal) << size;
    EXPECT_GE(journal->blocks.size(), last);
    last = journal->blocks.size();
    EXPECT_LT(journal->bytes_torn, 40u);
    EXPECT_FALSE(replayed(*journal).difference) << size;
  }
  EXPECT_EQ(last, 5u);
}

TEST(Journal, IsNoneWhenItsHeadIsTornOrAnothers) {
  const Bytes whole = recorded_run();
  EXPECT_FALSE(read_journal(ByteView{whole}.first(25)));
  EXPECT_FALSE(read_journal({}));
  EXPECT_FALSE(read_journal(Bytes(100, 'x')));
}

TEST(Journal, NeverTakesAFlippedBitForABlock) {
  const Bytes whole = recorded_run();
  const auto good = read_journal(whole);
  const std::size_t head = kJournalMagic.size() + 1 + std::string{"version: 1\n"}.size();
  for (std::size_t i = head; i < whole.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes spoilt = whole;
      spoilt[i] = static_cast<std::uint8_t>(spoilt[i] ^ (1u << bit));
      const auto journal = read_journal(spoilt);
      ASSERT_TRUE(journal);
      for (std::size_t block = 0; block < journal->blocks.size(); ++block) {
        // 'T' is four bits from 'E': the kind alone is not under the check.
        ASSERT_EQ(journal->blocks[block].records, good->blocks[block].records) << i << " bit " << bit;
      }
    }
  }
}

// Found by the fuzzer: its writer takes the difference to the block before for a number without a sign.
TEST(Journal, EndsBeforeABlockWhoseTimeGoesBack) {
  Kept kept;
  kept.writer.end_step(at(30));
  kept.writer.end_step(at(15));
  kept.writer.end_step(at(45));
  const auto journal = read_journal(kept.bytes);
  ASSERT_TRUE(journal);
  ASSERT_THAT(journal->blocks, SizeIs(1));
  EXPECT_EQ(journal->blocks[0].at, at(30));
  EXPECT_GT(journal->bytes_torn, 0u);
}

TEST(Journal, SurvivesRandomBytes) {
  RandomStream random(11);
  Bytes noise(kJournalMagic.begin(), kJournalMagic.end());
  for (int i = 0; i < 200000; ++i) {
    noise.push_back(static_cast<std::uint8_t>(random.uniform() * 256.0));
  }
  const auto journal = read_journal(noise);
  EXPECT_TRUE(!journal || journal->blocks.empty());
}

TEST(JournalWriter, StopsAtTheFirstFailureOfItsSinkAndSaysSo) {
  int given = 0;
  JournalWriter writer([&](ByteView) { return ++given < 2; }, "");
  writer.end_step(at(15));
  writer.end_step(at(30));
  writer.end_step(at(45));
  EXPECT_TRUE(writer.failed());
  EXPECT_EQ(given, 2);
}

TEST(Replay, FindsTheSameProgramSayingTheSame) {
  const ReplayOutcome outcome = replayed(*read_journal(recorded_run()));
  EXPECT_FALSE(outcome.difference);
  EXPECT_EQ(outcome.steps, 4u);
  EXPECT_EQ(outcome.bytes_compared, 2u + 2u + 1u + 1u);
}

TEST(Replay, ReportsTheFirstByteThatDiffersAndWhen) {
  const ReplayOutcome outcome = replayed(*read_journal(recorded_run()), 2);
  ASSERT_TRUE(outcome.difference);
  EXPECT_EQ(outcome.difference->at, at(15));
  EXPECT_EQ(outcome.difference->recorded, "base: written 2 3");
  EXPECT_EQ(outcome.difference->replayed, "base: written 3 4");
}

TEST(Replay, ReportsACommandThatIsMissing) {
  const auto journal = *read_journal(recorded_run());
  ReplayWires wires;
  const ReplayOutcome outcome = wires.run(
      journal,
      [&](Instant) {
        (void)wires.cards(Wire::kFloorReader).presence();
        (void)wires.bytes(Wire::kBase).is_up();
        Bytes heard(16);
        (void)wires.bytes(Wire::kBase).read(heard);
      },
      [] {});
  ASSERT_TRUE(outcome.difference);
  EXPECT_EQ(outcome.difference->recorded, "base: written 2 3");
  EXPECT_EQ(outcome.difference->replayed, "base: nothing");
}

TEST(Replay, ReportsACommandThatWasNotThere) {
  const auto journal = *read_journal(recorded_run());
  ReplayWires wires;
  Echo program(wires.bytes(Wire::kBase), wires.cards(Wire::kFloorReader));
  const ReplayOutcome outcome = wires.run(
      journal,
      [&](Instant) {
        program.step();
        (void)wires.bytes(Wire::kSensors).write(Bytes{5});
      },
      [] {});
  ASSERT_TRUE(outcome.difference);
  EXPECT_THAT(outcome.difference->recorded, HasSubstr("sensors: nothing"));
  EXPECT_EQ(outcome.difference->replayed, "sensors: written 5");
}

}  // namespace
}  // namespace sensotwin::robot
