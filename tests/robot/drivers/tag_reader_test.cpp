// SPDX-License-Identifier: MIT
#include "robot/drivers/tag_reader.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "robot/base/random.hpp"
#include "tests/robot/drivers/card_transcript.hpp"

namespace sensotwin::robot {
namespace {

using namespace sensotwin::testing;  // NOLINT(google-build-using-namespace): the transcripts' words

/// A reader that plays its part of a transcript: each command has to be the next one; the answer comes at the
/// next poll, or not while `silent`.
class ScriptedCard final : public CardLink {
 public:
  void expects(const CardTranscript& t) {
    script_.insert(script_.end(), t.exchanges.begin(), t.exchanges.end());
  }
  void expects(const CardExchange& e) { script_.push_back(e); }
  [[nodiscard]] bool done() const { return script_.empty(); }
  /// The exchange under way ends so instead.
  void fail_with(CardError error) { answer_ = Unexpected{error}; }

  CardPresence field{CardPresence::kEmpty};
  bool silent{false};

 private:
  CardPresence do_presence() override { return field; }
  bool do_begin(ByteView command) override {
    if (field != CardPresence::kPresent || answer_) {
      return false;
    }
    EXPECT_FALSE(script_.empty()) << "a command too many";
    if (script_.empty()) {
      return false;
    }
    EXPECT_EQ(Bytes(command.begin(), command.end()), script_.front().command);
    answer_ = script_.front().response;
    script_.pop_front();
    return true;
  }
  std::optional<Result<Bytes, CardError>> do_poll() override {
    if (silent) {
      return std::nullopt;
    }
    return std::exchange(answer_, std::nullopt);
  }

  std::deque<CardExchange> script_;
  std::optional<Result<Bytes, CardError>> answer_;
};

class TagReaderOnScript : public ::testing::Test {
 protected:
  void steps(int n) {
    for (int i = 0; i < n; ++i) {
      now_ += kTick;
      reader_.step(now_);
    }
  }
  /// The next event, which has to be of this kind.
  template <class E>
  E event() {
    const std::optional<TagEvent> next = reader_.next_event();
    const E* wanted = next ? std::get_if<E>(&*next) : nullptr;
    EXPECT_NE(wanted, nullptr) << "event of another kind: " << (next ? static_cast<int>(next->index()) : -1);
    return wanted == nullptr ? E{} : *wanted;
  }
  /// A tag in the field, identified and read, its events fetched.
  void enter() {
    card_.expects(kIdentifyAndRead);
    card_.field = CardPresence::kPresent;
    steps(3);
    ASSERT_TRUE(reader_.tag());
    event<TagEntered>();
    event<TagIdentified>();
    event<TagDataRead>();
  }

