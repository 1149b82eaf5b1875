// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>

#include "moves.hpp"

namespace sensotwin::twin {
namespace {

TEST(TenThousandMoves, MissAtMostThreeInAHundredTagsAndRecoverThemAll) {
  MoveCount count;
  for (std::uint64_t seed = 1; count.moves < 10000; ++seed) {
    for (const char* scene : {"house", "room_324"}) {
      for (const char* explorer : {"bfm", "dfm", "idfm", "sweep"}) {
        count.add(published(scene, {std::string("mission.map.explorer=") + explorer}, seed));
      }
    }
  }
  std::cout << count.moves << " moves, " << count.missed << " missed their tag ("
            << 100.0 * count.missed / count.moves << " %), " << count.recovered << " recovered\n";
  EXPECT_LE(count.missed, kMissedMax * count.moves) << count.report;
  EXPECT_EQ(count.recovered, count.missed) << count.report;
}

}  // namespace
}  // namespace sensotwin::twin
