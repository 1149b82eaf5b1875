// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The scene as YAML with every default and every choice of the twin (start, carpet's origin, pace) written
/// out. Reading the text again gives the same scene. \param folder  where the text will be saved: a map's
/// path is spelt from there. Empty: as the scene file spells it,
///                which reads back from the scene file's folder only
[[nodiscard]] std::string scene_yaml(const Scene& scene, const std::filesystem::path& folder = {});

}  // namespace sensotwin::twin
