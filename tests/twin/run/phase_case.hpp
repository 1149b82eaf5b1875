// SPDX-License-Identifier: MIT
#pragma once

#include "mapping_case.hpp"
#include "twin/run/scene_run.hpp"

namespace sensotwin::twin {

/// Runs a scene along ceiling tags to its end, into `folder`, its reads logged beside. \param pictures  they
/// take a second
inline Summary phase_run(const std::filesystem::path& folder, const Scene& scene, bool pictures = false) {
  robot::RunFolder results(folder, robot::Existing::kRefuse);
  SceneRunOptions options;
  options.scene_as_given = scene.name;
  options.pictures = pictures;
  options.tag_log = folder / "reads.csv";
  return run_scene(scene, results, options);
}

/// Runs to the end and keeps the figures of the path only.
inline PathResult path_of(const Scene& scene) {
  const TemporaryFolder folder;
  return *phase_run(folder / "run", scene).path;
}

}  // namespace sensotwin::twin
