// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_uhf_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

#include "robot/base/random.hpp"
#include "tests/robot/drivers/uhf_transcript.hpp"
#include "tests/twin/devices/uhf_bench.hpp"

namespace sensotwin::twin {
namespace {

using namespace std::chrono_literals;
using namespace robot::transcripts;
namespace llrp = robot::llrp;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const UhfReaderSettings kTwoChannels{.channels_hz = {915.25e6, 902.75e6}};

[[nodiscard]] RadioReading reading(robot::Duration at) {
  return {.at = robot::Instant{at},
          .epc = kUhfTag,
          .antenna = 1,
          .channel = 2,
          .phase_rad = std::numbers::pi / 2.0,
          .rssi_dbm = -52.5};
}

class EmulatedUhfReaderTest : public ::testing::Test {
 protected:
  EmulatedUhfReaderTest() { EXPECT_TRUE(bench.reader.connect()); }
  void follow_transcript() {
    EXPECT_EQ(bench.sent(), kUhfGreeting);
    bench.reader.receive(kUhfAskCapabilities);
    static_cast<void>(bench.sent());
    for (const UhfExchange& exchange : kUhfSetup) {
      bench.reader.receive(exchange.to_reader);
      EXPECT_EQ(bench.sent(), exchange.from_reader) << exchange.name;
    }
  }
  void run(const llrp::RoSpec& spec) {
    EXPECT_TRUE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok());
    EXPECT_TRUE(bench.ask<llrp::EnableRoSpecResponse>(llrp::EnableRoSpec{spec.id}).ok());
  }

  std::vector<std::uint16_t> user{0, 0, 0x1234, 0x5678};
  UhfBench bench{kTwoChannels, [this](const robot::Epc& epc) {
                   return epc == kUhfTag ? std::span<std::uint16_t>{user} : std::span<std::uint16_t>{};
                 }};
};

TEST_F(EmulatedUhfReaderTest, AnswersTheDriversTranscript) {
  follow_transcript();
  EXPECT_THAT(bench.reader.antennas(), ElementsAre(1));
}

TEST_F(EmulatedUhfReaderTest, ReportsAReadByTheTranscript) {
  follow_transcript();
  EXPECT_TRUE(bench.reader.report(reading(1s)));
  EXPECT_EQ(bench.sent(), kUhfReport);
}

TEST_F(EmulatedUhfReaderTest, KeepsTheConnectionAliveByTheTranscript) {
  follow_transcript();
  EXPECT_TRUE(bench.reader.report(reading(1s)));
  static_cast<void>(bench.sent());
  bench.reader.step(robot::Instant{1s});
  EXPECT_EQ(bench.sent(), kUhfKeepalive.from_reader);
  bench.reader.receive(kUhfKeepalive.to_reader);
  EXPECT_EQ(bench.reader.tally().keepalive_acks, 1u);
}

TEST_F(EmulatedUhfReaderTest, ReadsUserMemoryByTheTranscript) {
  follow_transcript();
  EXPECT_TRUE(bench.reader.report(reading(1s)));
  static_cast<void>(bench.sent());
  for (const UhfExchange& exchange : kUhfReadMemory) {
    bench.reader.receive(exchange.to_reader);
    EXPECT_EQ(bench.sent(), exchange.from_reader) << exchange.name;
  }
  EXPECT_TRUE(bench.reader.report(reading(1250ms)));
  robot::Bytes told = bench.sent();
  ASSERT_GT(told.size(), kUhfMemoryReport.size());
  told.resize(kUhfMemoryReport.size());
  EXPECT_EQ(told, kUhfMemoryReport);
}

TEST_F(EmulatedUhfReaderTest, ReadsNothingBeforeItIsAskedAndThroughNoOtherAntenna) {
  EXPECT_FALSE(bench.reader.report(reading(1s)));
  run(plain_ro_spec());
  RadioReading second = reading(2s);
  second.antenna = 2;
  EXPECT_FALSE(bench.reader.report(second));
  EXPECT_TRUE(bench.reader.report(reading(3s)));
}

TEST_F(EmulatedUhfReaderTest, AnswersTenBytesThatCannotBeAHeaderByClosing) {
  static_cast<void>(bench.sent());
  bench.reader.receive(hex("0467 000c a1e5 00000001"));  // recorded: see vectors/r420_recorded
  const auto events = bench.only<llrp::ReaderEventNotification>();
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_TRUE(events[0].event.connection_close);
  EXPECT_FALSE(bench.reader.is_connected());
  EXPECT_TRUE(bench.reader.connect()) << "and takes the next client";
}

TEST_F(EmulatedUhfReaderTest, ClosesWhenItIsAskedTo) {
  EXPECT_TRUE(bench.ask<llrp::CloseConnectionResponse>(llrp::CloseConnection{}).ok());
  EXPECT_FALSE(bench.reader.is_connected());
}

TEST_F(EmulatedUhfReaderTest, TellsASecondClientThatItIsBusyAndTheFirstThatSomebodyTried) {
  static_cast<void>(bench.sent());
  EXPECT_FALSE(bench.reader.connect());
  const auto told = bench.only<llrp::ReaderEventNotification>();
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].event.connection_attempt->status, llrp::ConnectionAttempt::kAnotherAttempted);
  const robot::Bytes refusal = bench.reader.refusal();
  EXPECT_EQ(refusal.back(), 2);
  EXPECT_TRUE(bench.reader.is_connected());
}

