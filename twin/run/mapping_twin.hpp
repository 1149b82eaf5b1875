// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "robot/program/mapping_program.hpp"
#include "twin/devices/emulated_card_reader.hpp"
#include "twin/run/machine.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// A Roomba in a house, as bytes see it: the world, the emulated devices in it, and at the other end of their
/// wires the very program that runs on the machine. Lock-step in virtual time: one tick is 15 ms of
/// everything.
///
/// Neither copies nor moves: the program holds references to the devices.
class MappingTwin {
 public:
  /// Puts something between the devices and the program, for instance faults: takes the devices' ends of the
  /// wires and gives those that the program gets, which must outlive the twin.
  using Rewiring = std::function<robot::MappingLinks(const robot::MappingLinks&)>;

  /// \pre scene.mission.map
  explicit MappingTwin(const Scene& scene, const Rewiring& rewire = {});
  MappingTwin(const MappingTwin&) = delete;
  MappingTwin& operator=(const MappingTwin&) = delete;

  /// World, then devices, then program; in that order, so that the program sees the end of the tick.
  void tick();

  [[nodiscard]] robot::Instant now() const { return machine_.now(); }
  [[nodiscard]] bool done() const { return program_.done(); }
  [[nodiscard]] world::World& world() { return machine_.world(); }
  [[nodiscard]] const world::World& world() const { return machine_.world(); }
  [[nodiscard]] robot::MappingProgram& program() { return program_; }
  [[nodiscard]] const robot::MappingProgram& program() const { return program_; }
  /// What the mainboard sampled last.
  [[nodiscard]] const world::RoombaInputs& inputs() const { return machine_.inputs(); }
  /// Over the moving state of every tick so far.
  [[nodiscard]] const StateHash& hash() const { return machine_.hash(); }
  /// Map id that this run's program writes into tags.
  [[nodiscard]] std::uint32_t map_id() const { return map_id_; }

  /// For those who time the parts: tick() is these three in a row.
  void tick_world();
  void tick_devices();
  void tick_program();

 private:
  robot::RandomStream random_;
  std::uint32_t map_id_;
  Machine machine_;
  EmulatedCardReader forward_reader_;
  robot::MappingProgram program_;
};

/// Map id that a run of this scene writes into tags.
[[nodiscard]] std::uint32_t map_id_of(const Scene& scene);

/// What the robot knows of the scene, and the map id of its run.
[[nodiscard]] robot::RobotSettings robot_settings_of(const Scene& scene, std::uint32_t map_id);

/// The program's configuration as the scene's robot and mission sections say it: the same keys configure the
/// machine.
[[nodiscard]] robot::MappingProgramConfig mapping_config_of(const Scene& scene, std::uint32_t map_id);

}  // namespace sensotwin::twin
