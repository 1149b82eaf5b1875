// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/phase_views.hpp"
#include "robot/output/event_log.hpp"
#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/output/tag_log.hpp"
#include "twin/output/trace_writer.hpp"
#include "twin/run/ideal_path.hpp"
#include "twin/run/phase_noise.hpp"
#include "twin/run/phase_twin.hpp"

namespace sensotwin::twin {

/// Writes down what happens while it happens: trace.csv, events.jsonl, the tag log; and in memory the figures
/// of the path and what the pictures need.
class PhaseRecorder {
 public:
  /// \param keep_points  false: no pictures will be wanted  \throws OutputError
  PhaseRecorder(const Scene& scene, robot::RunFolder& folder, int trace_every, bool keep_points,
                const std::optional<std::filesystem::path>& tag_log);

  /// After each tick. \throws OutputError
  void record(PhaseTwin& twin);
  /// Told of every event from now on.
  void listen(robot::EventLog::Listener listener) { events_.set_listener(std::move(listener)); }
  /// Completes the files; they are valid whenever the run ended. \throws OutputError
  void finish();

  /// Of the run so far.
  [[nodiscard]] PathResult result(const PhaseTwin& twin) const;
  [[nodiscard]] const IdealPath& path() const { return path_; }
  [[nodiscard]] const std::vector<render::TimedPoint>& driven() const { return driven_; }
  [[nodiscard]] const std::vector<render::ErrorPoint>& errors() const { return errors_; }
  [[nodiscard]] const std::vector<render::SegmentView>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<render::TagEstimateView>& estimates() const { return estimates_; }
  [[nodiscard]] const PhaseNoise& noise() const { return noise_; }

 private:
  void record_error(const PhaseTwin& twin);
  void record_events(PhaseTwin& twin);
  void record_row(const PhaseTwin& twin);
  void record_points(const PhaseTwin& twin);
  void record_estimates(const PhaseTwin& twin);
  [[nodiscard]] std::string name_of(const robot::Epc& epc) const;

  const Scene& scene_;
  IdealPath path_;
  std::vector<std::size_t> destinations_;
  TraceWriter trace_;
  robot::EventLog events_;
  std::optional<TagLogWriter> tag_log_;
  PhaseNoise noise_;
  bool keep_points_;
  int until_point_{0};
  int until_estimate_{0};
  std::vector<render::TimedPoint> driven_;
  std::vector<render::ErrorPoint> errors_;
  std::vector<render::SegmentView> segments_;
  std::vector<render::TagEstimateView> estimates_;

  /// Squares of errors, of one half of the legs.
  struct Squares {
    double sum_m2{0.0};
    long count{0};
  };
  Squares first_half_;
  Squares second_half_;
  PathResult result_;
  std::optional<double> first_reached_s_;
  std::optional<Vec2> last_m_;
  std::size_t leg_{0};
};

}  // namespace sensotwin::twin
