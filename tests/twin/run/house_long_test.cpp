// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

/// Over twenty seeds: of noise, slip, wheels and where exactly the tags lie.
double mean_minutes(const std::string& explorer) {
  constexpr int kSeeds = 20;
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const MapResult result =
        *run_of(published("house", {"mission.map.explorer=" + explorer, "mission.map.pace=own"},
                          static_cast<std::uint64_t>(seed)))
             .map;
    EXPECT_EQ(result.tiles_mapped, 207) << explorer << ", seed " << seed;
    EXPECT_EQ(result.tiles_wrong, 0) << explorer << ", seed " << seed;
    sum += result.minutes;
  }
  std::cout << explorer << ": " << sum / kSeeds << " min\n";
  return sum / kSeeds;
}

TEST(HouseAtTheRoombasOwnPace, NeedsFewerMinutesWithOurExplorerThanWithIdfmOrTheSpiral) {
  const double ours = mean_minutes("sweep");
  EXPECT_LT(ours, mean_minutes("idfm"));
  EXPECT_LT(ours, mean_minutes("spiral"));
}

}  // namespace
}  // namespace sensotwin::twin
