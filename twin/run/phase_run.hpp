// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/run_options.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Runs a scene along ceiling tags to its end, to its time limit or until it is told to stop, and leaves the
/// folder: summary.json, trace.csv, events.jsonl, timing.json, the tag log where asked, and with pictures
/// those of phase_pictures.hpp. One thread. \pre scene.mission.phase
/// \returns what summary.json says
/// \throws OutputError when the folder cannot be written; files complete so far stay
Summary run_phase(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options);

}  // namespace sensotwin::twin
