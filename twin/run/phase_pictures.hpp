// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/phase_recorder.hpp"
#include "twin/run/phase_twin.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Draws what a run along ceiling tags came to into its folder: path.png (trajectory over the ideal path, and
/// error over time), plan.png and error.png (the two alone), oblique.png (ceiling tags in space),
/// controller.png (fuzzy: sets and curve), estimates.png (own: where it thought that the tags are).
/// \param may_go_on  asked between pictures  \returns false when it said no: those drawn so far stay
/// \throws OutputError; a missing renderer is one, with its remedy
[[nodiscard]] bool draw_phase_run(const Scene& scene, const PhaseTwin& twin, const PhaseRecorder& recorder,
                                  const PathResult& result, robot::RunFolder& folder,
                                  const std::function<bool()>& may_go_on);

}  // namespace sensotwin::twin
