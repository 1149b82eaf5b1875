// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/views.hpp"
#include "robot/output/event_log.hpp"
#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/output/trace_writer.hpp"
#include "twin/run/hallway_twin.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Writes down what happens in hallways while it happens: trace.csv, events.jsonl; and in memory the figures
/// and what the picture needs.
class HallwayRecorder {
 public:
  /// \throws OutputError
  HallwayRecorder(const Scene& scene, robot::RunFolder& folder, int trace_every, bool keep_points);

  /// After each tick. \throws OutputError
  void record(HallwayTwin& twin);
  /// Told of every event from now on.
  void listen(robot::EventLog::Listener listener) { events_.set_listener(std::move(listener)); }
  /// Completes the files; they are valid whenever the run ended. \throws OutputError
  void finish();

  /// Of the run so far.
  [[nodiscard]] HallwayResult result(const HallwayTwin& twin) const;
  [[nodiscard]] const std::vector<render::TimedPoint>& driven() const { return driven_; }

 private:
  void count(const robot::HallwayEvent& event);
  void record_row(const HallwayTwin& twin);

  const Scene& scene_;
  TraceWriter trace_;
  robot::EventLog events_;
  bool keep_points_;
  int until_point_{0};
  std::vector<render::TimedPoint> driven_;
  HallwayResult result_;
  std::optional<Vec2> last_m_;
};

/// Sides of places in which a survey's map differs from the drawn one: tags elsewhere, hallways that lead
/// elsewhere or differ in length by more than half a metre; places are told by their tags. Each place too
/// many or too few counts once.
[[nodiscard]] int differences(const robot::HallwayMap& drawn, const robot::HallwayMap& found);

}  // namespace sensotwin::twin