  ScriptedCard card_;
  TagReader reader_{card_};
  Instant now_{};
};

TEST_F(TagReaderOnScript, IdentifiesAndReadsWhatComesIntoTheField) {
  steps(2);
  EXPECT_FALSE(reader_.tag());
  card_.expects(kIdentifyAndRead);
  card_.field = CardPresence::kPresent;
  steps(1);
  const Instant seen = now_;
  steps(2);
  ASSERT_TRUE(reader_.tag());
  EXPECT_EQ(reader_.tag()->uid, kTranscriptUid);
  EXPECT_EQ(reader_.tag()->entered, seen);
  EXPECT_EQ(reader_.tag()->data, kOldData);
  EXPECT_EQ(event<TagEntered>().stamp, seen);
  const auto identified = event<TagIdentified>();
  EXPECT_EQ(identified.uid, kTranscriptUid);
  EXPECT_EQ(identified.stamp, seen + kTick);
  EXPECT_TRUE(event<TagDataRead>().status.ok());
  EXPECT_FALSE(reader_.next_event());
  EXPECT_TRUE(card_.done());
  steps(10);  // and says nothing more
}

TEST_F(TagReaderOnScript, SaysWhoLeft) {
  enter();
  card_.field = CardPresence::kEmpty;
  steps(1);
  EXPECT_FALSE(reader_.tag());
  EXPECT_EQ(event<TagLeft>().uid, kTranscriptUid);
}

TEST_F(TagReaderOnScript, ATagThatLeavesBeforeItSaidItsUidLeavesWithoutOne) {
  card_.expects(kSaysItsUid);
  card_.field = CardPresence::kPresent;
  steps(1);
  card_.fail_with(CardError::kRemoved);
  card_.field = CardPresence::kEmpty;
  steps(1);
  event<TagEntered>();
  EXPECT_FALSE(event<TagLeft>().uid);
  EXPECT_EQ(reader_.health().removed, 1u);
  EXPECT_FALSE(reader_.next_event());
}

TEST_F(TagReaderOnScript, WritesVerifiesAndRenewsItsCopyOfTheData) {
  enter();
  card_.expects(kWriteAndVerify);
  ASSERT_TRUE(reader_.write(kTranscriptUid, 0, kNewData));
  EXPECT_FALSE(reader_.write(kTranscriptUid, 0, kNewData)) << "one at a time";
  steps(5);
  const auto outcome = event<WriteOutcome>();
  EXPECT_TRUE(outcome.result.has_value());
  EXPECT_EQ(outcome.uid, kTranscriptUid);
  EXPECT_EQ(outcome.first_block, 0);
  EXPECT_EQ(reader_.tag()->data, kNewData);
  EXPECT_FALSE(reader_.writing());
  EXPECT_TRUE(card_.done());
}

TEST_F(TagReaderOnScript, WillNotWriteToATagThatIsNotInTheField) {
  EXPECT_FALSE(reader_.write(kTranscriptUid, 0, kNewData));
  enter();
  EXPECT_FALSE(reader_.write(kTranscriptUid + 1, 0, kNewData));
}

TEST_F(TagReaderOnScript, ReportsATagThatLeavesInMidWriteOnceAndForgetsIt) {
  enter();
  card_.expects(kSaysItsUid);
  card_.expects(kTakesNewData);
  ASSERT_TRUE(reader_.write(kTranscriptUid, 0, kNewData));
  steps(2);
  card_.fail_with(CardError::kRemoved);
  card_.field = CardPresence::kEmpty;
  steps(1);
  EXPECT_EQ(event<WriteOutcome>().result.error().failure, WriteFailure::kTagLeft);
  EXPECT_EQ(event<TagLeft>().uid, kTranscriptUid);
  EXPECT_FALSE(reader_.next_event());
  EXPECT_FALSE(reader_.writing());
}

TEST_F(TagReaderOnScript, ATagThatLeavesBetweenTwoExchangesOfAWriteIsReportedOnce) {
  enter();
  ASSERT_TRUE(reader_.write(kTranscriptUid, 0, kNewData));
  card_.field = CardPresence::kEmpty;
  steps(1);
  EXPECT_EQ(event<WriteOutcome>().result.error().failure, WriteFailure::kTagLeft);
  EXPECT_EQ(event<TagLeft>().uid, kTranscriptUid);
  EXPECT_FALSE(reader_.next_event());
}

TEST_F(TagReaderOnScript, AStrangerInMidWriteIsNotWrittenButMadeAcquaintanceWith) {
  enter();
  const CardExchange stranger{kSaysItsUid.command, {0xE0, 4, 1, 0, 0, 0, 0, 0x2B, 0x90, 0x00}};
  card_.expects(stranger);  // the check before the write
  card_.expects(stranger);  // and as a new tag
  card_.expects(kGivesOldData);
  ASSERT_TRUE(reader_.write(kTranscriptUid, 0, kNewData));
  steps(4);
  EXPECT_EQ(event<WriteOutcome>().result.error().failure, WriteFailure::kTagLeft);
  EXPECT_EQ(event<TagLeft>().uid, kTranscriptUid);
  event<TagEntered>();
  EXPECT_EQ(event<TagIdentified>().uid, kTranscriptUid + 1);
  ASSERT_TRUE(reader_.tag());
  EXPECT_EQ(reader_.tag()->uid, kTranscriptUid + 1);
  EXPECT_TRUE(card_.done());
}

TEST_F(TagReaderOnScript, ReadsTheTagAgainAfterARefusedWrite) {
  enter();
  card_.expects(kWriteLocked);
  card_.expects(kGivesOldData);
  ASSERT_TRUE(reader_.write(kTranscriptUid, 9, ByteView{kNewData}.first(4)));
  steps(4);
  EXPECT_EQ(event<WriteOutcome>().result.error(), (WriteError{WriteFailure::kRefused, {0x6986}}));
  EXPECT_EQ(reader_.tag()->data, kOldData);
  EXPECT_TRUE(card_.done());
}

TEST_F(TagReaderOnScript, CountsAReaderThatVanishesAndReturnsAndStartsAfresh) {
  enter();
  EXPECT_TRUE(reader_.health().connected);
  ASSERT_TRUE(reader_.write(kTranscriptUid, 0, kNewData));
  card_.field = CardPresence::kNoReader;
  steps(3);
  EXPECT_EQ(event<WriteOutcome>().result.error().failure, WriteFailure::kReaderGone);
  EXPECT_EQ(event<TagLeft>().uid, kTranscriptUid);
  EXPECT_FALSE(reader_.health().connected);
  EXPECT_FALSE(reader_.tag());
  card_.field = CardPresence::kEmpty;
  steps(1);
  enter();
  EXPECT_EQ(reader_.health().vanished, 1u);
  EXPECT_EQ(reader_.health().returned, 1u);
}

TEST_F(TagReaderOnScript, GivesUpASilentReaderAndDropsItsLateAnswer) {
  card_.expects(kSaysItsUid);
  card_.field = CardPresence::kPresent;
  card_.silent = true;
  steps(30);  // 450 ms, limit 300 ms
  EXPECT_EQ(reader_.health().timeouts, 1u);
  EXPECT_FALSE(reader_.tag());
  card_.expects(kIdentifyAndRead);
  card_.silent = false;
  steps(3);
  ASSERT_TRUE(reader_.tag());
  EXPECT_EQ(reader_.tag()->data, kOldData);
  EXPECT_TRUE(card_.done());
}

TEST_F(TagReaderOnScript, AsksAgainAfterMalformedAnswersAndCountsThem) {
  card_.field = CardPresence::kPresent;
  card_.expects({kSaysItsUid.command, {}});
  card_.expects({kSaysItsUid.command, {1, 2, 3, 0x90, 0x00}});
  card_.expects({kSaysItsUid.command, {0x2A, 0, 0, 0, 0, 1, 4, 0xE0, 0x90, 0x00}});
  card_.expects({kSaysItsUid.command, {0x6A, 0x81}});
  card_.expects(kSaysItsUid);
  card_.expects({kReadRecord, {1, 2, 3, 0x90, 0x00}});
  card_.expects(kGivesOldData);
  steps(8);
  EXPECT_EQ(reader_.health().malformed, 4u);
  EXPECT_EQ(reader_.health().reversed_uid, 1u);
  EXPECT_EQ(reader_.health().refused, 1u);
  ASSERT_TRUE(reader_.tag());
  EXPECT_EQ(reader_.tag()->data, kOldData);
}

TEST_F(TagReaderOnScript, ATagThatWillNotBeReadIsThereAllTheSame) {
  card_.field = CardPresence::kPresent;
  card_.expects(kSaysItsUid);
  card_.expects({kReadRecord, {0x69, 0x82}});
  steps(5);
  ASSERT_TRUE(reader_.tag());
  EXPECT_FALSE(reader_.tag()->data);
  event<TagEntered>();
  event<TagIdentified>();
  EXPECT_EQ(event<TagDataRead>().status.meaning(), CardStatus::kSecurityNotSatisfied);
}

TEST_F(TagReaderOnScript, KeepsTheLastSixtyFourEventsOfWhomNobodyAsks) {
  for (int i = 0; i < 40; ++i) {
    card_.expects(kIdentifyAndRead);
    card_.field = CardPresence::kPresent;
    steps(3);
    card_.field = CardPresence::kEmpty;
    steps(1);
  }
  EXPECT_EQ(reader_.health().events_lost, 4u * 40u - 64u);
}

/// Does anything at any time.
class WildCard final : public CardLink {
 public:
  explicit WildCard(RandomStream random) : random_(random) {}

