// SPDX-License-Identifier: MIT
#include "twin/run/mapping_twin.hpp"

#include "robot/mapping/explorer_kind.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::twin {
namespace {

robot::MappingLinks rewired(const robot::MappingLinks& links, const MappingTwin::Rewiring& rewire) {
  return rewire ? rewire(links) : links;
}

}  // namespace

std::uint32_t map_id_of(const Scene& scene) {
  return static_cast<std::uint32_t>(robot::RandomStream(scene.seed).fork("map id").seed());
}

robot::RobotSettings robot_settings_of(const Scene& scene, std::uint32_t map_id) {
  robot::RobotSettings settings = robot_settings_of(scene);
  settings.map_id = map_id;
  return settings;
}

robot::MappingProgramConfig mapping_config_of(const Scene& scene, std::uint32_t map_id) {
  return robot::mapping_config_of(robot_settings_of(scene, map_id));
}

MappingTwin::MappingTwin(const Scene& scene, const Rewiring& rewire)
    : random_(scene.seed),
      map_id_(map_id_of(scene)),
      machine_(scene, random_),
      forward_reader_(card_reader_settings(scene.robot.forward_reader), random_.fork("forward reader")),
      program_(
          rewired({machine_.serial(), machine_.floor_reader(), forward_reader_, machine_.sensor_board()},
                  rewire),
          mapping_config_of(scene, map_id_),
          robot::make_explorer(scene.mission.map->explorer, robot::move_cost_of(robot_settings_of(scene)))) {}

void MappingTwin::tick() {
  tick_world();
  tick_devices();
  tick_program();
}

void MappingTwin::tick_world() {
  machine_.tick_world();
}

void MappingTwin::tick_devices() {
  machine_.tick_devices();
  const auto forward_tag = world().forward_tag();
  forward_reader_.step(now(), forward_tag ? &world().tag_memory(*forward_tag) : nullptr);
}

void MappingTwin::tick_program() {
  program_.step(now());
  machine_.close_tick();
}

}  // namespace sensotwin::twin
