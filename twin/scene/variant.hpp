// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/config/yaml_tree.hpp"

namespace sensotwin::twin {

/// Takes the section `variants:` out of a scene and does what the chosen one says, so that the rest is read
/// and checked as if the file said it itself:
///
///   variants:
///     slow:                               # twin run SCENE --variant slow
///       mission.phase.speed_mps: 0.1      # a path as of --set, and what replaces it
///       expect: { rmse_m: { max: 0.02 } }
///     slow_and_noisy:
///       from: slow                                   # a variant above: first what it says, then this
///       world.radio.noise_scale: 3
///
/// \param chosen  name of a variant; empty: the scene as it is
/// \param problems  mistakes are appended with their places; values of variants that are not chosen are not
/// looked at \returns the names of all variants, in the order of the file
[[nodiscard]] std::vector<std::string> take_variant(robot::YamlNode& root, const std::string& chosen,
                                                    std::vector<robot::Problem>& problems);

}  // namespace sensotwin::twin
