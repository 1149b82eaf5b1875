// SPDX-License-Identifier: MIT
#include "robot/mapping/pose_track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

const Vec2 kX{1.0, 0.0};
const Vec2 kY{0.0, 1.0};

/// Straight ahead in steps of a tick at 0.3 m/s.
void drive_straight(PoseTrack& track, double distance_m) {
  const int steps = static_cast<int>(std::lround(std::abs(distance_m) / 0.0045));
  for (int i = 0; i < steps; ++i) {
    track.drive(distance_m / steps, distance_m / steps);
  }
}

void turn(PoseTrack& track, double rad) {
  const double wheel_m = rad * OdometryModel{}.wheel_base_m / 2.0;
  for (int i = 0; i < 100; ++i) {
    track.drive(-wheel_m / 100, wheel_m / 100);
  }
}

PoseTrack surely_at(const Pose2& X_MR, const OdometryModel& model = {}) {
  PoseTrack track{model, CompassModel{}};
  track.reset(X_MR, 0.0, 0.0);
  return track;
}

TEST(APoseTrack, FollowsTheEncodersOfAnUnbiasedRobot) {
  PoseTrack track = surely_at({});
  drive_straight(track, 1.0);
  EXPECT_NEAR(track.pose().p_m.x(), 1.0, 1e-9);
  turn(track, kPi / 2.0);
  EXPECT_NEAR(track.pose().yaw_rad, kPi / 2.0, 1e-9);
  drive_straight(track, -0.5);
  EXPECT_NEAR((track.pose().p_m - Vec2{1.0, -0.5}).norm(), 0.0, 1e-9);
}

// One metre straight on, from a pose known exactly. Along: the scale's 1 % and 8 mm of noise. Across: 10 mm
// of noise; a heading that walks at h rad/sqrt(m) leaves h L^1.5 / sqrt 3; a constant curvature k leaves k
// L^2 / 2.
TEST(APoseTrack, GrowsUnsureAsItsModelSays) {
  const OdometryModel model;
  PoseTrack track = surely_at({}, model);
  drive_straight(track, 1.0);
  EXPECT_NEAR(track.position_sigma_m(kX), std::hypot(model.scale_sigma, model.along_sigma_m), 0.0002);
  const double walk = model.heading_sigma_rad / std::sqrt(3.0);
  const double bend = model.curvature_sigma_rad_per_m / 2.0;
  EXPECT_NEAR(track.position_sigma_m(kY), std::hypot(model.across_sigma_m, walk, bend), 0.0004)
      << "2 cm steps of the covariance cost 2 % of it";
  EXPECT_NEAR(track.yaw_sigma_rad(), std::hypot(model.heading_sigma_rad, model.curvature_sigma_rad_per_m),
              0.0002);
}

TEST(APoseTrack, GrowsUnsureOfItsHeadingWhenItTurns) {
  const OdometryModel model;
  PoseTrack track = surely_at({}, model);
  turn(track, kPi / 2.0);
  const double systematic = model.turn_scale_sigma * kPi / 2.0;
  const double noise = model.turn_sigma_rad * std::sqrt(kPi / 2.0);
  EXPECT_NEAR(track.yaw_sigma_rad(), std::hypot(systematic, noise), 0.0005);
}

TEST(APoseTrack, TakesAPreciseMeasurementForTheTruth) {
  PoseTrack track{OdometryModel{}, CompassModel{}};
  track.reset({}, 0.03, 0.05);
  track.correct_position(kY, 0.02, 0.0001);
  EXPECT_NEAR(track.pose().p_m.y(), 0.02, 0.0001);
  EXPECT_NEAR(track.position_sigma_m(kY), 0.0001, 1e-6);
  EXPECT_NEAR(track.position_sigma_m(kX), 0.03, 1e-9) << "what was not measured stays as it was";
}

TEST(APoseTrack, MeetsAnEquallySureMeasurementHalfWay) {
  PoseTrack track{OdometryModel{}, CompassModel{}};
  track.reset({}, 0.03, 0.05);
  track.correct_position(kY, 0.02, 0.03);
  EXPECT_NEAR(track.pose().p_m.y(), 0.01, 1e-9);
  EXPECT_NEAR(track.position_sigma_m(kY), 0.03 / std::sqrt(2.0), 1e-9);
}

