// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "world/description.hpp"
#include "world/obstacles.hpp"
#include "world/roomba_io.hpp"

namespace sensotwin::world {

/// Which of the bumper's two switches a touch on the shell presses.
///
/// The shell is the front half. \param bearing_rad of the touch in R, counter-clockwise from forward, in
/// (-pi, pi]. A touch within 10 degrees of the middle presses both (chosen: a head-on hit moves the shell
/// straight back).
struct BumpSwitches {
  bool left{false};
  bool right{false};
};
[[nodiscard]] BumpSwitches switches_pressed(double bearing_rad);

/// The optical sensors of the shell: light bumpers, cliff sensors, and the infrared receivers.
///
///   light bumper:  signal = 4095 / (1 + d / 0.05 m)^2 up to d = 0.25 m, then 0;  d along the beam from the
///   shell cliff:         kFloor_signal over floor, kHole_signal over a hole virtual wall:  seen while the
///   robot's middle is in its fan and no wall or fixed furniture lies between home base:     red buoy left of
///   its axis as the robot sees it, green right, both within the middle; force field
///
/// The beams look to +-65, +-38 and +-14 degrees; cliff sensors sit 0.16 m from the middle at +-60 and +-15
/// degrees. Law and angles are chosen after photographs of the Create 2; figures that clients compare with
/// each other only. Leaves out: colour and slant of what reflects, sunlight, noise, beams of other robots.
/// Frames: poses in W; `pushed` is the outline of what can move, in W.
class BodySensors {
 public:
  BodySensors(const WorldDescription& world, const RoombaDescription& base);

  /// Fills light_bump_signal, wall_signal, cliff, cliff_signal, wheel_drop_*, virtual_wall and ir_*.
  void read(const ObstacleIndex& fixed, std::span<const Outline> pushed, const Pose2& X_WR,
            RoombaInputs& inputs) const;
  /// Left and right wheel: whether there is floor under it.
  [[nodiscard]] std::array<bool, 2> wheels_on_floor(const Pose2& X_WR) const;
  /// Whether there is no hole anywhere: both wheels are on the floor then, wherever the robot is.
  [[nodiscard]] bool floor_is_whole() const { return cliffs_.empty(); }
  /// Whether the charging contacts meet the home base's.
  [[nodiscard]] bool docked(const Pose2& X_WR) const;

 private:
  [[nodiscard]] bool over_hole(const Vec2& at_m) const;
  void look_around(const ObstacleIndex& fixed, const Vec2& at_m) const;
  void read_light(const ObstacleIndex& fixed, std::span<const Outline> pushed, const Pose2& X_WR,
                  RoombaInputs& inputs) const;
  void read_infrared(const ObstacleIndex& fixed, const Pose2& X_WR, RoombaInputs& inputs) const;

  std::vector<Cliff> cliffs_;
  std::vector<VirtualWall> virtual_walls_;
  std::optional<HomeBase> home_base_;
  Pose2 X_HW_;  ///< meaningless without a home base
  double radius_m_;
  double arm_m_;
  /// What the beams can meet while the robot is near seen_from_m_, and the distance from there to the nearest
  /// of it. A cache of the fixed outline, hence mutable.
  mutable Outline around_;
  mutable std::optional<Vec2> seen_from_m_;
  mutable double nearest_m_{0.0};
};

}  // namespace sensotwin::world
