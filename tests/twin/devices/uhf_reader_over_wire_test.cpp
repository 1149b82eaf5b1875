// SPDX-License-Identifier: MIT
// The driver and the emulated reader, joined by the in-memory link as in `twin run`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/drivers/uhf_reader.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"

namespace sensotwin::twin {
namespace {

using namespace std::chrono_literals;
using robot::UhfReaderFault;
using robot::UhfReaderStatus;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr robot::Epc kTag{{0x30, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7}};

/// A tag that answers every 14 ms through two antennas in turn, on channels that change every 203 ms (data
/// study, 3.8).
class UhfOverWire : public ::testing::Test {
 protected:
  static UhfReaderSettings four_channels() {
    return {.channels_hz = {915.25e6, 902.75e6, 927.25e6, 910.75e6}};
  }
  explicit UhfOverWire(const UhfReaderSettings& settings = four_channels(),
                       const robot::UhfReaderConfig& config = {.antennas = {1, 2}})
      : reader(settings, [this](const robot::Epc&) { return std::span<std::uint16_t>{user}; }),
        driver(reader.link(), config) {}

  /// The reading number `i`.
  [[nodiscard]] static RadioReading reading(int i) {
    const robot::Duration at = 14ms * i;
    return {.at = robot::Instant{at},
            .epc = kTag,
            .antenna = static_cast<std::uint16_t>(1 + i % 2),
            .channel = static_cast<std::uint16_t>(1 + at / 203ms % 4),
            .phase_rad = 0.1 * i,
            .rssi_dbm = -50.0 - i % 3};
  }
  void run(robot::Duration span) {
    const robot::Instant end = now + span;
    while (now < end) {
      now += robot::kTick;
      while (robot::Instant{14ms * next} <= now) {
        made += reader.report(reading(next)) ? 1 : 0;
        ++next;
      }
      reader.step(now);
      driver.step(now);
      for (const robot::UhfRead& read : driver.reads()) {
        reads.push_back(read);
        EXPECT_LE(read.at, now);
      }
    }
  }

  std::vector<std::uint16_t> user{1, 2, 3, 4};
  EmulatedUhfReader reader;
  robot::UhfReader driver;
  robot::Instant now{};
  int next{1};
  int made{0};
  std::vector<robot::UhfRead> reads;
};

TEST_F(UhfOverWire, EveryReadArrivesWithItsPhaseFrequencyAndTime) {
  run(10s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads.size(), 600u);
  EXPECT_GE(made, static_cast<int>(reads.size()));
  EXPECT_LE(made, static_cast<int>(reads.size()) + 2);
  const std::vector<double> channels = four_channels().channels_hz;
  for (const robot::UhfRead& read : reads) {
    // Which reading it was shows in the time, once the clocks are known to within a step.
    const int i = static_cast<int>(std::lround(robot::to_s(read.at) / 0.014));
    const double phase_error = std::remainder(read.phase_rad - 0.1 * i, 2.0 * std::numbers::pi);
    if (read.at > robot::Instant{1s}) {
      EXPECT_NEAR(robot::to_s(read.at), 0.014 * i, 0.0015);
      EXPECT_NEAR(phase_error, 0.0, std::numbers::pi / 4096.0 + 1e-9) << i;
      EXPECT_EQ(read.antenna, 1 + i % 2);
      EXPECT_DOUBLE_EQ(read.frequency_hz, channels[read.channel - 1]);
    }
  }
  EXPECT_EQ(driver.health().keepalives, reader.tally().keepalives);
  EXPECT_EQ(reader.tally().keepalive_acks, reader.tally().keepalives);
  EXPECT_EQ(reader.tally().refused, 0u);
}

TEST_F(UhfOverWire, WritesAndReadsUserMemory) {
  run(1s);
  ASSERT_TRUE(driver.begin_memory_write(kTag, 1, {0xBEEF, 0xCAFE}));
  run(300ms);
  const auto written = driver.poll_memory();
  ASSERT_TRUE(written && *written);
  EXPECT_EQ((*written)->words_written, 2);
  EXPECT_THAT(user, ElementsAre(1, 0xBEEF, 0xCAFE, 4));
  ASSERT_TRUE(driver.begin_memory_read(kTag, 0, 0));
  run(300ms);
  const auto read = driver.poll_memory();
  ASSERT_TRUE(read && *read);
  EXPECT_THAT((*read)->words, ElementsAre(1, 0xBEEF, 0xCAFE, 4));
  ASSERT_TRUE(driver.begin_memory_write(kTag, 3, {1, 2}));
  run(300ms);
  const auto beyond = driver.poll_memory();
  ASSERT_TRUE(beyond && !*beyond);
  EXPECT_EQ(beyond->error(), robot::UhfMemoryError::kMemoryOverrun);
}

TEST_F(UhfOverWire, ATagThatIsNotThereIsGivenUpAndTheReaderLeftClean) {
  run(1s);
  ASSERT_TRUE(driver.begin_memory_read(robot::Epc{}, 0, 1));
  run(3s);
  const auto result = driver.poll_memory();
  ASSERT_TRUE(result && !*result);
  EXPECT_EQ(result->error(), robot::UhfMemoryError::kTagNotSeen);
  ASSERT_TRUE(driver.begin_memory_read(kTag, 0, 1));
  run(300ms);
  const auto next_result = driver.poll_memory();
  EXPECT_TRUE(next_result && *next_result);
}

TEST_F(UhfOverWire, AConnectionLostInMidMessageIsMadeAnew) {
  run(2s);
  const std::size_t before = reads.size();
  reader.link().inject(robot::Bytes{0x04, 61, 0, 0, 0, 91, 0, 0, 0, 1, 0, 0xF0});  // begins, never ends
  driver.step(now);
  reader.link().cut();
  run(1s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kDown);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kLinkLost);
  EXPECT_EQ(reads.size(), before);
  reader.link().mend();
  run(2s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads.size(), before + 80);
  EXPECT_EQ(driver.health().setups, 2u);
  EXPECT_EQ(reader.tally().connections, 2u);
}

TEST_F(UhfOverWire, GarbageCostsNoMoreThanTheReadsItHits) {
  run(2s);
  robot::RandomStream random{31};
  robot::Bytes garbage(100);
  for (std::uint8_t& byte : garbage) {
    byte = static_cast<std::uint8_t>(0x80 | random.below(128));
  }
  const std::size_t before = reads.size();
  reader.link().inject(garbage);
  run(2s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_EQ(driver.health().count(UhfReaderFault::kCorruptStream), 1u);
  EXPECT_GT(reads.size(), before + 130);
}

TEST_F(UhfOverWire, BytesLostFromTheStreamAreSurvived) {
  robot::RandomStream random{32};
  for (int round = 0; round < 40; ++round) {
    run(1s);
    reader.link().lose(1 + random.below(120));
  }
  run(20s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_GT(driver.health().messages_bad + driver.health().count(UhfReaderFault::kCorruptStream), 5u);
  const std::size_t before = reads.size();
  run(2s);
  EXPECT_GT(reads.size(), before + 130);
}

TEST_F(UhfOverWire, TwoSecondsOfSilenceAreNoFaultAndTheReadsComeLateWithTheirOwnTimes) {
  run(2s);
  const std::size_t before = reads.size();
  const robot::Instant silent_from = now;
  reader.link().set_silent(true);
  run(2s);
  EXPECT_EQ(reads.size(), before);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  reader.link().set_silent(false);
  run(100ms);
  EXPECT_GT(reads.size(), before + 140);
  EXPECT_NEAR(robot::to_s(reads[before].at - silent_from), 0.0, 0.02);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kNone);
}

TEST_F(UhfOverWire, LongSilenceIsToldAndReadingGoesOnAfterIt) {
  run(2s);
  reader.link().set_silent(true);
  run(4s);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kSilent);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kSettingUp) << "it is tried again";
  const std::size_t before = reads.size();
  reader.link().set_silent(false);
  run(2s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_GT(reads.size(), before + 80);
}

TEST(UhfOverWireWithFaultyReader, ARefusedRoSpecIsToldAndTriedAgainAtGrowingPauses) {
  UhfReaderSettings settings;
  settings.refuse_ro_specs = true;
  EmulatedUhfReader reader{settings};
  robot::UhfReader driver{reader.link(), {}};
  for (robot::Instant now{}; now < robot::Instant{60s}; now += robot::kTick) {
    reader.step(now);
    driver.step(now);
  }
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kRefused);
  EXPECT_EQ(driver.refusal().code, robot::llrp::StatusCode::kDeviceError);
  // Pauses of 0.5, 1, 2, 4, 8, 8 ... s: ten tries in a minute.
  EXPECT_NEAR(driver.health().count(UhfReaderFault::kRefused), 10, 1);
}