TEST_F(EmulatedUhfReaderTest, HoldsOneRoSpecAndRefusesASecond) {
  llrp::RoSpec spec = plain_ro_spec();
  EXPECT_TRUE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok());
  EXPECT_FALSE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok()) << "same id";
  spec.id = 8;
  EXPECT_FALSE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok()) << "another one";
  EXPECT_FALSE(bench.ask<llrp::StartRoSpecResponse>(llrp::StartRoSpec{7}).ok()) << "still disabled";
  EXPECT_FALSE(bench.ask<llrp::EnableRoSpecResponse>(llrp::EnableRoSpec{9}).ok());
  EXPECT_TRUE(bench.ask<llrp::DeleteRoSpecResponse>(llrp::DeleteRoSpec{0}).ok());
  EXPECT_TRUE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok());
}

TEST_F(EmulatedUhfReaderTest, StartsARoSpecWithoutATriggerWhenItIsTold) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.boundary.start.kind = llrp::RoStart::kNull;
  run(spec);
  EXPECT_THAT(bench.reader.antennas(), IsEmpty());
  EXPECT_TRUE(bench.ask<llrp::StartRoSpecResponse>(llrp::StartRoSpec{7}).ok());
  EXPECT_THAT(bench.reader.antennas(), ElementsAre(1));
  EXPECT_TRUE(bench.ask<llrp::StopRoSpecResponse>(llrp::StopRoSpec{7}).ok());
  EXPECT_THAT(bench.reader.antennas(), IsEmpty());
  bench.say(llrp::GetRoSpecs{});
  EXPECT_EQ(bench.only<llrp::GetRoSpecsResponse>().at(0).specs.at(0).state, llrp::RoSpecState::kInactive);
}

TEST_F(EmulatedUhfReaderTest, TakesAntennaZeroForAllOfThem) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.ai_specs[0].antennas = {0};
  run(spec);
  EXPECT_THAT(bench.reader.antennas(), ElementsAre(1, 2, 3, 4));
}

