// SPDX-License-Identifier: MIT
#include "robot/drivers/sensor_board.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "tests/robot/drivers/compass_transcript.hpp"

namespace sensotwin::robot {
namespace {

class TextLink final : public ByteLink {
 public:
  void says(std::string_view text) { waiting_ += text; }
  bool up{true};

 private:
  bool do_write(ByteView /*bytes*/) override { return up; }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const std::size_t n = std::min(into.size(), waiting_.size());
    std::copy_n(waiting_.begin(), n, into.begin());
    waiting_.erase(0, n);
    return n;
  }
  [[nodiscard]] bool do_is_up() const override { return up; }

  std::string waiting_;
};

class SensorBoardOnText : public ::testing::Test {
 protected:
  void step() {
    now_ += kTick;
    sensor_board_.step(now_);
  }
  TextLink link_;
  SensorBoard sensor_board_{link_};
  Instant now_{};
};

TEST_F(SensorBoardOnText, TurnsClockwiseHeadingsIntoCounterClockwiseYaw) {
  for (const auto& line : testing::kCompassLines) {
    link_.says(line.sentence);
    step();
    ASSERT_TRUE(sensor_board_.compass());
    EXPECT_NEAR(sensor_board_.compass()->yaw_from_north_rad, line.yaw_from_north_rad, 1e-12) << line.sentence;
    EXPECT_EQ(sensor_board_.compass()->stamp, now_);
  }
}

TEST_F(SensorBoardOnText, HasNoReadingBeforeTheFirstSentence) {
  step();
  EXPECT_FALSE(sensor_board_.compass());
}

TEST_F(SensorBoardOnText, PutsTogetherASentenceThatComesByteByByte) {
  const std::string_view sentence = testing::kCompassLines[1].sentence;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    EXPECT_FALSE(sensor_board_.compass());
    link_.says(sentence.substr(i, 1));
    step();
  }
  ASSERT_TRUE(sensor_board_.compass());
  EXPECT_NEAR(sensor_board_.compass()->yaw_from_north_rad, -kPi / 2, 1e-12);
}

TEST_F(SensorBoardOnText, CountsWhatIsWrongAndKeepsTheLastGoodReading) {
  link_.says(testing::kCompassLines[1].sentence);
  link_.says("$HCHDM,91.0,M*10\r\n");  // checksum of 90.0
  link_.says("$HCHDM,9\x01");
  link_.says("$HCHDM,,M*07\r\n");
  link_.says("$HCHDM,361.0,M*2D\r\n");
  link_.says("$HEHDT,274.07,T*19\r\n");
  link_.says("noise");
  step();
  EXPECT_NEAR(sensor_board_.compass()->yaw_from_north_rad, -kPi / 2, 1e-12);
  EXPECT_EQ(sensor_board_.health().headings, 1u);
  EXPECT_EQ(sensor_board_.health().bad_checksum, 1u);
  EXPECT_EQ(sensor_board_.health().bad_frame, 1u);
  EXPECT_EQ(sensor_board_.health().not_ready, 1u);
  EXPECT_EQ(sensor_board_.health().bad_heading, 1u);
  EXPECT_EQ(sensor_board_.health().other, 1u);
}

TEST_F(SensorBoardOnText, CorrectsAnHdgByItsDeviation) {
  link_.says("$HCHDG,80.0,10.0,E,12.6,W*6C\r\n");
  step();
  ASSERT_TRUE(sensor_board_.compass());
  EXPECT_NEAR(sensor_board_.compass()->yaw_from_north_rad, -kPi / 2, 1e-12);
}

TEST_F(SensorBoardOnText, WithdrawsAReadingThatHasGrownStale) {
  link_.says(testing::kCompassLines[0].sentence);
  step();
  for (int i = 0; i < 33; ++i) {
    step();
  }
  ASSERT_TRUE(sensor_board_.compass());
  EXPECT_EQ(sensor_board_.compass()->age, 33 * kTick);  // 495 ms
  step();
  EXPECT_FALSE(sensor_board_.compass());
  EXPECT_EQ(sensor_board_.health().went_stale, 1u);
  link_.says(testing::kCompassLines[0].sentence);
  step();
  EXPECT_TRUE(sensor_board_.compass());
}

TEST_F(SensorBoardOnText, DoesNotJoinHalvesOfSentencesAcrossALostLink) {
  link_.says("$HCHDM,2");
  step();
  link_.up = false;
  step();
  link_.up = true;
  link_.says("70.0,M*2C\r\n");
  step();
  EXPECT_FALSE(sensor_board_.compass());
  EXPECT_EQ(sensor_board_.health().link_lost, 1u);
}

TEST_F(SensorBoardOnText, NeverCrashesOnNoiseAndHearsTheSentenceBehindIt) {
  RandomStream random{4800};
  for (int i = 0; i < 2'000; ++i) {
    std::string noise(random.below(200), ' ');
    for (char& c : noise) {
      c = static_cast<char>(random.below(256));
    }
    link_.says(noise);
    step();
  }
  link_.says("\r\n");
  link_.says(testing::kCompassLines[2].sentence);
  step();
  ASSERT_TRUE(sensor_board_.compass());
  EXPECT_NEAR(sensor_board_.compass()->yaw_from_north_rad, kPi / 2, 1e-12);
}

/// A sentence of distances, framed.
std::string distances(std::initializer_list<Distance> said) {
  const Bytes bytes = encode_distances(std::vector<Distance>(said));
  return {bytes.begin(), bytes.end()};
}

TEST_F(SensorBoardOnText, GivesARoundOfItsRangefindersWhenTheLastOfThemHasSpoken) {
  link_.says(distances({{0, 0.85}, {1, std::nullopt}, {2, 3.2}, {3, std::nullopt}, {4, 3.1}}));
  step();
  EXPECT_FALSE(sensor_board_.sonars());
  link_.says(distances({{5, 1.1}, {6, 0.87}}));
  step();
  ASSERT_TRUE(sensor_board_.sonars());
  EXPECT_EQ(sensor_board_.sonars()->stamp, now_);
  EXPECT_EQ(sensor_board_.sonars()->range_m[0], 0.85);
  EXPECT_FALSE(sensor_board_.sonars()->range_m[1]);
  EXPECT_EQ(sensor_board_.sonars()->range_m[6], 0.87);
  EXPECT_EQ(sensor_board_.health().sonar_rounds, 1u);
}

TEST_F(SensorBoardOnText, ForgetsRangesThatAreNoLongerTold) {
  link_.says(distances({{0, 0.85}, {6, 0.87}}));
  step();
  for (int i = 0; i < 40; ++i) {
    step();
  }
  EXPECT_FALSE(sensor_board_.sonars()) << "600 ms old";
  link_.says(distances({{6, 0.9}}));
  step();
  ASSERT_TRUE(sensor_board_.sonars());
  EXPECT_FALSE(sensor_board_.sonars()->range_m[0]) << "its sentence got lost";
  EXPECT_EQ(sensor_board_.sonars()->range_m[6], 0.9);
}

TEST_F(SensorBoardOnText, CountsDistancesThatItCannotRead) {
  const Bytes broken = encode_nmea("YXXDR,D,1.0,f,S0");
  link_.says({reinterpret_cast<const char*>(broken.data()), broken.size()});
  step();
  EXPECT_EQ(sensor_board_.health().bad_distances, 1u);
}

}  // namespace
}  // namespace sensotwin::robot
