// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "world/world.hpp"

/// Small worlds for the tests of world/.
namespace sensotwin::world {

/// A floor without any noise or manufacturing tolerance, so that a law shows itself.
inline WorldDescription even_floor() {
  WorldDescription world;
  world.floor.roughness = 0.0;
  world.floor.nap_drift = 0.0;
  return world;
}
inline RobotDescription exact_robot(const Pose2& X_WR_start = {}) {
  RobotDescription robot;
  robot.base.wheel_diameter_sigma = 0.0;
  robot.base.wheel_base_sigma = 0.0;
  robot.X_WR_start = X_WR_start;
  return robot;
}
/// With its default tolerances.
inline RobotDescription robot_at(const Pose2& X_WR_start) {
  RobotDescription robot;
  robot.X_WR_start = X_WR_start;
  return robot;
}
inline Wall room(double width_m, double depth_m) {
  return {.points_m = {{0.0, 0.0}, {width_m, 0.0}, {width_m, depth_m}, {0.0, depth_m}}, .closed = true};
}
inline World make(const WorldDescription& world, const RobotDescription& robot, std::uint64_t seed = 1,
                  const PhysicsDescription& physics = {}) {
  return World{world, robot, physics, robot::RandomStream{seed}};
}
inline RoombaOutputs wheels(double left_mps, double right_mps) {
  RoombaOutputs out;
  out.wheel_left_mps = left_mps;
  out.wheel_right_mps = right_mps;
  return out;
}
inline void run(World& world, const RoombaOutputs& outputs, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.015)); ++i) {
    world.tick(outputs);
  }
}

}  // namespace sensotwin::world
