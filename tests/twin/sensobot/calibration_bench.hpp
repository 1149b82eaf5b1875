// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>

#include "robot/base/geometry.hpp"
#include "robot/calibration/calibration_program.hpp"
#include "robot/hal/no_device.hpp"
#include "robot/settings/robot_settings.hpp"
#include "twin/run/ceiling_radio.hpp"
#include "twin/run/machine.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// What the wheels in truth were during a drive: least squares of how the robot moved over what its encoders
/// counted. Carpet and creep are in it, as they are in what a calibration may find.
class TrueWheels {
 public:
  void add(const robot::Pose2& X_WR, double left_rad, double right_rad) {
    if (last_) {
      const double left = left_rad - last_->left_rad;
      const double right = right_rad - last_->right_rad;
      const robot::Pose2 moved = last_->X_WR.inverse() * X_WR;
      const Eigen::Vector2d angles{left, right};
      normal_ += angles * angles.transpose();
      forward_ += angles * moved.p_m.x();
      turned_ += angles * moved.yaw_rad;
    }
    last_ = {X_WR, left_rad, right_rad};
  }
  /// forward = (r_l a_l + r_r a_r) / 2; turn = (r_r a_r - r_l a_l) / base
  [[nodiscard]] double mean_diameter_m() const { return diameters_m().sum() / 2.0; }
  [[nodiscard]] double ratio() const {
    const Eigen::Vector2d turn = normal_.ldlt().solve(turned_);
    return -turn(1) / turn(0);
  }
  [[nodiscard]] double base_m() const {
    const Eigen::Vector2d turn = normal_.ldlt().solve(turned_);
    return mean_diameter_m() / (turn(1) - turn(0));
  }

 private:
  struct Moment {
    robot::Pose2 X_WR;
    double left_rad{0.0};
    double right_rad{0.0};
  };
  [[nodiscard]] Eigen::Vector2d diameters_m() const { return 4.0 * normal_.ldlt().solve(forward_); }

  std::optional<Moment> last_;
  Eigen::Matrix2d normal_{Eigen::Matrix2d::Zero()};
  Eigen::Vector2d forward_{Eigen::Vector2d::Zero()};
  Eigen::Vector2d turned_{Eigen::Vector2d::Zero()};
};

/// A scene's world and devices, and at the other end of their wires the program that `sensobot calibrate`
/// runs. Neither copies nor moves.
class CalibrationTwin {
 public:
  CalibrationTwin(const Scene& scene, const robot::RobotSettings& told, const robot::CalibrationPlan& plan)
      : random_(scene.seed), machine_(scene, random_) {
    if (scene.world.radio) {
      ceiling_.emplace(scene, random_);
    }
    robot::ByteLink& uhf = ceiling_ ? ceiling_->reader().link() : static_cast<robot::ByteLink&>(no_reader_);
    program_.emplace(
        robot::RobotLinks{machine_.serial(), machine_.compass(), uhf, machine_.floor_reader(), no_card_},
        told, plan);
  }
  CalibrationTwin(const CalibrationTwin&) = delete;
  CalibrationTwin& operator=(const CalibrationTwin&) = delete;

  /// \returns what was measured, the robot standing
  const robot::CalibrationResult& run(double limit_s = 1200.0) {
    while (!program_->done() && robot::to_s(machine_.now()) < limit_s) {
      tick();
      truth_.add(world().X_WR(), machine_.inputs().wheel_angle_left_rad,
                 machine_.inputs().wheel_angle_right_rad);
    }
    program_->shut_down();
    for (int i = 0; i < 40; ++i) {
      tick_world();
    }
    return program_->result();
  }
  [[nodiscard]] bool stands() {
    const robot::Vec2 before = world().X_WR().p_m;
    tick_world();
    return (world().X_WR().p_m - before).norm() < 1e-6;
  }
  [[nodiscard]] bool done() const { return program_->done(); }
  [[nodiscard]] const TrueWheels& truth() const { return truth_; }
  [[nodiscard]] const world::World& world() { return machine_.world(); }
  [[nodiscard]] double now_s() const { return robot::to_s(machine_.now()); }

 private:
  void tick_world() {
    const world::RobotMotion motion = machine_.tick_world();
    if (ceiling_) {
      ceiling_->tick_world(motion);
    }
    machine_.tick_devices();
    if (ceiling_) {
      ceiling_->tick_devices(machine_.now());
    }
  }
  void tick() {
    tick_world();
    program_->step(machine_.now());
    machine_.close_tick();
  }

  robot::RandomStream random_;
  Machine machine_;
  std::optional<CeilingRadio> ceiling_;
  robot::NoByteLink no_reader_;
  robot::NoCardLink no_card_;
  std::optional<robot::CalibrationProgram> program_;
  TrueWheels truth_;
};

}  // namespace sensotwin::twin