TEST(APoseTrack, ThinksAnExpectedMeasurementLikelierThanASurprisingOne) {
  PoseTrack expected{OdometryModel{}, CompassModel{}};
  expected.reset({}, 0.03, 0.05);
  PoseTrack surprised = expected;
  const double likely = expected.correct_position(kY, 0.0, 0.01);
  const double unlikely = surprised.correct_position(kY, 0.10, 0.01);
  // Log of a normal density: half of the square of the innovation in standard deviations, hypot(3 cm, 1 cm).
  EXPECT_NEAR(likely - unlikely, 0.5 * 0.10 * 0.10 / (0.03 * 0.03 + 0.01 * 0.01), 1e-9);
}

TEST(APoseTrack, LearnsFromItsFirstCompassReadingOnlyWhereNorthIs) {
  PoseTrack track{OdometryModel{}, CompassModel{}};
  track.reset({{0.0, 0.0}, 0.3}, 0.01, 0.05);
  track.correct_by_compass(2.0);
  EXPECT_NEAR(track.pose().yaw_rad, 0.3, 1e-9);
  EXPECT_NEAR(track.yaw_sigma_rad(), 0.05, 1e-4);
}

// Counted 90 degrees, turned 95. The wheels' quarter turn is known to hypot(2 % of it, 3 % sqrt of it) =
// 0.049 rad; two readings to 0.026 each and the bias's walk of 0.021: 0.042. The truth is believed by 0.049^2
// / (0.049^2 + 0.042^2).
TEST(APoseTrack, TakesTheCompassesWordForATurnOnTheSpot) {
  for (const double facing : {0.0, kPi - 0.4}) {
    PoseTrack track = surely_at({{0.0, 0.0}, facing});
    track.correct_by_compass(wrap_angle(facing + 1.0));
    turn(track, kPi / 2.0);
    track.correct_by_compass(wrap_angle(facing + 1.0 + rad_from_deg(95)));
    const double taken_deg = deg_from_rad(wrap_angle(track.pose().yaw_rad - facing)) - 90.0;
    EXPECT_NEAR(taken_deg, 5.0 * 0.58, 0.4) << "facing " << facing;
  }
}

TEST(APoseTrack, GrowsUnsureByTheWayRolledWhileItTouchesSomething) {
  const OdometryModel model;
  PoseTrack track = surely_at({});
  for (int i = 0; i < 4; ++i) {
    track.drive(0.005, 0.005, kPi / 2.0);
  }
  EXPECT_NEAR(track.position_sigma_m(kY),
              std::hypot(0.02 * model.touch_sigma_m_per_m, model.across_sigma_m * std::sqrt(0.02)), 1e-4);
  EXPECT_GT(track.yaw_sigma_rad(), 0.02 * model.touch_sigma_rad_per_m);
}

TEST(APoseTrack, DoesNotGoIntoWhatItTouchesWhateverTheWheelsCount) {
  PoseTrack ahead = surely_at({});
  ahead.drive(0.01, 0.01, 0.0);
  EXPECT_NEAR(ahead.pose().p_m.norm(), 0.0, 1e-12);

  // At 45 degrees on the left, half the way is left, to the right along what is touched.
  PoseTrack aslant = surely_at({});
  aslant.drive(0.01, 0.01, kPi / 4.0);
  EXPECT_NEAR(aslant.pose().p_m.x(), 0.005, 1e-12);
  EXPECT_NEAR(aslant.pose().p_m.y(), -0.005, 1e-12);
}

TEST(APoseTrack, BacksAwayFromWhatItTouchesAsTheWheelsCount) {
  PoseTrack track = surely_at({});
  track.drive(-0.01, -0.01, 0.0);
  EXPECT_NEAR(track.pose().p_m.x(), -0.01, 1e-12);
}

TEST(APoseTrack, LearnsFromPlacesAlongTheWayThatItsWheelsAreSmallerThanItThought) {
  // The wheels roll 2 % less than counted; each tile of a row tells where along it the robot is.
  PoseTrack track = surely_at({});
  double travelled_m = 0.0;
  for (int tile = 0; tile < 12; ++tile) {
    drive_straight(track, 0.508);
    travelled_m += 0.508 * 0.98;
    track.correct_position(kX, travelled_m, 0.006);
  }
  track.reset({}, 0.0, 0.0);
  drive_straight(track, 1.0);
  EXPECT_NEAR(track.pose().p_m.x(), 0.98, 0.004) << "learned, and kept through a new pose";
}

