// SPDX-License-Identifier: MIT
#include "robot/drivers/uhf_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numbers>

#include "robot/base/random.hpp"
#include "tests/robot/drivers/uhf_transcript.hpp"

namespace sensotwin::robot {
namespace {

using namespace std::chrono_literals;
using namespace transcripts;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A link whose far end is the test.
class FakeLink final : public ByteLink {
 public:
  Bytes to_client;
  bool up{true};
  /// What the driver has written since the last call.
  [[nodiscard]] Bytes written() { return std::exchange(written_, {}); }

 private:
  bool do_write(ByteView bytes) override {
    written_.insert(written_.end(), bytes.begin(), bytes.end());
    return up;
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const std::size_t n = std::min(into.size(), to_client.size());
    std::copy_n(to_client.begin(), n, into.begin());
    to_client.erase(to_client.begin(), to_client.begin() + static_cast<std::ptrdiff_t>(n));
    return n;
  }
  [[nodiscard]] bool do_is_up() const override { return up; }
  Bytes written_;
};

class UhfReaderTest : public ::testing::Test {
 protected:
  void step(Duration by = kTick) {
    now += by;
    driver.step(now);
  }
  void hears(const Bytes& bytes) {
    link.to_client.insert(link.to_client.end(), bytes.begin(), bytes.end());
    step();
  }
  void hears(const llrp::Message& message, std::uint32_t id) { hears(llrp::encode(message, id)); }
  void set_up() {
    hears(kUhfGreeting);
    hears(kUhfShortCapabilities);
    for (const UhfExchange& exchange : kUhfSetup) {
      hears(exchange.from_reader);
    }
    ASSERT_EQ(driver.status(), UhfReaderStatus::kReading);
    static_cast<void>(link.written());
  }

