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

robot::RoombaConfig base_config_of(const Scene& scene) {
  robot::RoombaConfig config;
  if (scene.robot.base.firmware == world::RoombaFirmware::kWifi) {
    config.mode_report_offset = 1;
  }
  return config;
}

Machine::Machine(const Scene& scene, const robot::RandomStream& random)
    : world_(scene.world, scene.robot, scene.physics, random.fork("world")),
      inputs_(world_.roomba_inputs()),
      roomba_(mainboard_of(scene)),
      serial_(roomba_),
      floor_reader_(card_reader_settings(scene.robot.floor_reader), random.fork("floor reader")),
      compass_(scene.robot.compass) {}

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
  if (compass_.is_due(now_)) {
    // The world's compass counts clockwise, as a compass card does.
    compass_.step(now_, -world_.compass_heading_rad());
  }
}

}  // namespace sensotwin::twin
