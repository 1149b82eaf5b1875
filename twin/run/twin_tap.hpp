// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "robot/output/event_log.hpp"
#include "robot/telemetry/program_tap.hpp"
#include "robot/telemetry/telemetry_hub.hpp"
#include "twin/run/hallway_twin.hpp"
#include "twin/run/ideal_path.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/phase_twin.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The true room for a monitor, in W: walls, furniture, where tags hang, the ideal path.
void show_scene(robot::ProgramTap& tap, const Scene& scene);
/// Where M lies in W, so that the true room can be laid beneath what the robot believes.
void show_frame(robot::ProgramTap& tap, const robot::Pose2& X_WM);

/// The true pose; and, as often, who walks about.
void show_truth(robot::ProgramTap& tap, robot::Instant now, const world::World& world);

/// What a run in the twin shows on a monitor: what its program knows, as on the machine; and marked as such,
/// what only a twin can know: the true room and the true pose.
class TwinTap {
 public:
  /// \param hub  none: nothing is shown, and nothing costs time
  TwinTap(robot::TelemetryHub* hub, const Scene& scene, const robot::RobotSettings& settings);

  /// For the recorder's events; empty without a hub. Holds a reference to this tap.
  [[nodiscard]] robot::EventLog::Listener listener();
  /// Tiles that the mission is to map, as only a twin can know.
  void show_total(std::size_t tiles);
  void after_tick(const MappingTwin& twin);
  void after_tick(const HallwayTwin& twin);
  void after_tick(const PhaseTwin& twin);
  void ended(robot::Instant now, bool interrupted);

 private:
  const Scene& scene_;
  std::optional<robot::ProgramTap> tap_;
  std::optional<IdealPath> path_;
  bool placed_{false};
};

/// A recorder that also shows what happened, for TickLoop.
template <class Recorder>
class TappingRecorder {
 public:
  TappingRecorder(Recorder& recorder, TwinTap& tap) : recorder_(recorder), tap_(tap) {}

  template <class Twin>
  void record(Twin& twin) {
    recorder_.record(twin);
    tap_.after_tick(twin);
  }

 private:
  Recorder& recorder_;
  TwinTap& tap_;
};

}  // namespace sensotwin::twin