  FakeLink link;
  UhfReaderConfig config;
  UhfReader driver{link, config};
  Instant now{};
};

TEST_F(UhfReaderTest, SaysNothingBeforeTheReaderHasGreeted) {
  step();
  step(1s);
  EXPECT_THAT(link.written(), IsEmpty());
  EXPECT_EQ(driver.status(), UhfReaderStatus::kGreeting);
}

TEST_F(UhfReaderTest, SetsAReaderUpByTheTranscript) {
  hears(kUhfGreeting);
  EXPECT_EQ(link.written(), kUhfAskCapabilities);
  Bytes next = kUhfShortCapabilities;
  for (const UhfExchange& exchange : kUhfSetup) {
    hears(next);
    EXPECT_EQ(link.written(), exchange.to_reader) << exchange.name;
    EXPECT_EQ(driver.status(), UhfReaderStatus::kSettingUp);
    next = exchange.from_reader;
  }
  hears(next);
  EXPECT_THAT(link.written(), IsEmpty());
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_THAT(driver.channels_hz(), ElementsAre(915.25e6, 902.75e6));
  EXPECT_TRUE(driver.has_phase());
  EXPECT_EQ(driver.health().setups, 1u);
}

TEST_F(UhfReaderTest, TakesFrequencyFromTheHopTableAndPhaseAndRssiFromImpinjsFields) {
  set_up();
  hears(kUhfReport);
  ASSERT_THAT(driver.reads(), SizeIs(1));
  const UhfRead& read = driver.reads()[0];
  EXPECT_EQ(read.epc, kUhfTag);
  EXPECT_EQ(read.antenna, 1);
  EXPECT_EQ(read.channel, 2);
  EXPECT_DOUBLE_EQ(read.frequency_hz, 902.75e6);
  EXPECT_TRUE(read.has_phase);
  EXPECT_NEAR(read.phase_rad, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(read.rssi_dbm, -52.5, 1e-9);
  step();
  EXPECT_THAT(driver.reads(), IsEmpty()) << "the reads of one step are gone with the next";
}

TEST_F(UhfReaderTest, PutsReadsTogetherFromTornMessages) {
  set_up();
  for (const std::uint8_t byte : kUhfReport) {
    EXPECT_THAT(driver.reads(), IsEmpty());
    hears(Bytes{byte});
  }
  EXPECT_THAT(driver.reads(), SizeIs(1));
}

TEST_F(UhfReaderTest, GivesARepeatedReportOnce) {
  set_up();
  Bytes twice = kUhfReport;
  twice.insert(twice.end(), kUhfReport.begin(), kUhfReport.end());
  hears(twice);
  EXPECT_THAT(driver.reads(), SizeIs(1));
  EXPECT_EQ(driver.health().reads_repeated, 1u);
}

TEST_F(UhfReaderTest, AnswersKeepalivesWithTheirId) {
  set_up();
  hears(kUhfKeepalive.from_reader);
  EXPECT_EQ(link.written(), kUhfKeepalive.to_reader);
}

TEST_F(UhfReaderTest, ReadsUserMemoryByTheTranscript) {
  set_up();
  ASSERT_TRUE(driver.begin_memory_read(kUhfTag, 2, 2));
  EXPECT_FALSE(driver.begin_memory_read(kUhfTag, 2, 2)) << "one at a time";
  for (const UhfExchange& exchange : kUhfReadMemory) {
    EXPECT_EQ(link.written(), exchange.to_reader) << exchange.name;
    EXPECT_FALSE(driver.poll_memory());
    hears(exchange.from_reader);
  }
  hears(kUhfMemoryReport);
  EXPECT_THAT(driver.reads(), IsEmpty()) << "a result is no read";
  const auto result = driver.poll_memory();
  ASSERT_TRUE(result && *result);
  EXPECT_THAT((*result)->words, ElementsAre(0x1234, 0x5678));
  EXPECT_FALSE(driver.poll_memory()) << "told once";
}

TEST_F(UhfReaderTest, GivesUpATagWhoseMemoryIsWantedAndWhichIsNotRead) {
  set_up();
  ASSERT_TRUE(driver.begin_memory_write(kUhfTag, 0, {7}));
  hears(kUhfReadMemory[0].from_reader);
  hears(kUhfReadMemory[1].from_reader);
  static_cast<void>(link.written());
  for (Duration waited{}; waited < config.memory_timeout; waited += 500ms) {
    hears(llrp::Keepalive{}, 9);
    step(500ms - kTick);
  }
  static_cast<void>(link.written());
  step();
  hears(llrp::DeleteAccessSpecResponse{}, 10);
  const auto result = driver.poll_memory();
  ASSERT_TRUE(result && !*result);
  EXPECT_EQ(result->error(), UhfMemoryError::kTagNotSeen);
}

TEST_F(UhfReaderTest, CountsReadsThatLackWhatAReadNeeds) {
  set_up();
  llrp::TagReport tag{
      .epc_96 = kUhfTag, .antenna_id = 1, .peak_rssi_dbm = -50, .channel_index = 3, .last_seen_utc_us = 1};
  hears(llrp::RoAccessReport{{tag}, {}}, 5);
  EXPECT_EQ(driver.health().reads_incomplete, 1u) << "channel 3 of two";
  tag.channel_index.reset();
  hears(llrp::RoAccessReport{{tag}, {}}, 6);
  EXPECT_EQ(driver.health().reads_incomplete, 2u);
  EXPECT_THAT(driver.reads(), IsEmpty());
}

TEST_F(UhfReaderTest, NamesARefusedRoSpecAndTriesAgainWithGrowingPauses) {
  hears(kUhfGreeting);
  hears(kUhfShortCapabilities);
  for (std::size_t i = 0; i + 2 < kUhfSetup.size(); ++i) {
    hears(kUhfSetup[i].from_reader);
  }
  static_cast<void>(link.written());
  hears(llrp::AddRoSpecResponse{{.code = llrp::StatusCode::kDeviceError, .description = "hot"}}, 6);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kWaiting);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kRefused);
  EXPECT_EQ(driver.refusal().description, "hot");
  step(config.first_retry - 1ms);
  EXPECT_THAT(link.written(), IsEmpty());
  step(1ms);
  EXPECT_THAT(link.written(), SizeIs(kUhfAskCapabilities.size()));
  hears(llrp::GetReaderCapabilitiesResponse{.status = {.code = llrp::StatusCode::kDeviceError}}, 7);
  step(config.first_retry);
  EXPECT_THAT(link.written(), IsEmpty()) << "twice as long the second time";
  step(config.first_retry);
  EXPECT_THAT(link.written(), SizeIs(kUhfAskCapabilities.size()));
  EXPECT_EQ(driver.health().count(UhfReaderFault::kRefused), 2u);
}

TEST_F(UhfReaderTest, RefusesAReaderWithoutExtensionsWhenPhaseIsDemanded) {
  hears(kUhfGreeting);
  hears(kUhfShortCapabilities);
  hears(kUhfSetup[0].from_reader);
  hears(kUhfSetup[1].from_reader);
  hears(llrp::ErrorMessage{{.code = llrp::StatusCode::kUnsupportedMessage}}, 4);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kNoExtensions);
}

TEST_F(UhfReaderTest, RefusesAReaderWithTooFewAntennas) {
  UhfReaderConfig two = config;
  two.antennas = {1, 2};
  UhfReader other{link, two};
  link.to_client = kUhfGreeting;
  other.step(now += kTick);
  link.to_client = kUhfShortCapabilities;
  other.step(now += kTick);
  EXPECT_EQ(other.last_fault(), UhfReaderFault::kTooFewAntennas);
}