 private:
  CardPresence do_presence() override {
    return random_.chance(0.9) ? CardPresence::kPresent
                               : (random_.chance(0.8) ? CardPresence::kEmpty : CardPresence::kNoReader);
  }
  bool do_begin(ByteView command) override {
    command_.assign(command.begin(), command.end());
    return random_.chance(0.9);
  }
  std::optional<Result<Bytes, CardError>> do_poll() override {
    if (random_.chance(0.1)) {
      return std::nullopt;
    }
    if (random_.chance(0.05)) {
      return Result<Bytes, CardError>{Unexpected{static_cast<CardError>(random_.below(3))}};
    }
    if (command_[1] == 0xCA && random_.chance(0.8)) {
      return Result<Bytes, CardError>{kSaysItsUid.response};
    }
    Bytes answer(random_.below(16));
    for (std::uint8_t& byte : answer) {
      byte = static_cast<std::uint8_t>(random_.below(256));
    }
    if (answer.size() >= 2 && random_.chance(0.8)) {
      answer[answer.size() - 2] = 0x90;
      answer.back() = 0;
    }
    return Result<Bytes, CardError>{std::move(answer)};
  }

  RandomStream random_;
  Bytes command_;
};

TEST(TagReader, SurvivesAHundredThousandStepsOnAReaderThatDoesAnything) {
  WildCard card{RandomStream{15693}};
  TagReader reader{card};
  Instant now{};
  int begun = 0;
  int ended = 0;
  int entered = 0;
  int left = 0;
  for (int i = 0; i < 100'000; ++i) {
    now += kTick;
    reader.step(now);
    while (const auto event = reader.next_event()) {
      ended += std::holds_alternative<WriteOutcome>(*event) ? 1 : 0;
      entered += std::holds_alternative<TagEntered>(*event) ? 1 : 0;
      left += std::holds_alternative<TagLeft>(*event) ? 1 : 0;
      ASSERT_TRUE(entered == left || entered == left + 1) << "coming and going alternate";
    }
    if (reader.tag() && reader.write(reader.tag()->uid, 0, kNewData)) {
      ++begun;
    }
  }
  EXPECT_GT(begun, 1000);
  EXPECT_EQ(begun, ended + (reader.writing() ? 1 : 0)) << "each write has exactly one outcome";
}

}  // namespace
}  // namespace sensotwin::robot
