// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "mapping_case.hpp"
#include "twin/run/hallway_run.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::uint64_t kSeeds = 20;

struct Tally {
  int runs{0};
  int arrived{0};
  int contacts{0};
  double length_m{0.0};
  double shortest_m{0.0};
};

/// From every place to every other, each with its own seeds.
Tally every_pair(const char* file, const std::vector<std::string>& set) {
  const auto scene_file = std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes" / file;
  const Scene base = read_scene(scene_file);
  const TemporaryFolder folder;
  Tally tally;
  for (const robot::HallwayNode& from : base.hallways.map.nodes()) {
    for (const robot::HallwayNode& to : base.hallways.map.nodes()) {
      for (std::uint64_t seed = 1; from.name != to.name && seed <= kSeeds; ++seed) {
        std::vector<std::string> changes = set;
        changes.push_back("mission.hallway={ from: " + from.name + ", to: " + to.name + " }");
        changes.push_back("robot.start=auto");
        const Scene scene = read_scene(scene_file, {.set = changes, .seed = seed});
        RunFolder results(folder / "run", Existing::kReplace);
        SceneRunOptions options;
        options.scene_as_given = file;
        options.pictures = false;
        const HallwayResult result = *run_hallway(scene, results, options).hallway;
        ++tally.runs;
        tally.arrived += result.arrived;
        tally.contacts += result.wall_contacts;
        tally.length_m += result.length_m;
        tally.shortest_m += result.shortest_m;
        EXPECT_EQ(result.arrived, 1) << from.name << " to " << to.name << ", seed " << seed;
      }
    }
  }
  std::printf("%s: %d of %d arrived, %d contacts, way %.4f of the shortest\n", file, tally.arrived,
              tally.runs, tally.contacts, tally.length_m / tally.shortest_m);
  return tally;
}

TEST(HallwaysOfTheOffice, AreGoneFromEveryPlaceToEveryOther) {
  const Tally tally = every_pair("office.yaml", {});
  EXPECT_EQ(tally.contacts, 0);
  EXPECT_LT(tally.length_m / tally.shortest_m, 1.05);
}

TEST(HallwaysOfTheOffice, AreGoneThoughATagInTenIsMissed) {
  const Tally tally = every_pair("office.yaml", {"robot.floor_reader.missed_share=0.1"});
  EXPECT_EQ(tally.contacts, 0);
  EXPECT_LT(tally.length_m / tally.shortest_m, 1.05);
}

}  // namespace
}  // namespace sensotwin::twin
