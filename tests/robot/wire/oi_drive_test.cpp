// SPDX-License-Identifier: MIT
#include "robot/wire/oi_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sensotwin::robot::oi {
namespace {

constexpr double kWheelBase_m = 0.235;

void expect_wheels(const Drive& drive, double left_mps, double right_mps) {
  const WheelSpeeds wheels = wheel_speeds(drive, kWheelBase_m);
  EXPECT_NEAR(wheels.left_mps, left_mps, 1e-9);
  EXPECT_NEAR(wheels.right_mps, right_mps, 1e-9);
}

TEST(DriveRadius, IsStraightForBothSpecialValuesAndForZero) {
  expect_wheels({200, kStraight}, 0.2, 0.2);
  expect_wheels({200, kStraightToo}, 0.2, 0.2);
  expect_wheels({200, 0}, 0.2, 0.2);
}

TEST(DriveRadius, TurnsInPlaceForPlusAndMinusOne) {
  expect_wheels({100, kTurnCounterClockwise}, -0.1, 0.1);
  expect_wheels({100, kTurnClockwise}, 0.1, -0.1);
}

TEST(DriveRadius, IsPositiveToTheLeft) {
  expect_wheels({200, 500}, 0.2 * (1 - 0.235), 0.2 * (1 + 0.235));
  expect_wheels({200, -500}, 0.2 * (1 + 0.235), 0.2 * (1 - 0.235));
}

TEST(DriveRadius, KeepsTheRightWheelOuterWhenReversing) {
  expect_wheels({-200, 500}, -0.2 * (1 - 0.235), -0.2 * (1 + 0.235));  // the manual's own example
}

// SCI knows 0x8000 only: 0x7FFF is a very wide left arc there.
TEST(DriveRadius, OfAllOnesButTheSignIsAnArcOnARoomba400) {
  const WheelSpeeds wheels = wheel_speeds(Drive{200, kStraightToo}, 0.258, true);
  EXPECT_LT(wheels.left_mps, wheels.right_mps);
}

// The radius travels as a whole number of millimetres up to 2 m: an arc's wheels can be off by what half a
// millimetre of radius makes of them, or, between the widest arc and straight, by half of that arc's
// difference.
TEST(DriveFor, GivesBackTheWheelsWithinWhatTheRadiusCanSay) {
  for (int left = -300; left <= 300; left += 20) {
    for (int right = -300; right <= 300; right += 20) {
      const WheelSpeeds wanted{left * 1e-3, right * 1e-3};
      const Drive drive = drive_for(wanted, kWheelBase_m);
      EXPECT_TRUE(in_range(drive));
      const WheelSpeeds got = wheel_speeds(drive, kWheelBase_m);
      const double mean_mps = std::abs(left + right) * 0.5e-3;
      const double half_mps = std::abs(right - left) * 0.5e-3;
      const double radius_m = half_mps == 0.0 ? 1e9 : 0.5 * kWheelBase_m * mean_mps / half_mps;
      const double of_radius_mps = radius_m < 2e-3 ? mean_mps : half_mps * 0.5e-3 / (radius_m - 0.5e-3);
      const double of_width_mps = radius_m > 2.0 ? mean_mps * 0.5 * kWheelBase_m / 4.0 : 0.0;
      const double tolerance_mps =
          1e-3 * (1.0 + 0.5 * kWheelBase_m / radius_m) + of_radius_mps + of_width_mps;
      EXPECT_NEAR(got.left_mps, wanted.left_mps, tolerance_mps) << left << ' ' << right;
      EXPECT_NEAR(got.right_mps, wanted.right_mps, tolerance_mps) << left << ' ' << right;
    }
  }
}

TEST(DriveDirectFor, RoundsToTheNearestMillimetreAndClamps) {
  EXPECT_EQ(drive_direct_for({.left_mps = -0.1996, .right_mps = 0.7}),
            (DriveDirect{.right_mm_s = 500, .left_mm_s = -200}));
}

}  // namespace
}  // namespace sensotwin::robot::oi
