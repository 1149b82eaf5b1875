// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/run_options.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Runs a scene with hallways to its end, to its time limit or until it is told to stop, and leaves the
/// folder: summary.json, trace.csv, events.jsonl, timing.json, of a survey hallways.yaml, and with pictures
/// plan.png. One thread. \pre scene.mission.hallway \returns what summary.json says \throws OutputError when
/// the folder cannot be written; files complete so far stay
Summary run_hallway(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options);

}  // namespace sensotwin::twin
