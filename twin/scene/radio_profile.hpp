// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/config/yaml_tree.hpp"

namespace sensotwin::twin {

/// Where a scene says `world.radio.file`, puts that file's `radio:` section (docs/calibrate.md) behind the
/// scene's own keys, as if written there; keys of the scene go before it. Mistakes in the file are told at
/// their place in it.
/// \param folder  of the scene  \param exit_code  becomes kExitMissing when the file cannot be read
void take_radio_profile(robot::YamlNode& scene, const std::filesystem::path& folder,
                        std::vector<robot::Problem>& problems, int& exit_code);

}  // namespace sensotwin::twin