TEST(UhfOverWireWithoutExtensions, ReadsComeWithoutPhaseWhenNoneIsDemandedAndNotAtAllWhenItIs) {
  for (const bool demanded : {false, true}) {
    UhfReaderSettings settings;
    settings.impinj_extensions = false;
    EmulatedUhfReader reader{settings};
    robot::UhfReader driver{reader.link(), {.demand_impinj_extensions = demanded}};
    int reads = 0;
    for (robot::Instant now{robot::kTick}; now < robot::Instant{2s}; now += robot::kTick) {
      static_cast<void>(reader.report({.at = now, .epc = kTag, .rssi_dbm = -60.5}));
      reader.step(now);
      driver.step(now);
      for (const robot::UhfRead& read : driver.reads()) {
        ++reads;
        EXPECT_FALSE(read.has_phase);
        EXPECT_DOUBLE_EQ(read.rssi_dbm, -60.0) << "whole decibels are all that is told";
      }
    }
    EXPECT_EQ(reads > 0, !demanded);
    EXPECT_EQ(driver.last_fault(), demanded ? UhfReaderFault::kNoExtensions : UhfReaderFault::kNone);
  }
}

TEST(UhfOverWireInBatches, ReportsOfSeveralEntriesArriveWithinTheTimeSet) {
  EmulatedUhfReader reader{{}};
  robot::UhfReader driver{reader.link(), {.report_every = 4}};
  int reads = 0;
  robot::Duration oldest{};
  for (robot::Instant now{robot::kTick}; now < robot::Instant{5s}; now += robot::kTick) {
    static_cast<void>(reader.report({.at = now, .epc = kTag}));
    reader.step(now);
    driver.step(now);
    for (const robot::UhfRead& read : driver.reads()) {
      ++reads;
      oldest = std::max(oldest, now - read.at);
    }
  }
  // One tag and one antenna merge into one entry each 200 ms.
  EXPECT_NEAR(reads, 24, 3);
  EXPECT_LE(oldest, 230ms);
}

}  // namespace
}  // namespace sensotwin::twin