TEST(APoseTrack, DoubtsItsPlaceByTheFactorAskedForAndItsHeadingNoMoreThanTheCompassLeavesOpen) {
  PoseTrack track{OdometryModel{}, CompassModel{}};
  track.reset({{1.0, 2.0}, 0.3}, 0.02, 0.05);
  track.doubt(4.0);
  EXPECT_NEAR(track.position_sigma_m(kX), 0.08, 1e-9);
  EXPECT_NEAR(track.yaw_sigma_rad(), 0.17, 1e-9) << "twice the 5 degrees by which iron bends the needle";
  EXPECT_EQ(track.pose().p_m, Vec2(1.0, 2.0));
}

TEST(APoseTrack, MeasuresTheWaySinceItsMarkThroughCorrections) {
  PoseTrack track{OdometryModel{}, CompassModel{}};
  track.reset({}, 0.03, 0.05);
  drive_straight(track, 0.2);
  track.mark(0.005);
  drive_straight(track, 0.1);
  track.correct_position(kX, 0.35, 0.005);
  EXPECT_NEAR(track.since_mark_m().x(), 0.105, 1e-9) << "a chord is the wheels' word, not the map's";
}

/// A robot whose errors are drawn from the model itself, and its own idea of where it is.
struct Pair {
  Pose2 truth;
  PoseTrack track;
  double scale;
  double turn_scale;
  double curvature;
  RandomStream random;

  Pair(const OdometryModel& model, RandomStream stream)
      : track(model, CompassModel{}),
        scale(model.scale_sigma * stream.normal()),
        turn_scale(model.turn_scale_sigma * stream.normal()),
        curvature(model.curvature_sigma_rad_per_m * stream.normal()),
        random(stream) {
    track.reset({}, 0.0, 0.0);
  }
  void drive(const OdometryModel& model, double left_m, double right_m) {
    const double d = (left_m + right_m) / 2.0;
    const double turn = (right_m - left_m) / model.wheel_base_m;
    const double root_m = std::sqrt(std::abs(d));
    const double d_true = d * (1.0 + scale) + model.along_sigma_m * root_m * random.normal();
    const double aside = model.across_sigma_m * root_m * random.normal();
    const double turn_true = turn * (1.0 + turn_scale) + curvature * d +
                             model.heading_sigma_rad * root_m * random.normal() +
                             model.turn_sigma_rad * std::sqrt(std::abs(turn)) * random.normal();
    const double yaw = truth.yaw_rad + turn_true / 2.0;
    truth.p_m += d_true * Vec2{std::cos(yaw), std::sin(yaw)} + aside * Vec2{-std::sin(yaw), std::cos(yaw)};
    truth.yaw_rad = wrap_angle(truth.yaw_rad + turn_true);
    track.drive(left_m, right_m);
  }
};

TEST(APoseTrack, IsAsUnsureAsItIsWrong) {
  // A square with a side of one tile and a half, then a measurement, then another side. The squares of the
  // errors in standard deviations have mean 1; 500 runs tell it with a standard deviation of sqrt(2/500) =
  // 0.063.
  const OdometryModel model;
  const RandomStream random = RandomStream{5}.fork("pose track");
  constexpr int kRuns = 500;
  double along = 0.0;
  double across = 0.0;
  double heading = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    Pair pair{model, random.fork(std::to_string(run))};
    const double quarter_m = model.wheel_base_m * kPi / 4.0;
    for (int side = 0; side < 5; ++side) {
      for (int i = 0; i < 170; ++i) {
        pair.drive(model, 0.0045, 0.0045);
      }
      if (side == 3) {
        const double seen = pair.truth.p_m.x() + 0.01 * pair.random.normal();
        pair.track.correct_position(kX, seen, 0.01);
      }
      for (int i = 0; side < 4 && i < 60; ++i) {
        pair.drive(model, -quarter_m / 60, quarter_m / 60);
      }
    }
    const Vec2 off = pair.truth.p_m - pair.track.pose().p_m;
    along += std::pow(off.x() / pair.track.position_sigma_m(kX), 2) / kRuns;
    across += std::pow(off.y() / pair.track.position_sigma_m(kY), 2) / kRuns;
    heading +=
        std::pow(wrap_angle(pair.truth.yaw_rad - pair.track.pose().yaw_rad) / pair.track.yaw_sigma_rad(), 2) /
        kRuns;
  }
  EXPECT_NEAR(along, 1.0, 4 * 0.063);
  EXPECT_NEAR(across, 1.0, 4 * 0.063);
  EXPECT_NEAR(heading, 1.0, 4 * 0.063);
}

}  // namespace
}  // namespace sensotwin::robot
