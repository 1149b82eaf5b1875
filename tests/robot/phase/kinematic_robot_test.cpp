// SPDX-License-Identifier: MIT
#include "tests/robot/phase/kinematic_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/phase/phase_experiments.hpp"

namespace sensotwin::robot::testing {
namespace {

constexpr KinematicErrors kNoErrors{.scale = 0.0,
                                    .turn_scale = 0.0,
                                    .curvature_rad_per_m = 0.0,
                                    .along_m = 0.0,
                                    .heading_rad = 0.0,
                                    .compass_rad = {}};

KinematicRadio silent_air() {
  KinematicRadio radio;
  radio.noise_rad_per_m = 0.0;
  return radio;
}

constexpr PhaseCommand kAhead{{0.2, 0.2}};

TEST(KinematicRobot, CountsItsWheelsAsTheOpenInterfaceSays) {
  KinematicRobot robot{{}, {}, kNoErrors, silent_air(), 1};
  int left = 0;
  int right = 0;
  for (int i = 0; i < 1000; ++i) {
    const PhaseSensed& sensed = robot.step({{0.1, 0.2}});
    left += sensed.counts_left;
    right += sensed.counts_right;
  }
  EXPECT_NEAR(left, 0.1 * 15.0 / KinematicRobot::kMetresPerCount, 1.0);
  EXPECT_NEAR(right, 0.2 * 15.0 / KinematicRobot::kMetresPerCount, 1.0);
  EXPECT_NEAR(wrap_angle(robot.X_WR().yaw_rad - 0.1 / 0.235 * 15.0), 0.0, 1e-9);
}

TEST(KinematicRobot, ReadsBothPortsTwentyTimesASecondAtOneInstant) {
  KinematicRobot robot{hallway().tags, {}, kNoErrors, silent_air(), 1};
  std::size_t reads = 0;
  for (int i = 0; i < 1000; ++i) {
    for (const UhfRead& read : robot.step(kAhead).reads) {
      EXPECT_EQ(read.at.time_since_epoch() % std::chrono::milliseconds{50}, Duration{0});
      ++reads;
    }
  }
  EXPECT_EQ(reads, 7u * 2u * 300u);
}

TEST(KinematicRobot, ReadsPortsInTheirOrderWhenMultiplexed) {
  KinematicRadio radio = silent_air();
  radio.simultaneous = false;
  radio.port_order = {1, 2, 1};
  radio.slot_s = 0.025;
  KinematicRobot robot{line_at_90().tags, {}, kNoErrors, radio, 1};
  std::vector<std::uint16_t> ports;
  while (ports.size() < 12) {
    for (const UhfRead& read : robot.step(kAhead).reads) {
      ports.push_back(read.antenna);
    }
  }
  EXPECT_EQ(ports, (std::vector<std::uint16_t>{1, 1, 2, 2, 1, 1, 1, 1, 2, 2, 1, 1}));
}

TEST(KinematicRobot, HearsALesserPhaseOnTheSideOfTheTag) {
  KinematicRobot robot{{{.epc = experiment_epc(0), .at_m = {2.0, 1.0}}}, {}, kNoErrors, silent_air(), 1};
  const PhaseSensed& sensed = robot.step({});
  ASSERT_EQ(sensed.reads.size(), 2u);
  // Tag on the left: lateral offset 1 m at a slant of sqrt(2^2 + 1^2 + 2.9^2) (algorithms study, A.0).
  const double expected = -2.0 * kPi / 0.328 * 0.16 * 1.0 / std::sqrt(5.0 + 2.9 * 2.9);
  EXPECT_NEAR(wrap_angle(sensed.reads[0].phase_rad - sensed.reads[1].phase_rad), expected, 0.001);
}

TEST(KinematicRobot, CoversTheGroundByItsOwnErrorsOnly) {
  double squares = 0.0;
  constexpr int kRuns = 400;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    KinematicRobot robot{{}, {}, KinematicErrors{}, silent_air(), seed};
    for (int i = 0; i < 1000; ++i) {
      (void)robot.step(kAhead);
    }
    squares += std::pow(robot.X_WR().p_m.x() - 3.0, 2);
  }
  // 1 % of 3 m and 5 mm per root metre; the heading's share is below a millimetre. Tolerance: four sigmas of
  // a standard deviation estimated from so many runs.
  const double expected = std::hypot(0.03, 0.005 * std::sqrt(3.0));
  EXPECT_NEAR(std::sqrt(squares / kRuns), expected, 4.0 * expected / std::sqrt(2.0 * kRuns));
}

TEST(KinematicRobot, NamesAFloorTagOnceAsItEntersItsZoneAndSaysWhenItLeft) {
  KinematicRadio radio = silent_air();
  radio.floor_radius_m = 0.015;
  KinematicRobot robot{{{.epc = experiment_epc(4), .at_m = {0.3, 0.01}}}, {}, kNoErrors, radio, 1};
  int entered = 0;
  int left = 0;
  for (int i = 0; i < 200; ++i) {
    const PhaseSensed& sensed = robot.step(kAhead);
    entered += sensed.floor_tag == experiment_epc(4) ? 1 : 0;
    left += sensed.floor_tag_left ? 1 : 0;
  }
  EXPECT_EQ(entered, 1);
  EXPECT_EQ(left, 1);
}

TEST(KinematicRobot, IsSilentWhenItsReaderIs) {
  KinematicRobot robot{line_at_90().tags, {}, kNoErrors, silent_air(), 1};
  robot.silence(Instant{} + from_s(1.0), Instant{} + from_s(3.0), true);
  for (int i = 0; i < 400; ++i) {
    const PhaseSensed& sensed = robot.step(kAhead);
    if (sensed.stamp >= Instant{} + from_s(1.02) && sensed.stamp < Instant{} + from_s(3.0)) {
      EXPECT_TRUE(sensed.reads.empty());
      EXPECT_FALSE(sensed.reader_up);
    }
  }
}

TEST(PathScore, TakesTheDistanceToTheLineOfTheLegLeftPositive) {
  PathScore score{line_at_90()};
  score.sample(0, {-5, -5});
  score.sample(1, {-0.03, 2.0});
  score.sample(1, {0.04, 4.0});
  EXPECT_EQ(score.samples(), 2);
  EXPECT_NEAR(score.error_max_m(), 0.03, 1e-12);
  EXPECT_NEAR(score.error_min_m(), -0.04, 1e-12);
  EXPECT_NEAR(score.rmse_m(), std::sqrt((0.03 * 0.03 + 0.04 * 0.04) / 2.0), 1e-12);
}

}  // namespace
}  // namespace sensotwin::robot::testing
