// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/output/run_folder.hpp"
#include "robot/telemetry/telemetry_hub.hpp"
#include "twin/output/summary.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// How far a run is, for a progress bar.
struct RunProgress {
  double sim_s{0.0};
  int done{0};   ///< tiles found, tags reached
  int total{0};  ///< tiles of the carpet, destinations
};

struct SceneRunOptions {
  std::string scene_as_given;  ///< as summary.json names it
  int trace_every{7};          ///< ticks from row to row of trace.csv
  bool pictures{true};
  /// Missions along ceiling tags: what the UHF reader reports, with the columns of sllurp (tag_log.hpp).
  std::optional<std::filesystem::path> tag_log{};
  /// All bytes of all wires, for `twin replay`.
  std::optional<std::filesystem::path> journal{};
  /// Missions along ceiling tags by our own controller: their bound, when it is known. Else the run finds it.
  std::optional<BoundResult> bound{};
  /// What a monitor is told; none: there is none. Outlives the run.
  robot::TelemetryHub* telemetry{nullptr};
  /// Called after each tick with the simulated time: may wait, to be watched. Changes nothing of the run.
  std::function<void(double)> pace{};
  /// Asked a few hundred times a simulated hour, and between pictures; false ends the run in order, with
  /// valid files and no further picture.
  std::function<bool(const RunProgress&)> keep_going;
  /// main's clock, s. Only timing.json depends on it.
  std::function<double()> wall_s;
};

/// main's clock by these options, 0 when there is none.
[[nodiscard]] double wall_s(const SceneRunOptions& options);
/// timing.json, when there is a clock: the loop's parts, from `begun_s` to `looped_s`, and what came after.
/// \throws OutputError
void write_timing(robot::RunFolder& folder, Timing parts, double sim_s, double begun_s, double looped_s,
                  const SceneRunOptions& options);
/// What the scene expects, as the judge wants it.
[[nodiscard]] std::vector<FigureLimits> limits_of(const Scene& scene);
/// The unit of RunProgress, in the plural.
[[nodiscard]] const char* progress_unit_of(const Scene& scene);
/// RunProgress::total from the beginning.
[[nodiscard]] int progress_total_of(const Scene& scene);

}  // namespace sensotwin::twin
