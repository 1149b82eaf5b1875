// SPDX-License-Identifier: MIT
#include "robot/base/time.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

TEST(RobotTime, BeginsAtZero) {
  EXPECT_EQ(to_s(Instant{}), 0.0);
}

TEST(RobotTime, CountsTheSensorUpdatesOfTheOpenInterface) {
  EXPECT_EQ(kTick, std::chrono::milliseconds{15});
  EXPECT_DOUBLE_EQ(to_s(Instant{} + 200 * kTick), 3.0);
}

TEST(RobotTime, RoundsSecondsToTheNearestNanosecondOnBothSidesOfZero) {
  EXPECT_EQ(from_s(3.4), std::chrono::milliseconds{3400});
  EXPECT_EQ(from_s(-3.4), std::chrono::milliseconds{-3400});
  EXPECT_EQ(from_s(1.4e-9).count(), 1);
  EXPECT_EQ(from_s(1.6e-9).count(), 2);
  EXPECT_EQ(from_s(-1.4e-9).count(), -1);
  EXPECT_EQ(from_s(-1.6e-9).count(), -2);
}

TEST(RobotTime, LosesNoNanosecondInADayOfTicks) {
  // A sum of doubles would be off by microseconds after the 5.76 million ticks of a day.
  Instant now;
  for (int i = 0; i < 5'760'000; ++i) {
    now += kTick;
  }
  EXPECT_EQ(now.time_since_epoch(), std::chrono::hours{24});
}

}  // namespace
}  // namespace sensotwin::robot
