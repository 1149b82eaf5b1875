// SPDX-License-Identifier: MIT
#include "twin/run/run_options.hpp"

#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {

double wall_s(const SceneRunOptions& options) {
  return options.wall_s ? options.wall_s() : 0.0;
}

void write_timing(robot::RunFolder& folder, Timing parts, double sim_s, double begun_s, double looped_s,
                  const SceneRunOptions& options) {
  if (!options.wall_s) {
    return;
  }
  parts.sim_s = sim_s;
  parts.wall_s = looped_s - begun_s;
  parts.render_s = options.wall_s() - looped_s;
  folder.write("timing.json", to_json(parts));
}

std::vector<FigureLimits> limits_of(const Scene& scene) {
  std::vector<FigureLimits> limits;
  for (const Expectation& expectation : scene.expect) {
    limits.push_back({expectation.name, expectation.min, expectation.max});
  }
  return limits;
}

const char* progress_unit_of(const Scene& scene) {
  return scene.mission.hallway ? "missions" : scene.mission.phase ? "tags" : "tiles";
}

int progress_total_of(const Scene& scene) {
  if (scene.mission.hallway) {
    return 1;
  }
  return static_cast<int>(scene.mission.phase ? destinations_of(scene).size()
                                              : scene.world.carpet.tiles.size());
}

}  // namespace sensotwin::twin
