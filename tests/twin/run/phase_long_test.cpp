// SPDX-License-Identifier: MIT
// Our own controller over 200 seeds. The paper's figures: PaperFigures in CMakeLists.txt.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "phase_case.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::uint64_t kSeeds = 200;

struct Seeds {
  std::vector<double> rmse_m;
  int arrived{0};
  int touched{0};
};

Seeds seeds_of(const std::string& scene, const std::vector<std::string>& set = {}) {
  Seeds seeds;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const PathResult path = path_of(published(scene, set, seed));
    seeds.rmse_m.push_back(path.rmse_m);
    seeds.arrived += path.arrived;
    seeds.touched += path.wall_contacts > 0 ? 1 : 0;
  }
  std::sort(seeds.rmse_m.begin(), seeds.rmse_m.end());
  return seeds;
}

double median(const Seeds& seeds) {
  return (seeds.rmse_m[kSeeds / 2 - 1] + seeds.rmse_m[kSeeds / 2]) / 2.0;
}

TEST(PhaseSeeds, OfOurOwnControllerArriveWithinCentimetresAndTouchNothing) {
  const std::vector<std::string> own{"mission.phase.controller=own", "mission.phase.corners=slow"};
  const Seeds hallway = seeds_of("hallway", own);
  EXPECT_EQ(hallway.arrived, static_cast<int>(kSeeds));
  EXPECT_EQ(hallway.touched, 0);
  EXPECT_LE(median(hallway), 0.02);
}

}  // namespace
}  // namespace sensotwin::twin
