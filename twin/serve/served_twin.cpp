// SPDX-License-Identifier: MIT
#include "twin/serve/served_twin.hpp"

namespace sensotwin::twin {

ServedTwin::ServedTwin(const Scene& scene)
    : random_(scene.seed),
      machine_(scene, random_),
      forward_reader_(card_reader_settings(scene.robot.forward_reader), random_.fork("forward reader")) {
  if (scene.world.radio) {
    ceiling_.emplace(scene, random_);
    ceiling_->reader().link().cut();  // clients come by TCP, not from within
  }
}

void ServedTwin::tick() {
  const world::RobotMotion motion = machine_.tick_world();
  machine_.tick_devices();
  world::World& world = machine_.world();
  const auto forward_tag = world.forward_tag();
  forward_reader_.step(now(), forward_tag ? &world.tag_memory(*forward_tag) : nullptr);
  if (ceiling_) {
    ceiling_->tick_world(motion);
    ceiling_->tick_devices(now());
  }
  machine_.close_tick();
}

}  // namespace sensotwin::twin
