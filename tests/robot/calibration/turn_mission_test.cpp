// SPDX-License-Identifier: MIT
#include "robot/calibration/turn_mission.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// A robot that is not what it is told to be.
struct TrueRobot {
  double wheel_base_m{0.235};
  double compass_sigma_rad{0.0};
  bool compass{true};
  double bumps_after_s{1e9};
};

/// Lets the mission have it.
class Floor {
 public:
  explicit Floor(const TrueRobot& robot) : robot_(robot) {}

  void turn() {
    WheelSpeeds wheels;
    for (int step = 0; step < 20000 && !mission.done(); ++step) {
      wheels = mission.step(advance(wheels, step));
    }
    ASSERT_TRUE(mission.done());
    EXPECT_EQ(wheels, WheelSpeeds{}) << "it stands when it is done";
  }
  [[nodiscard]] double yaw_rad() const { return yaw_rad_; }

  TurnMission mission{OdometryModel{}, TurnPlan{}};

 private:
  /// Whole counts, what is left of them kept.
  static int counted(double& rest, double turned) {
    const double all = rest + turned;
    const double whole = std::floor(all);
    rest = all - whole;
    return static_cast<int>(whole);
  }
  Sensed advance(const WheelSpeeds& wheels, int step) {
    const double dt_s = to_s(kTick);
    const double per_m = 1.0 / OdometryModel{}.metres_per_count;
    yaw_rad_ += (wheels.right_mps - wheels.left_mps) * dt_s / robot_.wheel_base_m;
    Sensed sensed;
    sensed.stamp = Instant{kTick * (step + 1)};
    sensed.counts_left = counted(left_rest_, wheels.left_mps * dt_s * per_m);
    sensed.counts_right = counted(right_rest_, wheels.right_mps * dt_s * per_m);
    if (robot_.compass && step % 7 == 0) {
      sensed.compass_rad = std::remainder(yaw_rad_ + random_.normal() * robot_.compass_sigma_rad, 2.0 * kPi);
    }
    sensed.bump_left = to_s(sensed.stamp) > robot_.bumps_after_s;
    return sensed;
  }

  TrueRobot robot_;
  RandomStream random_{3};
  double left_rest_{0.0};
  double right_rest_{0.0};
  double yaw_rad_{0.4};
};

TEST(TurnMission, FindsTheWheelBaseThatTurnsAsTheCompassSaysAndFacesAsBefore) {
  Floor robot({.wheel_base_m = 0.241});
  robot.turn();
  EXPECT_EQ(robot.mission.fault(), TurnFault::kNone);
  // A count is 0.11 degrees of 1800.
  EXPECT_NEAR(robot.mission.wheel_base_m()[0], 0.241, 4e-5);
  EXPECT_NEAR(robot.mission.wheel_base_m()[1], 0.241, 4e-5);
  EXPECT_NEAR(wrap_angle(robot.yaw_rad() - 0.4), 0.0, rad_from_deg(0.5));
}

TEST(TurnMission, FindsItBehindACompassOfOneDegree) {
  Floor robot({.wheel_base_m = 0.229, .compass_sigma_rad = 0.017});
  robot.turn();
  // Headings averaged over nine readings, two of them: 0.46 degrees of 1800; four times that.
  EXPECT_NEAR(robot.mission.wheel_base_m()[0], 0.229, 4 * 0.229 * 0.46 / 1800.0);
  EXPECT_NEAR(robot.mission.wheel_base_m()[1], 0.229, 4 * 0.229 * 0.46 / 1800.0);
}

TEST(TurnMission, SaysThatTheCompassIsSilent) {
  Floor robot({.compass = false});
  robot.turn();
  EXPECT_EQ(robot.mission.fault(), TurnFault::kNoCompass);
}

TEST(TurnMission, StopsAtWhatItTouches) {
  Floor robot({.bumps_after_s = 5.0});
  robot.turn();
  EXPECT_EQ(robot.mission.fault(), TurnFault::kBumped);
}

}  // namespace
}  // namespace sensotwin::robot
