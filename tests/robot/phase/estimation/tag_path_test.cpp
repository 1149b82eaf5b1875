// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/tag_path.hpp"

#include <gtest/gtest.h>

#include <array>

#include "robot/phase/estimation/line_follower.hpp"

namespace sensotwin::robot {
namespace {

TEST(TagPath, CountsARobotLeftOfItsLinePositive) {
  const PathReference r = on_line({0.0, 0.0}, {0.0, 5.0}, {-0.2, 2.0});
  EXPECT_NEAR(r.across_m, 0.2, 1e-12);
  EXPECT_NEAR(r.to_go_m, 3.0, 1e-12);
  EXPECT_NEAR(r.yaw_rad, kPi / 2.0, 1e-12);
}

TEST(SmoothLeg, PassesThroughBothItsTagsAndLeavesTheFirstAsThePreviousLegCame) {
  const Vec2 p0{0.0, 0.0};
  const Vec2 p1{1.0, 0.5};
  const Vec2 p2{2.5, 0.0};
  const Vec2 p3{3.0, -1.0};
  const SmoothLeg before{std::nullopt, p0, p1, p2};
  const SmoothLeg after{p0, p1, p2, p3};
  EXPECT_LT((after.point_m(0.0) - p1).norm(), 1e-12);
  EXPECT_LT((after.point_m(1.0) - p2).norm(), 1e-12);
  const double in = before.at(p1 - Vec2{1e-9, 0.0}).yaw_rad;
  const double out = after.at(p1 + Vec2{1e-9, 0.0}).yaw_rad;
  EXPECT_NEAR(in, out, 1e-6);
}

TEST(SmoothLeg, KeepsOffTheCircleOfEightTagsByTheShareOfItsRadiusThatTheStudyFound) {
  // Algorithms study, A.5: 0.85 % of the radius for 8 tags.
  const auto tag = [](int i) { return Vec2{2.0 * std::cos(kPi / 4.0 * i), 2.0 * std::sin(kPi / 4.0 * i)}; };
  const SmoothLeg leg{tag(-1), tag(0), tag(1), tag(2)};
  double furthest = 0.0;
  for (int i = 0; i <= 100; ++i) {
    furthest = std::max(furthest, std::abs(leg.point_m(i / 100.0).norm() - 2.0));
  }
  EXPECT_NEAR(furthest / 2.0, 0.0085, 0.0005);
}

TEST(TagPath, FindsTheCircleThroughThreeTags) {
  const std::array<Vec2, 3> tags{Vec2{3.0, 1.0}, Vec2{1.0, 3.0}, Vec2{-1.0, 1.0}};
  const std::optional<Circle> circle = circle_through(tags);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius_m, 2.0, 1e-9);
  EXPECT_LT((circle->centre_m - Vec2(1.0, 1.0)).norm(), 1e-9);
}

TEST(TagPath, FindsNoCircleThroughTagsOnALine) {
  const std::array<Vec2, 3> tags{Vec2{0.0, 0.0}, Vec2{1.0, 1.0}, Vec2{2.0, 2.0}};
  EXPECT_FALSE(circle_through(tags));
}

TEST(TagPath, GoesRoundACircleCounterClockwiseWithItsInsideOnTheLeft) {
  const PathReference r = on_circle({{0.0, 0.0}, 2.0}, true, {2.0, 0.0}, {0.0, 2.0}, {1.9, 0.0});
  EXPECT_NEAR(r.across_m, 0.1, 1e-12);
  EXPECT_NEAR(r.yaw_rad, kPi / 2.0, 1e-12);
  EXPECT_NEAR(r.to_go_m, kPi, 1e-9);
  EXPECT_NEAR(r.curvature_per_m, 0.5, 1e-12);
}

TEST(LineFollower, SteersBackToItsLineFromTheLeft) {
  const FollowerConfig config;
  const WheelSpeeds w = follow(config, on_line({0.0, 0.0}, {5.0, 0.0}, {1.0, 0.1}), 0.0, 0.2);
  EXPECT_GT(w.left_mps, w.right_mps);
  EXPECT_NEAR((w.left_mps + w.right_mps) / 2.0, 0.2, 1e-12);
}

TEST(LineFollower, NeverAsksMoreOfAWheelThanItCan) {
  const FollowerConfig config;
  for (double yaw = -3.0; yaw <= 3.0; yaw += 0.1) {
    const WheelSpeeds w = follow(config, on_line({0.0, 0.0}, {5.0, 0.0}, {1.0, 2.0}), yaw, 0.2);
    EXPECT_LE(std::abs(w.left_mps), 0.5 + 1e-12);
    EXPECT_LE(std::abs(w.right_mps), 0.5 + 1e-12);
  }
}

}  // namespace
}  // namespace sensotwin::robot
