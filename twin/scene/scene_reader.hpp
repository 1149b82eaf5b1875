// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/config/problem.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// What the command line changes in a scene before it is read.
struct SceneOverrides {
  /// "key.path=value", the value in YAML: "mission.map.explorer=dfm", "world.furniture[0].mass_kg=4".
  /// Sections on the way that the file leaves out are made.
  std::vector<std::string> set{};
  std::optional<std::uint64_t> seed{};
  /// One of the scene's `variants:` (variant.hpp), taken before `set`; empty: the scene as it is.
  std::string variant{};
};

/// Reads a scene file and the map it names, strictly: a scene with any mistake does not run.
/// \param file  spelt in messages as it is here; a map is looked for relative to its folder
/// \throws SceneError  every mistake found in one pass (the first 20), each with file, line and column or the
/// option
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

/// As read_scene(), of a text that is already in memory. \param file  where it would be found
[[nodiscard]] Scene read_scene_text(const std::string& text, const std::filesystem::path& file,
                                    const SceneOverrides& overrides = {});

}  // namespace sensotwin::twin
