// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "robot/hal/no_device.hpp"
#include "robot/replay/journal_file.hpp"
#include "robot/replay/wiring.hpp"
#include "twin/run/hallway_twin.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/phase_twin.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// What the program of this scene is told, as a robot file: the machine's own program runs from it, and a
/// journal begins with it. Its devices are the twin's, which nobody can open.
[[nodiscard]] std::string robot_file_of(const Scene& scene);

/// The journal of a run in the twin: what `sensobot` writes on the machine. Must outlive the twin whose wires
/// it taps. Neither copies nor moves.
class TwinJournal {
 public:
  /// \param file  none: nothing is written, and the wires are left alone  \throws OutputError
  TwinJournal(const std::optional<std::filesystem::path>& file, const Scene& scene)
      : file_(file, file ? robot_file_of(scene) : std::string{}) {}
  TwinJournal(const TwinJournal&) = delete;
  TwinJournal& operator=(const TwinJournal&) = delete;

  [[nodiscard]] MappingTwin::Rewiring on_mapping_wires();
  [[nodiscard]] PhaseTwin::Rewiring on_phase_wires();
  [[nodiscard]] HallwayTwin::Rewiring on_hallway_wires();
  /// After each tick.
  void end_tick(robot::Instant now) {
    if (robot::JournalWriter* writer = file_.writer()) {
      writer->end_step(now);
    }
  }
  /// False when the disk took no more; the journal is good up to there.
  [[nodiscard]] bool complete() { return file_.writer() == nullptr || !file_.writer()->failed(); }

 private:
  robot::JournalFile file_;
  robot::NoByteLink no_reader_;
  robot::NoCardLink no_card_;
  std::unique_ptr<robot::Wiring> wiring_;
};

/// A recorder that also closes the journal's block, for TickLoop.
template <class Recorder>
class JournallingRecorder {
 public:
  JournallingRecorder(Recorder& recorder, TwinJournal& journal) : recorder_(recorder), journal_(journal) {}

  template <class Twin>
  void record(Twin& twin) {
    journal_.end_tick(twin.now());
    recorder_.record(twin);
  }

 private:
  Recorder& recorder_;
  TwinJournal& journal_;
};

}  // namespace sensotwin::twin
