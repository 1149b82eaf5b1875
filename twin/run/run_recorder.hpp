// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/views.hpp"
#include "robot/mapping/tile_map.hpp"
#include "robot/output/event_log.hpp"
#include "robot/output/run_folder.hpp"
#include "twin/output/trace_writer.hpp"
#include "twin/run/mapping_twin.hpp"

namespace sensotwin::twin {

/// A tile as it came to be known, in the robot's own map.
struct FoundTile {
  double t_s{0.0};
  robot::Tile tile;
  robot::TagUid tag{0};
};

/// Writes down what happens while it happens: trace.csv, events.jsonl, and in memory what the pictures need.
class RunRecorder {
 public:
  /// \throws OutputError
  RunRecorder(robot::RunFolder& folder, int trace_every);

  /// After each tick. \throws OutputError
  void record(MappingTwin& twin);
  /// Told of every event from now on.
  void listen(robot::EventLog::Listener listener) { events_.set_listener(std::move(listener)); }
  /// Completes the files; they are valid whenever the run ended. \throws OutputError
  void finish();

  [[nodiscard]] const std::vector<render::TimedPoint>& trajectory() const { return trajectory_; }
  [[nodiscard]] const std::vector<FoundTile>& found() const { return found_; }
  /// Charge that left the battery, times its voltage at that moment.
  [[nodiscard]] double energy_wh() const { return energy_wh_; }

 private:
  void record_events(MappingTwin& twin);
  void record_bump(const MappingTwin& twin);
  void record_row(MappingTwin& twin);

  TraceWriter trace_;
  robot::EventLog events_;
  int point_every_;
  int until_point_{0};
  std::vector<render::TimedPoint> trajectory_;
  std::vector<FoundTile> found_;
  bool bumped_{false};
  double energy_wh_{0.0};
};

}  // namespace sensotwin::twin
