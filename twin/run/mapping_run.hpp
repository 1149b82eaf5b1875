// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/run_options.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Runs a mapping scene to its end, to its time limit or until it is told to stop, and leaves the folder:
/// summary.json, trace.csv, events.jsonl, map.pgm and map.yaml, timing.json, and with pictures floorplan.png,
/// oblique.png, progress.png, recovered.png, tags_over_time.png and snapshots/. One thread. \pre
/// scene.mission.map \returns what summary.json says \throws OutputError when the folder cannot be written;
/// files complete so far stay
Summary run_mapping(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options);

}  // namespace sensotwin::twin