TEST_F(EmulatedUhfReaderTest, ReportsEveryNEntriesAndMergesReadsOfOneTagWithTheFirstChannelAndTheLastPhase) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.ai_specs[0].antennas = {1, 2};
  spec.report->tags = 2;
  run(spec);
  RadioReading first = reading(100ms);
  first.channel = 1;
  EXPECT_TRUE(bench.reader.report(first));
  EXPECT_TRUE(bench.reader.report(reading(120ms)));  // merges: channel 2, the same antenna
  EXPECT_THAT(bench.sent(), IsEmpty());
  RadioReading other = reading(140ms);
  other.antenna = 2;
  EXPECT_TRUE(bench.reader.report(other));
  const auto reports = bench.only<llrp::RoAccessReport>();
  ASSERT_THAT(reports, SizeIs(1));
  ASSERT_THAT(reports[0].tags, SizeIs(2));
  const llrp::TagReport& merged = reports[0].tags[0];
  EXPECT_EQ(merged.seen_count, 2);
  EXPECT_EQ(merged.channel_index, 1);
  EXPECT_EQ(*merged.last_seen_utc_us - *merged.first_seen_utc_us, 20000u);
}

TEST_F(EmulatedUhfReaderTest, SendsWhatItHoldsWhenAnAiSpecEndsAndBeginsAnImmediateRoSpecAgain) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.report->tags = 0;
  spec.ai_specs[0].stop = {.kind = llrp::AiStop::kDuration, .duration_ms = 500};
  run(spec);
  EXPECT_TRUE(bench.reader.report(reading(100ms)));
  EXPECT_THAT(bench.sent(), IsEmpty());
  EXPECT_TRUE(bench.reader.report(reading(600ms))) << "belongs to the next round";
  const auto reports = bench.only<llrp::RoAccessReport>();
  ASSERT_THAT(reports, SizeIs(1));
  EXPECT_THAT(reports[0].tags, SizeIs(1));
}

TEST_F(EmulatedUhfReaderTest, EndsAnAiSpecAfterNObservations) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.boundary.start.kind = llrp::RoStart::kNull;
  spec.report->tags = 0;
  spec.ai_specs[0].stop = {.kind = llrp::AiStop::kTagObservation,
                           .tags = llrp::TagObservationTrigger{.tags = 3, .timeout_ms = 60000}};
  run(spec);
  EXPECT_TRUE(bench.ask<llrp::StartRoSpecResponse>(llrp::StartRoSpec{7}).ok());
  for (int i = 1; i <= 3; ++i) {
    EXPECT_TRUE(bench.reader.report(reading(i * 20ms)));
  }
  EXPECT_FALSE(bench.reader.report(reading(80ms)));
  EXPECT_EQ(bench.only<llrp::RoAccessReport>().at(0).tags.at(0).seen_count, 3);
}

TEST_F(EmulatedUhfReaderTest, SendsTheReportOfADisabledRoSpecBeforeTheAnswer) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.report->tags = 0;
  run(spec);
  EXPECT_TRUE(bench.reader.report(reading(100ms)));
  bench.say(llrp::DisableRoSpec{7});
  const auto messages = bench.messages();
  ASSERT_THAT(messages, SizeIs(2));
  EXPECT_TRUE(std::holds_alternative<llrp::RoAccessReport>(messages[0].message));
  EXPECT_TRUE(std::holds_alternative<llrp::DisableRoSpecResponse>(messages[1].message));
}

TEST_F(EmulatedUhfReaderTest, TellsStartAndEndOfARoSpecToWhoWantsToKnow) {
  const llrp::EventState on{llrp::EventKind::kRoSpec, true};
  EXPECT_TRUE(
      bench.ask<llrp::SetReaderConfigResponse>(llrp::SetReaderConfig{.events = llrp::EventSpec{{on}}}).ok());
  EXPECT_TRUE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{plain_ro_spec()}).ok());
  bench.say(llrp::EnableRoSpec{7});
  bench.say(llrp::DeleteRoSpec{7});
  const auto events = bench.only<llrp::ReaderEventNotification>();
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(events[0].event.ro_spec->kind, llrp::RoSpecEventKind::kStart);
  EXPECT_EQ(events[1].event.ro_spec->kind, llrp::RoSpecEventKind::kEnd);
}

