// SPDX-License-Identifier: MIT
// The paper's experiment: 207 tiles, three explorers (SensoBot, chapter 5: 69, 42 and 26 minutes).
#include <gtest/gtest.h>

#include <cmath>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

MapResult house_by(const std::string& explorer, const std::string& pace = "paper") {
  return *run_of(published("house", {"mission.map.explorer=" + explorer, "mission.map.pace=" + pace})).map;
}

TEST(House, IsMappedByIdfmAtThePapersPaceWithNoTileWrong) {
  const MapResult idfm = house_by("idfm");
  EXPECT_EQ(idfm.tiles_grid_reachable, 207);
  EXPECT_EQ(idfm.tiles_mapped, 207);
  EXPECT_EQ(idfm.tiles_missed, 0);
  EXPECT_EQ(idfm.tiles_wrong, 0);
}

TEST(House, TakesBreadthFirstLongerThanDepthFirstAndThatLongerThanItsImprovement) {
  const MapResult bfm = house_by("bfm");
  const MapResult dfm = house_by("dfm");
  const MapResult idfm = house_by("idfm");
  EXPECT_GT(bfm.minutes, dfm.minutes);
  EXPECT_GT(dfm.minutes, idfm.minutes);
  for (const MapResult& result : {bfm, dfm, idfm}) {
    EXPECT_EQ(result.tiles_mapped, 207) << result.explorer;
    EXPECT_EQ(result.tiles_wrong, 0) << result.explorer;
  }
  // As whole numbers: the exact minutes are what scenes/house.yaml expects.
  RecordProperty("bfm_min", static_cast<int>(std::lround(bfm.minutes)));
  RecordProperty("dfm_min", static_cast<int>(std::lround(dfm.minutes)));
  RecordProperty("idfm_min", static_cast<int>(std::lround(idfm.minutes)));
}

TEST(House, IsMappedFasterAtTheRoombasOwnPace) {
  const MapResult paper = house_by("idfm");
  const MapResult own = house_by("idfm", "own");
  EXPECT_EQ(own.tiles_mapped, 207);
  EXPECT_EQ(own.tiles_wrong, 0);
  EXPECT_LT(own.minutes, paper.minutes);
}

// What users feel is minutes, and turns cost. At the Roomba's own pace the explorers lie closer together than
// seeds do: house_long_test.cpp compares their means.
TEST(House, NeedsFewerMinutesWithOurExplorerThanWithIdfmOrTheSpiral) {
  const MapResult ours = house_by("sweep");
  EXPECT_EQ(ours.tiles_mapped, 207);
  EXPECT_EQ(ours.tiles_wrong, 0);
  EXPECT_LT(ours.minutes, house_by("idfm").minutes);
  EXPECT_LT(ours.minutes, house_by("spiral").minutes);
}

}  // namespace
}  // namespace sensotwin::twin
