// SPDX-License-Identifier: MIT
// A move from tag to tag meets its tag, or the search that follows does.
#include "moves.hpp"

#include <gtest/gtest.h>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

TEST(Moves, MissAtMostThreeInAHundredTagsAndRecoverThemAll) {
  MoveCount count;
  count.add(published("house", {"mission.map.explorer=idfm"}, 11));
  count.add(published("room_324", {"mission.map.explorer=idfm"}, 12));
  EXPECT_GE(count.moves, 500);
  EXPECT_LE(count.missed, kMissedMax * count.moves) << count.report;
  EXPECT_EQ(count.recovered, count.missed) << count.report;
}

}  // namespace
}  // namespace sensotwin::twin
