// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/phase/estimation/path_bound.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/image_bound.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The posterior Cramer-Rao bound of a scene's path, leg by leg (robot/phase/estimation, path_bound.hpp).
struct SceneBound {
  std::vector<std::string> legs;  ///< where each ends: a tag's name, "lap" of a circle about a tag
  robot::PathBound bound;
};

/// What no estimator without bias can go below on the ideal path of the scene, at its speed, told what the
/// robot is told (phase_config_of), with the very reads that the scene's reader gives there: rounds, slots,
/// channels, and who is loud enough, without fading. Tags that are not there are left out of the path.
///
/// Whatever the mission's controller. The same for every seed of the scene.
///
/// \returns nothing when the scene has no path along ceiling tags of which anything is counted
[[nodiscard]] std::optional<SceneBound> bound_of(const Scene& scene);

/// What the best linear estimator makes of the scene's image sources (image_bound.hpp). Takes seconds.
/// \returns nothing without image sources, or where the path is no polyline of two legs, or the antennas do
/// not read at once
[[nodiscard]] std::optional<ImageBound> image_bound_of(const Scene& scene,
                                                       int draws = ImageBoundTask{}.draws);

/// As figures of a run.
[[nodiscard]] BoundResult figures_of(const SceneBound& bound);

}  // namespace sensotwin::twin
