// SPDX-License-Identifier: MIT
#include "twin/devices/wheel_counter.hpp"

#include <gtest/gtest.h>

#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

constexpr double kTurn_rad = 2.0 * robot::kPi;

class WheelCounterTest : public ::testing::Test {
 protected:
  int turn_to(double angle_rad, double target_mps) { return counter_.update(angle_rad, target_mps); }
  WheelCounter counter_{508.8, 1.5, robot::Ticks{65400}};
};

TEST_F(WheelCounterTest, CountsFiveHundredAndEightCountsInAWholeTurnAndWraps) {
  turn_to(0.0, 0.2);
  EXPECT_EQ(turn_to(kTurn_rad, 0.2), 508);
  EXPECT_EQ(counter_.ticks() - robot::Ticks{65400}, 508);
  EXPECT_EQ(counter_.ticks(), robot::Ticks{372});
}

TEST_F(WheelCounterTest, LosesNoFractionsOverAThousandTurns) {
  turn_to(0.0, 0.2);
  int counts = 0;
  for (int i = 1; i <= 100'000; ++i) {
    counts += turn_to(i * 0.01 * kTurn_rad, 0.2);
  }
  EXPECT_NEAR(counts, 508'800, 1);
}

// Page 30: "if the robot is trying to drive forward, and you force the wheels to spin in reverse, the
// encoders will count up".
TEST_F(WheelCounterTest, CountsInTheCommandedDirectionWhenTheWheelIsForcedTheOtherWay) {
  turn_to(0.0, 0.2);
  EXPECT_GT(turn_to(-1.0, 0.2), 0);
  for (int i = 0; i < 40; ++i) {
    turn_to(-1.0, -0.2);
  }
  EXPECT_LT(turn_to(0.0, -0.2), 0);
}

TEST_F(WheelCounterTest, CountsUpWhenAStandingWheelIsPushedEitherWay) {
  for (int i = 0; i < 10; ++i) {
    turn_to(0.0, 0.0);
  }
  EXPECT_GT(turn_to(1.0, 0.0), 0);
  EXPECT_GT(turn_to(0.0, 0.0), 0);
}

TEST_F(WheelCounterTest, CountsARunOutAfterReversingTheWayTheWheelGoes) {
  double angle_rad = 0.0;
  for (int i = 0; i < 40; ++i) {
    angle_rad -= 0.08;
    turn_to(angle_rad, -0.2);
  }
  // Told to stop, the wheel takes 0.2 / 1.5 s = 9 ticks.
  int counts = 0;
  for (int i = 0; i < 9; ++i) {
    angle_rad -= 0.08 * (1.0 - i / 9.0);
    counts += turn_to(angle_rad, 0.0);
  }
  EXPECT_NEAR(counts, -0.08 * 5.0 * 508.8 / kTurn_rad, 2.0);
}

}  // namespace
}  // namespace sensotwin::twin
