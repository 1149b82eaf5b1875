// SPDX-License-Identifier: MIT
#include "robot/sensobot/calibration_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// A robot that is not what it is told to be, on a row of tags 0.508 m apart along +x.
struct TrueRobot {
  double wheel_base_m{0.235};
  double way_scale{1.0};  ///< true way / way by the encoders
  double compass_sigma_rad{0.0};
  bool compass{true};
  double first_tag_m{0.3};
  int tags{7};
  double wall_m{10.0};
  double notice_s{0.0};  ///< a tag is noticed this much late
};

/// Lets the drive have it.
class Floor {
 public:
  explicit Floor(const TrueRobot& robot) : robot_(robot) {}

  CalibrationResult calibrate(const CalibrationConfig& config) {
    CalibrationDrive drive(config);
    WheelSpeeds wheels;
    for (int step = 0; step < 40000 && !drive.done(); ++step) {
      wheels = drive.step(advance(wheels, step));
    }
    EXPECT_TRUE(drive.done());
    EXPECT_EQ(wheels, WheelSpeeds{}) << "it stands when it is done";
    return drive.result();
  }

 private:
  CalibrationSensed advance(const WheelSpeeds& wheels, int step) {
    const double dt_s = to_s(kTick);
    left_m_ += wheels.left_mps * dt_s;
    right_m_ += wheels.right_mps * dt_s;
    yaw_rad_ += robot_.way_scale * (wheels.right_mps - wheels.left_mps) * dt_s / robot_.wheel_base_m;
    const double speed_mps = robot_.way_scale * 0.5 * (wheels.left_mps + wheels.right_mps);
    x_m_ += speed_mps * dt_s;
    CalibrationSensed sensed{.now = Instant{kTick * (step + 1)}, .left_m = left_m_, .right_m = right_m_};
    if (robot_.compass && step % 7 == 0) {
      sensed.yaw_from_north_rad =
          std::remainder(yaw_rad_ + random_.normal() * robot_.compass_sigma_rad, 2.0 * kPi);
    }
    const double seen_m = x_m_ - speed_mps * robot_.notice_s;
    bool over = false;
    for (int tag = 0; tag < robot_.tags; ++tag) {
      over = over || std::abs(seen_m - robot_.first_tag_m - 0.508 * tag) < 0.05;
    }
    sensed.tag_entered = over && !over_;
    sensed.tag_left = !over && over_;
    over_ = over;
    sensed.bumped = x_m_ > robot_.wall_m;
    return sensed;
  }

  TrueRobot robot_;
  RandomStream random_{3};
  double left_m_{0.0};
  double right_m_{0.0};
  double yaw_rad_{0.4};
  double x_m_{0.0};
  bool over_{false};
};

TEST(CalibrationDrive, FindsTheWheelBaseThatTurnsAsTheCompassSays) {
  Floor robot({.wheel_base_m = 0.241});
  const CalibrationResult result = robot.calibrate({.tags = 0});
  EXPECT_EQ(result.fault, CalibrationFault::kNone);
  EXPECT_NEAR(result.wheel_base_m[0], 0.241, 1e-6);
  EXPECT_NEAR(result.wheel_base_m[1], 0.241, 1e-6);
}

TEST(CalibrationDrive, FindsItBehindACompassOfOneDegree) {
  Floor robot({.wheel_base_m = 0.229, .compass_sigma_rad = 0.017});
  const CalibrationResult result = robot.calibrate({.tags = 0});
  // Headings averaged over nine readings, two of them: 0.46 degrees of 1800; four times that.
  EXPECT_NEAR(result.wheel_base_m[0], 0.229, 4 * 0.229 * 0.46 / 1800.0);
  EXPECT_NEAR(result.wheel_base_m[1], 0.229, 4 * 0.229 * 0.46 / 1800.0);
}

TEST(CalibrationDrive, FindsHowFarACountGoesByTheTagsItCrosses) {
  for (const double notice_s : {0.0, 0.2}) {
    Floor robot({.way_scale = 1.02, .notice_s = notice_s});
    const CalibrationResult result = robot.calibrate({.turns = 0});
    EXPECT_EQ(result.fault, CalibrationFault::kNone);
    // A step is 1.5 mm at 0.1 m/s, of 2.03 m.
    EXPECT_NEAR(result.way_scale[0], 1.02, 0.002) << notice_s;
    EXPECT_NEAR(result.way_scale[1], 1.02, 0.002) << notice_s;
  }
}

TEST(CalibrationDrive, SaysThatTheCompassIsSilent) {
  Floor robot({.compass = false});
  EXPECT_EQ(robot.calibrate({.tags = 0}).fault, CalibrationFault::kNoCompass);
}

TEST(CalibrationDrive, StopsBeyondARowThatIsTooShort) {
  Floor robot({.tags = 3});
  EXPECT_EQ(robot.calibrate({.turns = 0}).fault, CalibrationFault::kTooFewTags);
}

TEST(CalibrationDrive, StopsAtWhatItTouches) {
  Floor robot({.wall_m = 0.9});
  EXPECT_EQ(robot.calibrate({.turns = 0}).fault, CalibrationFault::kBumped);
}

}  // namespace
}  // namespace sensotwin::robot
