// SPDX-License-Identifier: MIT
#include "robot/calibration/wheel_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/base/time.hpp"
#include "robot/calibration/counted_way.hpp"

namespace sensotwin::robot {
namespace {

/// Drives squares of two tiles on tags that lie where they should, by wheels as they truly are, and logs what
/// they count: without noise, so that what is found must be the truth.
class ExactSquares {
 public:
  explicit ExactSquares(const OdometryModel& truth) : truth_(truth) {}

  WheelLog drive(int laps) {
    for (const bool clockwise : {false, true}) {
      for (int lap = 0; lap < laps; ++lap) {
        const std::size_t first = log_.crossings.size();
        for (int side = 0; side < 4; ++side) {
          roll(1.016);
          turn(clockwise ? -kPi / 2.0 : kPi / 2.0);
        }
        log_.laps.push_back({first, log_.crossings.size() - 1, clockwise});
      }
    }
    return log_;
  }

 private:
  /// \param left, right  ways of the wheels over the floor in one step, m
  void step(double left_m, double right_m) {
    const double mean = 2.0 / (1.0 + truth_.wheel_ratio) * truth_.metres_per_count;
    const CountedStep counts{whole(left_rest_, left_m / mean),
                             whole(right_rest_, right_m / (mean * truth_.wheel_ratio))};
    log_.steps.push_back(counts);
    const CountedWay way = counted_way(log_.steps, log_.steps.size() - 1, log_.steps.size(), truth_);
    X_ = X_ * way.X;
    watch();
  }
  static std::int16_t whole(double& rest, double counts) {
    const double all = rest + counts;
    const double down = std::floor(all);
    rest = all - down;
    return static_cast<std::int16_t>(down);
  }
  void roll(double way_m) {
    const Vec2 begin = X_.p_m;
    const Vec2 along{std::cos(goal_rad_), std::sin(goal_rad_)};
    while ((X_.p_m - begin).dot(along) < way_m) {
      const double steer_m = 0.0005 * wrap_angle(goal_rad_ - X_.yaw_rad);
      step(0.0015 - steer_m, 0.0015 + steer_m);
    }
  }
  void turn(double by_rad) {
    goal_rad_ = wrap_angle(goal_rad_ + by_rad);
    while (std::abs(wrap_angle(goal_rad_ - X_.yaw_rad)) > 0.01) {
      const double way_m = by_rad > 0.0 ? 0.001 : -0.001;
      step(-way_m, way_m);
    }
  }
  void watch() {
    const Tile nearest{static_cast<int>(std::lround(X_.p_m.x() / 0.508)),
                       static_cast<int>(std::lround(X_.p_m.y() / 0.508))};
    const bool over = (X_.p_m - 0.508 * Vec2{nearest.column, nearest.row}).norm() < 0.07;
    if (over != over_) {
      log_.crossings.push_back({log_.steps.size() - 1, over ? nearest : last_, over, X_});
    }
    over_ = over;
    last_ = nearest;
  }

  OdometryModel truth_;
  WheelLog log_;
  // A little beside the first tag, so that chords say on which side.
  Pose2 X_{{0.0, 0.03}, 0.0};
  double goal_rad_{0.0};
  double left_rest_{0.0};
  double right_rest_{0.0};
  bool over_{true};
  Tile last_;
};

OdometryModel other_wheels() {
  OdometryModel truth;
  truth.wheel_base_m = 0.246;
  truth.metres_per_count *= 1.012;
  truth.wheel_ratio = 0.993;
  return truth;
}

TEST(WheelFit, FindsWheelsThatDifferFromWhatIsToldInBaseScaleAndRatio) {
  const OdometryModel truth = other_wheels();
  const auto fit = fit_wheels(ExactSquares(truth).drive(2), {.read_radius_m = 0.08, .notice_delay_s = 0.0});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->wheel_base_m.value / truth.wheel_base_m, 1.0, 0.002);
  EXPECT_NEAR(fit->metres_per_count.value / truth.metres_per_count, 1.0, 0.002);
  EXPECT_NEAR(fit->wheel_ratio.value / truth.wheel_ratio, 1.0, 0.001);
  EXPECT_NEAR(fit->read_radius_m.value, 0.07, 0.002) << "told 0.08";
  EXPECT_EQ(fit->outliers, 0u);
  EXPECT_LT(fit->closure.after_m, 0.1 * fit->closure.before_m);
  EXPECT_LT(fit->relative_sigma_of_laps, fit->relative_sigma);
}

TEST(WheelFit, MoreLapsMakeItSurer) {
  const WheelPrior prior{.read_radius_m = 0.07};
  const auto few = fit_wheels(ExactSquares(other_wheels()).drive(1), prior);
  const auto many = fit_wheels(ExactSquares(other_wheels()).drive(6), prior);
  ASSERT_TRUE(few && many);
  EXPECT_LT(many->relative_sigma_of_laps, 0.6 * few->relative_sigma_of_laps);
}

TEST(WheelFit, CountsCrossingsThatFitNowhereAsOutliersAndIsHardlyMoved) {
  WheelLog log = ExactSquares(other_wheels()).drive(3);
  for (std::size_t i = 7; i < log.crossings.size(); i += 17) {
    log.crossings[i].step += 20;  // 3 cm late
  }
  const auto fit = fit_wheels(log, {.read_radius_m = 0.07, .notice_delay_s = 0.0});
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->outliers, 0u);
  EXPECT_NEAR(fit->wheel_base_m.value, 0.246, 0.003);
}

TEST(WheelFit, SaysNothingOfADriveThatCrossedHardlyAnyTags) {
  WheelLog log = ExactSquares(other_wheels()).drive(1);
  log.crossings.resize(10);
  log.laps.clear();
  EXPECT_FALSE(fit_wheels(log, {}));
}

}  // namespace
}  // namespace sensotwin::robot
