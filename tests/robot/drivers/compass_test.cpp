// SPDX-License-Identifier: MIT
#include "robot/drivers/compass.hpp"

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

class CompassOnText : public ::testing::Test {
 protected:
  void step() {
    now_ += kTick;
    compass_.step(now_);
  }
  TextLink link_;
  Compass compass_{link_};
  Instant now_{};
};

TEST_F(CompassOnText, TurnsClockwiseHeadingsIntoCounterClockwiseYaw) {
  for (const auto& line : testing::kCompassLines) {
    link_.says(line.sentence);
    step();
    ASSERT_TRUE(compass_.reading());
    EXPECT_NEAR(compass_.reading()->yaw_from_north_rad, line.yaw_from_north_rad, 1e-12) << line.sentence;
    EXPECT_EQ(compass_.reading()->stamp, now_);
  }
}

TEST_F(CompassOnText, HasNoReadingBeforeTheFirstSentence) {
  step();
  EXPECT_FALSE(compass_.reading());
}

TEST_F(CompassOnText, PutsTogetherASentenceThatComesByteByByte) {
  const std::string_view sentence = testing::kCompassLines[1].sentence;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    EXPECT_FALSE(compass_.reading());
    link_.says(sentence.substr(i, 1));
    step();
  }
  ASSERT_TRUE(compass_.reading());
  EXPECT_NEAR(compass_.reading()->yaw_from_north_rad, -kPi / 2, 1e-12);
}

TEST_F(CompassOnText, CountsWhatIsWrongAndKeepsTheLastGoodReading) {
  link_.says(testing::kCompassLines[1].sentence);
  link_.says("$HCHDM,91.0,M*10\r\n");  // checksum of 90.0
  link_.says("$HCHDM,9\x01");
  link_.says("$HCHDM,,M*07\r\n");
  link_.says("$HCHDM,361.0,M*2D\r\n");
  link_.says("$HEHDT,274.07,T*19\r\n");
  link_.says("noise");
  step();
  EXPECT_NEAR(compass_.reading()->yaw_from_north_rad, -kPi / 2, 1e-12);
  EXPECT_EQ(compass_.health().headings, 1u);
  EXPECT_EQ(compass_.health().bad_checksum, 1u);
  EXPECT_EQ(compass_.health().bad_frame, 1u);
  EXPECT_EQ(compass_.health().not_ready, 1u);
  EXPECT_EQ(compass_.health().bad_heading, 1u);
  EXPECT_EQ(compass_.health().other, 1u);
}

TEST_F(CompassOnText, CorrectsAnHdgByItsDeviation) {
  link_.says("$HCHDG,80.0,10.0,E,12.6,W*6C\r\n");
  step();
  ASSERT_TRUE(compass_.reading());
  EXPECT_NEAR(compass_.reading()->yaw_from_north_rad, -kPi / 2, 1e-12);
}

TEST_F(CompassOnText, WithdrawsAReadingThatHasGrownStale) {
  link_.says(testing::kCompassLines[0].sentence);
  step();
  for (int i = 0; i < 33; ++i) {
    step();
  }
  ASSERT_TRUE(compass_.reading());
  EXPECT_EQ(compass_.reading()->age, 33 * kTick);  // 495 ms
  step();
  EXPECT_FALSE(compass_.reading());
  EXPECT_EQ(compass_.health().went_stale, 1u);
  link_.says(testing::kCompassLines[0].sentence);
  step();
  EXPECT_TRUE(compass_.reading());
}

TEST_F(CompassOnText, DoesNotJoinHalvesOfSentencesAcrossALostLink) {
  link_.says("$HCHDM,2");
  step();
  link_.up = false;
  step();
  link_.up = true;
  link_.says("70.0,M*2C\r\n");
  step();
  EXPECT_FALSE(compass_.reading());
  EXPECT_EQ(compass_.health().link_lost, 1u);
}

TEST_F(CompassOnText, NeverCrashesOnNoiseAndHearsTheSentenceBehindIt) {
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
  ASSERT_TRUE(compass_.reading());
  EXPECT_NEAR(compass_.reading()->yaw_from_north_rad, kPi / 2, 1e-12);
}

/// A sentence of distances, framed.
std::string distances(std::initializer_list<Distance> said) {
  const Bytes bytes = encode_distances(std::vector<Distance>(said));
  return {bytes.begin(), bytes.end()};
}

TEST_F(CompassOnText, GivesARoundOfItsRangefindersWhenTheLastOfThemHasSpoken) {
  link_.says(distances({{0, 0.85}, {1, std::nullopt}, {2, 3.2}, {3, std::nullopt}, {4, 3.1}}));
  step();
  EXPECT_FALSE(compass_.sonars());
  link_.says(distances({{5, 1.1}, {6, 0.87}}));
  step();
  ASSERT_TRUE(compass_.sonars());
  EXPECT_EQ(compass_.sonars()->stamp, now_);
  EXPECT_EQ(compass_.sonars()->range_m[0], 0.85);
  EXPECT_FALSE(compass_.sonars()->range_m[1]);
  EXPECT_EQ(compass_.sonars()->range_m[6], 0.87);
  EXPECT_EQ(compass_.health().sonar_rounds, 1u);
}

TEST_F(CompassOnText, ForgetsRangesThatAreNoLongerTold) {
  link_.says(distances({{0, 0.85}, {6, 0.87}}));
  step();
  for (int i = 0; i < 40; ++i) {
    step();
  }
  EXPECT_FALSE(compass_.sonars()) << "600 ms old";
  link_.says(distances({{6, 0.9}}));
  step();
  ASSERT_TRUE(compass_.sonars());
  EXPECT_FALSE(compass_.sonars()->range_m[0]) << "its sentence got lost";
  EXPECT_EQ(compass_.sonars()->range_m[6], 0.9);
}

TEST_F(CompassOnText, CountsDistancesThatItCannotRead) {
  const Bytes broken = encode_nmea("YXXDR,D,1.0,f,S0");
  link_.says({reinterpret_cast<const char*>(broken.data()), broken.size()});
  step();
  EXPECT_EQ(compass_.health().bad_distances, 1u);
}

}  // namespace
}  // namespace sensotwin::robot
