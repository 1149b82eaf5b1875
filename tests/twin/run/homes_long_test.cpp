// SPDX-License-Identifier: MIT
// Homes that nobody here drew, twenty seeds each: the paper's explorers map what straight moves between
// neighbouring tags reach, ours whatever the antenna can be brought over at all.
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>
#include <string>
#include <tuple>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

class RealHomes : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(RealHomes, AreMappedToTheLastTileThatTheExplorerCanReachAndNeverWrong) {
  const auto& [name, explorer] = GetParam();
  if (!std::filesystem::exists(kMaps)) {
    GTEST_SKIP() << "the maps of ../shared/data/maps are not here";
  }
  int complete = 0;
  std::ostringstream report;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const MapResult result = *run_of(home(name, explorer, seed)).map;
    complete += result.tiles_missed == 0 ? 1 : 0;
    if (result.tiles_missed > 0 || result.tiles_wrong > 0) {
      report << "  seed " << seed << ": " << result.tiles_mapped << " mapped, " << result.tiles_missed
             << " missed, " << result.tiles_wrong << " wrong\n";
    }
    EXPECT_EQ(result.tiles_wrong, 0) << "seed " << seed;
    EXPECT_EQ(result.tiles_missed, 0) << "seed " << seed;
  }
  std::cout << name << ", " << explorer << ": " << complete << " of 20 runs complete\n" << report.str();
}

INSTANTIATE_TEST_SUITE_P(TwentySeeds, RealHomes,
                         testing::Combine(testing::Values("home_create2_perceptor", "home_room_minibot",
                                                          "home_small_house_aws", "home_turtlebot3_house"),
                                          testing::Values("dfm", "idfm", "sweep")),
                         [](const auto& of) { return std::get<0>(of.param) + "_" + std::get<1>(of.param); });

}  // namespace
}  // namespace sensotwin::twin
