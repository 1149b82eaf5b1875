// SPDX-License-Identifier: MIT
#include "twin/run/scene_run.hpp"

#include <cmath>
#include <utility>

#include "robot/base/random.hpp"

namespace sensotwin::twin {

Scene placed(Scene scene) {
  if (scene.robot.start_within_m > 0.0) {
    robot::RandomStream random = robot::RandomStream(scene.seed).fork("start");
    const double away_m = scene.robot.start_within_m * std::sqrt(random.uniform());
    const double bearing_rad = random.uniform(-robot::kPi, robot::kPi);
    scene.robot.X_WR_start.p_m += away_m * Vec2{std::cos(bearing_rad), std::sin(bearing_rad)};
    scene.robot.X_WR_start.yaw_rad = random.uniform(-robot::kPi, robot::kPi);
    scene.robot.start_within_m = 0.0;
  }
  return scene;
}

Summary run_scene(const Scene& unplaced, robot::RunFolder& folder, const SceneRunOptions& options) {
  const Scene scene = placed(unplaced);
  if (scene.mission.hallway) {
    return run_hallway(scene, folder, options);
  }
  return scene.mission.phase ? run_phase(scene, folder, options) : run_mapping(scene, folder, options);
}

}  // namespace sensotwin::twin
