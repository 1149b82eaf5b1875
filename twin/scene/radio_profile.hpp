// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "twin/scene/problem.hpp"
#include "twin/scene/yaml_tree.hpp"

namespace sensotwin::twin {

/// Where a scene says `world.radio.file`, puts that file's `radio:` section (docs/calibrate.md) behind the
/// scene's own keys, as if written there; keys of the scene go before it. Mistakes in the file are told at
/// their place in it.
/// \param folder  of the scene  \param exit_code  becomes kExitMissing when the file cannot be read
void take_radio_profile(YamlNode& scene, const std::filesystem::path& folder, std::vector<Problem>& problems,
                        int& exit_code);

}  // namespace sensotwin::twin
