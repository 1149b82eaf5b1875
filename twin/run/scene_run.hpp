// SPDX-License-Identifier: MIT
#pragma once

#include "twin/run/hallway_run.hpp"
#include "twin/run/mapping_run.hpp"
#include "twin/run/phase_run.hpp"

namespace sensotwin::twin {

/// The scene with the start of its own seed, where robot.start.within_m asks for one; else as it is.
[[nodiscard]] Scene placed(Scene scene);

/// Runs a scene from its seed's start, whatever its mission: see run_mapping(), run_phase() and
/// run_hallway().
Summary run_scene(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options);

}  // namespace sensotwin::twin
