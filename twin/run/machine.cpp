// SPDX-License-Identifier: MIT
#include "twin/run/machine.hpp"

namespace sensotwin::twin {
namespace {

EmulatedRoombaConfig mainboard_of(const Scene& scene) {
  EmulatedRoombaConfig config;
  config.body = scene.robot.base;
  switch (scene.robot.base.firmware) {
    case world::RoombaFirmware::kCurrent:
      break;
    case world::RoombaFirmware::kBefore341:
      config.firmware = {3, 4, 0};
      break;
    case world::RoombaFirmware::kBefore330:
      config.firmware = {3, 2, 0};
      break;
    case world::RoombaFirmware::kWifi:
      config.mode_one_too_high = true;
      break;
  }
  return config;
}

}  // namespace

robot::RobotSettings robot_settings_of(const Scene& scene) {
  const world::RoombaDescription& base = scene.robot.base;
  robot::RobotSettings settings;
  settings.base = {.kind = static_cast<robot::BaseKind>(base.kind),
                   .firmware = static_cast<robot::BaseFirmware>(base.firmware),
                   .radius_m = base.radius_m,
                   .wheel_base_m = base.wheel_base_m,
                   .wheel_diameter_m = base.wheel_diameter_m,
                   .counts_per_turn = base.counts_per_turn,
                   .speed_max_mps = base.speed_max_mps};
  settings.floor_reader.read_radius_m = scene.robot.floor_reader.read_radius_m;
  settings.forward_reader.read_radius_m = scene.robot.forward_reader.read_radius_m;
  settings.tile_m = scene.world.carpet.tile_m;
  settings.mission = scene.mission;
  return settings;
}

Machine::Machine(const Scene& scene, const robot::RandomStream& random)
    : world_(scene.world, scene.robot, scene.physics, random.fork("world")),
      inputs_(world_.roomba_inputs()),
      roomba_(mainboard_of(scene)),
      serial_(roomba_),
      floor_reader_(card_reader_settings(scene.robot.floor_reader), random.fork("floor reader")),
      sensor_board_(scene.robot.compass) {}

world::RobotMotion Machine::tick_world() {
  world::RobotMotion motion{.begin_s = robot::to_s(now_), .X_WR_begin = world_.X_WR()};
  now_ += robot::kTick;
  world_.tick(outputs_);
  motion.end_s = robot::to_s(now_);
  motion.X_WR_end = world_.X_WR();
  return motion;
}

void Machine::tick_devices() {
  inputs_ = world_.roomba_inputs();
  outputs_ = roomba_.tick(inputs_);
  const auto floor_tag = world_.floor_tag();
  floor_reader_.step(now_, floor_tag ? &world_.tag_memory(*floor_tag) : nullptr);
  if (sensor_board_.is_due(now_)) {
    // The world's compass counts clockwise, as a compass card does.
    const double yaw_rad = -world_.compass_heading_rad();
    sensor_board_.step(now_, yaw_rad, world_.sonar_ranges_m());
  }
}

}  // namespace sensotwin::twin
