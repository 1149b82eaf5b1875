// SPDX-License-Identifier: MIT
#include "robot/base/geometry.hpp"

#include <gtest/gtest.h>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// A few additions and multiplications of numbers of the size of a house, in double: 1e-12 m is ample.
constexpr double kRounding = 1e-12;

Pose2 any_pose(RandomStream& random) {
  return {{random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)}, random.uniform(-kPi, kPi)};
}

void expect_same(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR((a.p_m - b.p_m).norm(), 0.0, kRounding);
  EXPECT_NEAR(wrap_angle(a.yaw_rad - b.yaw_rad), 0.0, kRounding);
}

TEST(Angles, LieAboveMinusPiAndUpToPi) {
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi) << "the two ends are one direction, and it has one name";
  EXPECT_DOUBLE_EQ(wrap_angle(0.0), 0.0);
  EXPECT_NEAR(wrap_angle(3.0 * kPi / 2.0), -kPi / 2.0, kRounding);
}

TEST(Angles, KeepTheirDirectionWhenWrapped) {
  RandomStream random = RandomStream{1}.fork("angles");
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.uniform(-100.0, 100.0);
    const double wrapped = wrap_angle(angle);
    ASSERT_GT(wrapped, -kPi);
    ASSERT_LE(wrapped, kPi);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), kRounding);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), kRounding);
  }
}

TEST(Angles, TurnDegreesIntoRadiansAndBack) {
  EXPECT_DOUBLE_EQ(rad_from_deg(180.0), kPi);
  EXPECT_DOUBLE_EQ(deg_from_rad(rad_from_deg(38.0)), 38.0);
}

TEST(APose, LooksAlongItsYaw) {
  const Pose2 X_WR{{0.0, 0.0}, kPi / 2.0};
  EXPECT_NEAR((X_WR.direction() - Vec2{0.0, 1.0}).norm(), 0.0, kRounding) << "REP-103: y is to the left of x";
}

TEST(APose, CarriesAPointFromTheInnerFrameToTheOuterOne) {
  // The robot stands at (2, 1) and looks north; what is 0.3 m before it and 0.1 m to its left:
  const Pose2 X_WR{{2.0, 1.0}, kPi / 2.0};
  EXPECT_NEAR((X_WR * Vec2{0.3, 0.1} - Vec2{1.9, 1.3}).norm(), 0.0, kRounding);
}

TEST(APose, ComposesWithTheInnerLettersMeeting) {
  const Pose2 X_WR{{2.0, 1.0}, kPi / 2.0};
  const Pose2 X_RA{{0.1, 0.0}, -kPi / 2.0};
  expect_same(X_WR * X_RA, {{2.0, 1.1}, 0.0});
}

TEST(APose, TimesItsInverseIsNoMotion) {
  RandomStream random = RandomStream{2}.fork("poses");
  for (int i = 0; i < 200; ++i) {
    const Pose2 X_AB = any_pose(random);
    expect_same(X_AB * X_AB.inverse(), {});
    expect_same(X_AB.inverse() * X_AB, {});
  }
}

TEST(APose, ComposesInAnyGrouping) {
  RandomStream random = RandomStream{3}.fork("poses");
  for (int i = 0; i < 200; ++i) {
    const Pose2 X_AB = any_pose(random);
    const Pose2 X_BC = any_pose(random);
    const Vec2 p_C{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
    const Vec2 p_A = (X_AB * X_BC) * p_C;
    EXPECT_NEAR((p_A - X_AB * (X_BC * p_C)).norm(), 0.0, kRounding);
  }
}

}  // namespace
}  // namespace sensotwin::robot
