// SPDX-License-Identifier: MIT
#include "twin/run/run_options.hpp"

#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {

std::vector<FigureLimits> limits_of(const Scene& scene) {
  std::vector<FigureLimits> limits;
  for (const Expectation& expectation : scene.expect) {
    limits.push_back({expectation.name, expectation.min, expectation.max});
  }
  return limits;
}

const char* progress_unit_of(const Scene& scene) {
  return scene.mission.phase ? "tags" : "tiles";
}

int progress_total_of(const Scene& scene) {
  return static_cast<int>(scene.mission.phase ? destinations_of(scene).size()
                                              : scene.world.carpet.tiles.size());
}

}  // namespace sensotwin::twin
