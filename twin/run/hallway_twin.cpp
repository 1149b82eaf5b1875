// SPDX-License-Identifier: MIT
#include "twin/run/hallway_twin.hpp"

#include "robot/settings/program_config.hpp"

namespace sensotwin::twin {
namespace {

robot::HallwayLinks rewired(const robot::HallwayLinks& links, const HallwayTwin::Rewiring& rewire) {
  return rewire ? rewire(links) : links;
}

}  // namespace

robot::RobotSettings hallway_settings_of(const Scene& scene) {
  robot::RobotSettings settings = robot_settings_of(scene);
  settings.hallways = scene.known.value_or(scene.hallways);
  // In a scene, +y is the plan's north.
  settings.hallways.north_rad = robot::wrap_angle(0.5 * robot::kPi - scene.world.north_yaw_rad);
  return settings;
}

HallwayTwin::HallwayTwin(const Scene& scene, const Rewiring& rewire)
    : machine_(scene, robot::RandomStream(scene.seed)),
      program_(rewired({machine_.serial(), machine_.floor_reader(), machine_.sensor_board()}, rewire),
               robot::hallway_config_of(hallway_settings_of(scene))) {}

void HallwayTwin::tick() {
  tick_world();
  tick_devices();
  tick_program();
}

void HallwayTwin::tick_program() {
  program_.step(now());
  machine_.close_tick();
}

}  // namespace sensotwin::twin
