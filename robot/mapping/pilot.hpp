// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/task.hpp"
#include "robot/mapping/mission_io.hpp"
#include "robot/mapping/navigator.hpp"

namespace sensotwin::robot {

/// A directed straight line in M.
struct Line {
  Vec2 from_M_m{0.0, 0.0};
  double yaw_rad{0.0};
  /// Of yaw_rad; asked for at every step of a drive, hence kept. A line is made anew, never turned.
  Vec2 direction{std::cos(yaw_rad), std::sin(yaw_rad)};
  [[nodiscard]] const Vec2& along() const { return direction; }
  [[nodiscard]] double along_m(const Vec2& p_M_m) const { return (p_M_m - from_M_m).dot(along()); }
  /// Positive to the left.
  [[nodiscard]] double across_m(const Vec2& p_M_m) const {
    const Vec2 d = p_M_m - from_M_m;
    return along().x() * d.y() - along().y() * d.x();
  }
};

/// One control step's input and output, shared by everything that runs in it.
struct StepIo {
  Sensed sensed;
  Command command;
  StepSignal next;
};

/// Moves the robot: turns, drives along lines, brakes. The behaviours are coroutines that end when the motion
/// has.
class Pilot {
 public:
  Pilot(const MappingConfig& config, Navigator& navigator, StepIo& io)
      : config_(config), navigator_(navigator), io_(io) {}

  /// One step along a line: sets the wheel command. \param speed_mps  towards which the speed is ramped;
  /// negative drives backwards. \param left_m  how far to the left of the line to stay
  void follow(const Line& line, double speed_mps, double left_m);
  /// The speed from which the robot still stops within `distance_m`.
  [[nodiscard]] double stopping_speed_mps(double distance_m) const;

  Task<> brake();
  Task<> turn_to(double yaw_M_rad);
  Task<> wait_until(Instant when);
  /// Works the wheels one by one until the bumper lets go, a few seconds at most.
  Task<> break_free();
  /// Backs along `line` until along_m <= `until_m`.
  Task<> back_along(Line line, double until_m, double left_m);

  [[nodiscard]] bool bumped() const { return io_.sensed.bump_left || io_.sensed.bump_right; }
  /// +1 left only, -1 right only, 0 both.
  [[nodiscard]] int bump_side() const {
    return static_cast<int>(io_.sensed.bump_left) - static_cast<int>(io_.sensed.bump_right);
  }
  /// A hole, a lifted wheel, a virtual wall: nothing to try again.
  [[nodiscard]] bool hazard() const {
    return io_.sensed.cliff || io_.sensed.wheel_drop || io_.sensed.virtual_wall;
  }

 private:
  void command(double speed_mps, double turn_radps);
  [[nodiscard]] double ramped(double speed_mps) const;

  const MappingConfig& config_;
  Navigator& navigator_;
  StepIo& io_;
  double speed_mps_{0.0};
};

}  // namespace sensotwin::robot