TEST_F(EmulatedUhfReaderTest, HoldsReportsOfAnEarlierConnectionUntilTheyAreAskedFor) {
  EXPECT_TRUE(bench
                  .ask<llrp::SetReaderConfigResponse>(
                      llrp::SetReaderConfig{.events_and_reports = llrp::EventsAndReports{true}})
                  .ok());
  run(plain_ro_spec());
  bench.reader.disconnect();
  EXPECT_TRUE(bench.reader.connect());
  EXPECT_TRUE(bench.reader.report(reading(1s)));
  EXPECT_THAT(bench.only<llrp::RoAccessReport>(), IsEmpty());
  bench.say(llrp::EnableEventsAndReports{});
  EXPECT_THAT(bench.only<llrp::RoAccessReport>(), SizeIs(1));
}

TEST_F(EmulatedUhfReaderTest, ForgetsImpinjsExtensionsWithTheConnection) {
  llrp::RoSpec spec = plain_ro_spec();
  spec.report->impinj = llrp::ImpinjReportContent{.phase_angle = llrp::ImpinjEnablePhaseAngle{1}};
  EXPECT_FALSE(bench.ask<llrp::AddRoSpecResponse>(llrp::AddRoSpec{spec}).ok());
  EXPECT_TRUE(bench.ask<llrp::ImpinjEnableExtensionsResponse>(llrp::ImpinjEnableExtensions{}).ok());
  run(spec);
  EXPECT_TRUE(bench.reader.report(reading(1s)));
  EXPECT_TRUE(bench.only<llrp::RoAccessReport>().at(0).tags.at(0).phase_angle);
  bench.reader.disconnect();
  EXPECT_TRUE(bench.reader.connect());
  EXPECT_TRUE(bench.reader.report(reading(2s)));
  EXPECT_FALSE(bench.only<llrp::RoAccessReport>().at(0).tags.at(0).phase_angle);
}

TEST_F(EmulatedUhfReaderTest, WritesUserMemoryAndTellsWhatItCannot) {
  run(plain_ro_spec());
  const auto result_of = [&](llrp::C1G2OpSpec op, robot::Duration at) {
    llrp::AccessSpec spec{.id = 3, .stop = {llrp::AccessStop::kCount, 1}};
    spec.command.tags.targets = {{.bank = llrp::MemoryBank::kEpc}};  // no mask: any tag
    spec.command.operations = {std::move(op)};
    EXPECT_TRUE(bench.ask<llrp::AddAccessSpecResponse>(llrp::AddAccessSpec{spec}).ok());
    EXPECT_TRUE(bench.ask<llrp::EnableAccessSpecResponse>(llrp::EnableAccessSpec{3}).ok());
    EXPECT_TRUE(bench.reader.report(reading(at)));
    const llrp::TagReport tag = bench.only<llrp::RoAccessReport>().at(0).tags.at(0);
    EXPECT_EQ(tag.access_spec_id, 3u);
    EXPECT_FALSE(bench.ask<llrp::DeleteAccessSpecResponse>(llrp::DeleteAccessSpec{3}).ok()) << "gone";
    return tag.results.at(0);
  };
  const auto user_bank = llrp::MemoryBank::kUser;
  EXPECT_EQ(result_of(llrp::C1G2Write{1, 0, user_bank, 1, {0xABCD}}, 1s),
            llrp::C1G2OpResult(llrp::C1G2WriteResult{llrp::WriteResult::kSuccess, 1, 1}));
  EXPECT_THAT(user, ElementsAre(0, 0xABCD, 0x1234, 0x5678));
  EXPECT_EQ(result_of(llrp::C1G2Write{2, 0, user_bank, 3, {1, 2}}, 2s),
            llrp::C1G2OpResult(llrp::C1G2WriteResult{llrp::WriteResult::kMemoryOverrun, 2, 0}));
  EXPECT_EQ(result_of(llrp::C1G2Read{3, 0, user_bank, 2, 0}, 3s),
            llrp::C1G2OpResult(llrp::C1G2ReadResult{llrp::ReadResult::kSuccess, 3, {0x1234, 0x5678}}));
  EXPECT_EQ(result_of(llrp::C1G2Read{4, 0, user_bank, 4, 1}, 4s),
            llrp::C1G2OpResult(llrp::C1G2ReadResult{llrp::ReadResult::kTagError, 4, {}}));
  EXPECT_EQ(result_of(llrp::C1G2Read{5, 99, user_bank, 0, 1}, 5s),
            llrp::C1G2OpResult(llrp::C1G2ReadResult{llrp::ReadResult::kNoResponse, 5, {}}));
}

