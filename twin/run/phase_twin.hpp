// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "robot/base/random.hpp"
#include "robot/program/phase_program.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"
#include "twin/run/ceiling_radio.hpp"
#include "twin/run/machine.hpp"
#include "twin/scene/scene.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::twin {

/// A Roomba under ceiling tags, as bytes see it: the world, the radio between tags and antennas, the emulated
/// devices, and at the other end of their wires the very program that runs on the machine. Lock-step in
/// virtual time: one tick is 15 ms of everything.
///
/// Neither copies nor moves: the program holds references to the devices.
class PhaseTwin {
 public:
  /// Puts something between the devices and the program, for instance faults: takes the devices' ends of the
  /// wires and gives those that the program gets, which must outlive the twin.
  using Rewiring = std::function<robot::PhaseLinks(const robot::PhaseLinks&)>;

  /// Changes what the program is told, and nothing that is true: exchanged cables, a wrong list of tags.
  using Retelling = std::function<void(robot::PhaseProgramConfig&)>;

  /// \pre scene.mission.phase and scene.world.radio
  explicit PhaseTwin(const Scene& scene, const Rewiring& rewire = {}, const Retelling& retell = {});
  PhaseTwin(const PhaseTwin&) = delete;
  PhaseTwin& operator=(const PhaseTwin&) = delete;

  /// World, then devices, then program; in that order, so that the program sees the end of the tick.
  void tick();

  [[nodiscard]] robot::Instant now() const { return machine_.now(); }
  [[nodiscard]] bool done() const { return program_.done(); }
  [[nodiscard]] const world::World& world() const { return machine_.world(); }
  [[nodiscard]] robot::PhaseProgram& program() { return program_; }
  [[nodiscard]] const robot::PhaseProgram& program() const { return program_; }
  /// What the mainboard sampled last.
  [[nodiscard]] const world::RoombaInputs& inputs() const { return machine_.inputs(); }
  /// Over the moving state of every tick so far.
  [[nodiscard]] const StateHash& hash() const { return machine_.hash(); }
  /// What the reader reported in the last tick, as the radio made it.
  [[nodiscard]] std::span<const RadioReading> readings() const { return ceiling_.readings(); }
  /// The radio of this run, its hop table included.
  [[nodiscard]] const world::RadioWorld& radio() const { return ceiling_.world(); }
  [[nodiscard]] const EmulatedUhfReader& uhf_reader() const { return ceiling_.reader(); }

  /// For those who time the parts: tick() is these three in a row.
  void tick_world();
  void tick_devices();
  void tick_program();

 private:
  robot::RandomStream random_;
  Machine machine_;
  CeilingRadio ceiling_;
  robot::PhaseProgram program_;
};

}  // namespace sensotwin::twin