TEST_F(UhfReaderTest, NamesAnAnswerThatDoesNotCome) {
  hears(kUhfGreeting);
  step(config.request_timeout - 1ms);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kNone);
  step(1ms);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kNoAnswer);
}

TEST_F(UhfReaderTest, NamesSilenceAndGoesOnWhenReportsComeAgain) {
  set_up();
  step(2s);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading) << "two keepalives may be lost";
  step(600ms);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kSilent);
  hears(kUhfReport);
  EXPECT_EQ(driver.status(), UhfReaderStatus::kReading);
  EXPECT_THAT(driver.reads(), SizeIs(1));
  EXPECT_EQ(driver.health().setups, 1u);
}

TEST_F(UhfReaderTest, SetsTheReaderUpAnewWhenTheLinkComesBack) {
  set_up();
  link.to_client = Bytes(kUhfReport.begin(), kUhfReport.begin() + 40);  // torn off in mid-message
  step();
  link.up = false;
  step();
  EXPECT_EQ(driver.status(), UhfReaderStatus::kDown);
  EXPECT_EQ(driver.last_fault(), UhfReaderFault::kLinkLost);
  link.up = true;
  link.to_client.clear();
  hears(kUhfGreeting);
  EXPECT_THAT(link.written(), SizeIs(kUhfAskCapabilities.size()));
  EXPECT_EQ(driver.status(), UhfReaderStatus::kSettingUp);
}

TEST_F(UhfReaderTest, FindsReportsAgainBehindGarbage) {
  set_up();
  Bytes bytes(37, 0xA5);
  bytes.insert(bytes.end(), kUhfReport.begin(), kUhfReport.end());
  hears(bytes);
  EXPECT_THAT(driver.reads(), SizeIs(1));
  EXPECT_EQ(driver.health().count(UhfReaderFault::kCorruptStream), 1u);
  EXPECT_EQ(driver.health().bytes_skipped, 37u);
}

TEST_F(UhfReaderTest, GivesNoReadsOfARoSpecThatIsNotItsOwn) {
  hears(kUhfGreeting);
  hears(kUhfReport);
  EXPECT_THAT(driver.reads(), IsEmpty());
  EXPECT_EQ(driver.health().reads_unasked, 1u);
}

TEST_F(UhfReaderTest, LeavesTheReaderCleanWhenItShutsDown) {
  set_up();
  driver.shut_down();
  EXPECT_EQ(link.written(), hex("0415 0000000e 00000008 00000001  040e 0000000a 00000009"));
  hears(kUhfReport);
  EXPECT_THAT(driver.reads(), IsEmpty());
}

TEST(ReaderClock, IsWrongByNoMoreThanTheLeastDelayOfTheReports) {
  ReaderClock clock;
  const std::uint64_t utc0_us = 1700000000000000;
  RandomStream random{5};
  for (int i = 0; i < 200; ++i) {
    const Instant read_at{20ms * i};
    const Duration delay = from_s(random.uniform(0.002, 0.08));
    const std::uint64_t stamp_us = utc0_us + static_cast<std::uint64_t>(20000 * i);
    clock.learn(stamp_us, read_at + delay);
    EXPECT_LE(clock.at(stamp_us), read_at + delay) << "never after its arrival";
    if (i > 50) {
      EXPECT_GE(clock.at(stamp_us), read_at);
      EXPECT_LT(clock.at(stamp_us) - read_at, 6ms);
    }
  }
}

TEST(ReaderClock, FollowsAQuartzThatRunsSlow) {
  ReaderClock clock;
  constexpr double kSlow = 1.0 - 50e-6;
  for (int i = 0; i <= 6000; ++i) {
    const Instant at{100ms * i};
    const auto stamp_us = static_cast<std::uint64_t>(1e15 + i * 1e5 * kSlow);
    clock.learn(stamp_us, at);
    if (i > 400) {
      EXPECT_LE(to_s(at - clock.at(stamp_us)), 20.0 * 50e-6 + 1e-5);
    }
  }
  EXPECT_EQ(clock.restarts(), 0u);
}

TEST(ReaderClock, StartsAnewWhenTheReadersClockIsSetBack) {
  ReaderClock clock;
  clock.learn(2'000'000'000'000'000, Instant{1s});
  clock.learn(1'000'000'000'000'000, Instant{2s});
  EXPECT_EQ(clock.restarts(), 1u);
  EXPECT_EQ(clock.at(1'000'000'000'000'000), Instant{2s});
}

TEST(ReaderClock, SurvivesStampsThatAreNoDates) {
  ReaderClock clock;
  clock.learn(UINT64_MAX, Instant{1s});
  clock.learn(0, Instant{2s});
  clock.learn(1'700'000'000'000'000, Instant{3s});
  EXPECT_TRUE(clock.is_set());
}

}  // namespace
}  // namespace sensotwin::robot