TEST_F(EmulatedUhfReaderTest, DelaysReportsAndKeepsTheirOrder) {
  UhfReaderSettings settings = kTwoChannels;
  settings.report_latency = 30ms;
  UhfBench slow{settings};
  ASSERT_TRUE(slow.reader.connect());
  slow.say(llrp::AddRoSpec{plain_ro_spec()});
  slow.say(llrp::EnableRoSpec{7});
  static_cast<void>(slow.sent());
  EXPECT_TRUE(slow.reader.report(reading(100ms)));
  slow.reader.step(robot::Instant{129ms});
  EXPECT_THAT(slow.sent(), IsEmpty());
  slow.reader.step(robot::Instant{130ms});
  EXPECT_THAT(slow.only<llrp::RoAccessReport>(), SizeIs(1));
}

TEST_F(EmulatedUhfReaderTest, LosesReportsInsteadOfMemoryWhenNobodyTakesThem) {
  UhfReaderSettings settings = kTwoChannels;
  settings.buffer_bytes = 1000;
  UhfBench small{settings};
  ASSERT_TRUE(small.reader.connect());
  small.say(llrp::AddRoSpec{plain_ro_spec()});
  small.say(llrp::EnableRoSpec{7});
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(small.reader.report(reading(i * 20ms)));
  }
  EXPECT_EQ(small.reader.tally().reports, 100u);
  EXPECT_GT(small.reader.tally().reports_lost, 50u);
  EXPECT_LT(small.sent().size(), 1200u);
}

TEST_F(EmulatedUhfReaderTest, LosesKeepalivesToo) {
  UhfReaderSettings settings = kTwoChannels;
  settings.buffer_bytes = 1000;
  UhfBench small{settings};
  ASSERT_TRUE(small.reader.connect());
  llrp::SetReaderConfig config;
  config.keepalive = llrp::KeepaliveSpec{.trigger = llrp::KeepaliveTrigger::kPeriodic, .period_ms = 10};
  small.say(config);
  for (int i = 1; i <= 1000; ++i) {
    small.reader.step(robot::Instant{i * 20ms});
  }
  EXPECT_LT(small.reader.tally().keepalives, 110u);
  EXPECT_LT(small.sent().size(), 1200u);
}

TEST_F(EmulatedUhfReaderTest, LosesWordOfSecondClientsToo) {
  UhfReaderSettings settings = kTwoChannels;
  settings.buffer_bytes = 1000;
  UhfBench small{settings};
  ASSERT_TRUE(small.reader.connect());
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(small.reader.connect());
  }
  EXPECT_LT(small.sent().size(), 1200u);
}

TEST_F(EmulatedUhfReaderTest, NeverCrashesOnRandomBytesAndTakesTheNextClient) {
  robot::RandomStream random{21};
  for (int round = 0; round < 3000; ++round) {
    if (!bench.reader.is_connected()) {
      ASSERT_TRUE(bench.reader.connect());
    }
    robot::Bytes bytes = llrp::encode(llrp::AddRoSpec{plain_ro_spec()}, 1);
    for (std::uint32_t i = 0; i < 1 + random.below(3); ++i) {
      bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] =
          static_cast<std::uint8_t>(random.below(256));
    }
    bench.reader.receive(bytes);
    static_cast<void>(bench.sent());
  }
  EXPECT_GT(bench.reader.tally().refused, 100u);
  EXPECT_GT(bench.reader.tally().connections, 10u);
}

}  // namespace
}  // namespace sensotwin::twin
