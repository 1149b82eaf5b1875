// SPDX-License-Identifier: MIT
#include "twin/run/scene_run.hpp"

namespace sensotwin::twin {

Summary run_scene(const Scene& scene, RunFolder& folder, const SceneRunOptions& options) {
  if (scene.mission.hallway) {
    return run_hallway(scene, folder, options);
  }
  return scene.mission.phase ? run_phase(scene, folder, options) : run_mapping(scene, folder, options);
}

}  // namespace sensotwin::twin
