// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "robot/program/hallway_program.hpp"
#include "robot/settings/robot_settings.hpp"
#include "twin/run/machine.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// A Roomba in hallways, as bytes see it: the world, the emulated devices in it, and at the other end of
/// their wires the very program that runs on the machine. Lock-step in virtual time: one tick is 15 ms of
/// everything. Neither copies nor moves: the program holds references to the devices.
class HallwayTwin {
 public:
  /// Puts something between the devices and the program: as MappingTwin::Rewiring.
  using Rewiring = std::function<robot::HallwayLinks(const robot::HallwayLinks&)>;

  /// \pre scene.mission.hallway
  explicit HallwayTwin(const Scene& scene, const Rewiring& rewire = {});
  HallwayTwin(const HallwayTwin&) = delete;
  HallwayTwin& operator=(const HallwayTwin&) = delete;

  /// World, then devices, then program; in that order, so that the program sees the end of the tick.
  void tick();

  [[nodiscard]] robot::Instant now() const { return machine_.now(); }
  [[nodiscard]] bool done() const { return program_.done(); }
  [[nodiscard]] const world::World& world() const { return machine_.world(); }
  [[nodiscard]] robot::HallwayProgram& program() { return program_; }
  [[nodiscard]] const robot::HallwayProgram& program() const { return program_; }
  /// What the mainboard sampled last.
  [[nodiscard]] const world::RoombaInputs& inputs() const { return machine_.inputs(); }
  /// Over the moving state of every tick so far.
  [[nodiscard]] const StateHash& hash() const { return machine_.hash(); }

  /// For those who time the parts: tick() is these three in a row.
  void tick_world() { machine_.tick_world(); }
  void tick_devices() { machine_.tick_devices(); }
  void tick_program();

 private:
  Machine machine_;
  robot::HallwayProgram program_;
};

/// What the robot knows of the scene: its hallway map, and on which side of magnetic north the plan's lies.
[[nodiscard]] robot::RobotSettings hallway_settings_of(const Scene& scene);

}  // namespace sensotwin::twin
