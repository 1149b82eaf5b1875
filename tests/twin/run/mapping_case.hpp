// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin/run/mapping_run.hpp"
#include "twin/scene/scene_reader.hpp"

/// Whole runs, in this process, as `twin run` does them.
namespace sensotwin::twin {

inline const std::filesystem::path kSource = SENSOTWIN_SOURCE_DIR;
/// Homes that nobody here drew; a test that needs them says so when they are not there.
inline const std::filesystem::path kMaps = kSource / "../shared/data/maps";

/// A scene of scenes/, changed as by --set and --seed.
inline Scene published(const std::string& name, const std::vector<std::string>& set = {},
                       std::optional<std::uint64_t> seed = {}) {
  return read_scene(kSource / "scenes" / (name + ".yaml"), {.set = set, .seed = seed});
}

/// A home of kMaps under carpet, as `twin import` makes it. The robot is put down where the reader finds a
/// place.
inline Scene home(const std::string& name, const std::string& explorer, std::uint64_t seed) {
  const std::string text = "version: 1\nseed: " + std::to_string(seed) +
                           "\nworld: { map: { file: map.yaml } }\nmission: { map: { explorer: " + explorer +
                           " } }\n";
  return read_scene_text(text, kMaps / name / "scene.yaml");
}

/// Runs to the end, into `folder`. \param pictures  they take seconds
inline Summary run_into(const std::filesystem::path& folder, const Scene& scene, bool pictures = false) {
  robot::RunFolder results(folder, robot::Existing::kRefuse);
  SceneRunOptions options;
  options.scene_as_given = scene.name;
  options.pictures = pictures;
  return run_mapping(scene, results, options);
}

/// Runs to the end and keeps the summary only.
inline Summary run_of(const Scene& scene) {
  const TemporaryFolder folder;
  return run_into(folder / "run", scene);
}

/// Every file below a folder by its relative name, whole.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    }
  }
  return files;
}

}  // namespace sensotwin::twin
