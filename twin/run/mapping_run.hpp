// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "twin/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// How far a run is, for a progress bar.
struct RunProgress {
  double sim_s{0.0};
  int tiles_found{0};
  int tiles_total{0};
};

struct MappingRunOptions {
  std::string scene_as_given;  ///< as summary.json names it
  int trace_every{7};          ///< ticks from row to row of trace.csv
  bool pictures{true};
  /// Asked a few hundred times a simulated hour, and between pictures; false ends the run in order, with
  /// valid files and no further picture.
  std::function<bool(const RunProgress&)> keep_going;
  /// main's clock, s. Only timing.json depends on it.
  std::function<double()> wall_s;
};

/// What the scene expects, as the judge wants it.
[[nodiscard]] std::vector<FigureLimits> limits_of(const Scene& scene);

/// Runs a mapping scene to its end, to its time limit or until it is told to stop, and leaves the folder:
/// summary.json, trace.csv, events.jsonl, map.pgm and map.yaml, timing.json, and with pictures floorplan.png,
/// oblique.png, progress.png, recovered.png, tags_over_time.png and snapshots/. One thread. \pre
/// scene.mission.map \returns what summary.json says \throws OutputError when the folder cannot be written;
/// files complete so far stay
Summary run_mapping(const Scene& scene, RunFolder& folder, const MappingRunOptions& options);

}  // namespace sensotwin::twin
