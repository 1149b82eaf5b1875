// SPDX-License-Identifier: MIT
#include "twin/run/mapping_twin.hpp"

#include "robot/mapping/explorer_kind.hpp"

namespace sensotwin::twin {
namespace {

robot::MoveCost move_cost_of(const MapMission& mission, double tile_m) {
  if (mission.pace.tile_s > 0.0) {
    return {.tile_s = mission.pace.tile_s, .quarter_turn_s = 0.0};
  }
  // A turn costs its angle, the ramps of turning, and the stop before it and the start after it.
  const robot::MappingConfig drive;
  const double ramps_s = mission.pace.speed_mps / drive.acceleration_mps2 +
                         mission.pace.turn_radps / drive.turn_acceleration_radps2;
  return {.tile_s = tile_m / mission.pace.speed_mps,
          .quarter_turn_s = robot::kPi / 2.0 / mission.pace.turn_radps + ramps_s};
}

robot::MappingLinks rewired(const robot::MappingLinks& links, const MappingTwin::Rewiring& rewire) {
  return rewire ? rewire(links) : links;
}

}  // namespace

robot::MappingProgramConfig mapping_config_of(const Scene& scene, std::uint32_t map_id) {
  const MapMission& mission = *scene.mission.map;
  robot::MappingProgramConfig config;
  config.map_id = map_id;
  config.mapping.tile_m = scene.world.carpet.tile_m;
  config.mapping.pace = {.speed_mps = mission.pace.speed_mps,
                         .turn_radps = mission.pace.turn_radps,
                         .tile_s = mission.pace.tile_s,
                         .tag_s = mission.pace.tag_s};
  config.mapping.odometry.wheel_base_m = scene.robot.base.wheel_base_m;
  config.mapping.odometry.metres_per_count =
      robot::kPi * scene.robot.base.wheel_diameter_m / scene.robot.base.counts_per_turn;
  config.mapping.body_radius_m = scene.robot.base.radius_m;
  config.mapping.light_bumper.shell_radius_m = scene.robot.base.radius_m;
  config.mapping.read_radius_m = scene.robot.floor_reader.read_radius_m;
  config.base = base_config_of(scene);
  return config;
}

MappingTwin::MappingTwin(const Scene& scene, const Rewiring& rewire)
    : random_(scene.seed),
      map_id_(static_cast<std::uint32_t>(random_.fork("map id").seed())),
      machine_(scene, random_),
      forward_reader_(card_reader_settings(scene.robot.forward_reader), random_.fork("forward reader")),
      program_(
          rewired({machine_.serial(), machine_.floor_reader(), forward_reader_, machine_.compass()}, rewire),
          mapping_config_of(scene, map_id_),
          robot::make_explorer(scene.mission.map->explorer,
                               move_cost_of(*scene.mission.map, scene.world.carpet.tile_m))) {}

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
