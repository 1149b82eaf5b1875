// SPDX-License-Identifier: MIT
#pragma once

#include "twin/run/hallway_run.hpp"
#include "twin/run/mapping_run.hpp"
#include "twin/run/phase_run.hpp"

namespace sensotwin::twin {

/// Runs a scene, whatever its mission: see run_mapping(), run_phase() and run_hallway().
Summary run_scene(const Scene& scene, RunFolder& folder, const SceneRunOptions& options);

}  // namespace sensotwin::twin
