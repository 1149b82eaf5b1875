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

/// Arrived and touching, of a variant's 200 seeds.
Seeds variant_of(const std::string& scene, const std::string& variant) {
  Seeds seeds;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const PathResult path =
        path_of(read_scene(kSource / "scenes" / (scene + ".yaml"), {.seed = seed, .variant = variant}));
    seeds.rmse_m.push_back(path.rmse_m);
    seeds.arrived += path.arrived;
    seeds.touched += path.wall_contacts > 0 ? 1 : 0;
  }
  std::sort(seeds.rmse_m.begin(), seeds.rmse_m.end());
  return seeds;
}

TEST(PhaseSeeds, WithARealReadersRadioAllArriveAndTheHallwayIsWithinItsGoal) {
  for (const char* scene : {"line_at_90", "line_at_0", "complex_path", "circle", "smooth_curve", "hallway"}) {
    const Seeds seeds = variant_of(scene, "r420");
    EXPECT_EQ(seeds.arrived, static_cast<int>(kSeeds)) << scene;
    EXPECT_EQ(seeds.touched, 0) << scene;
    EXPECT_LE(median(seeds), 0.15) << scene;
    EXPECT_LE(seeds.rmse_m[189], 0.40) << scene;
  }
}

TEST(PhaseSeeds, WithFaultsNeverTouchAWallOfTheHallway) {
  for (const char* variant : {"fault_silent", "fault_half_lost", "fault_missing", "fault_cables",
                              "fault_noise", "fault_shadow", "fault_fuzzy_silent"}) {
    EXPECT_EQ(variant_of("hallway", variant).touched, 0) << variant;
  }
}

}  // namespace
}  // namespace sensotwin::twin
