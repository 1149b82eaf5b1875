// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "mapping_case.hpp"

namespace sensotwin::twin {
namespace {

// The other homes, every explorer and twenty seeds: homes_long_test.cpp.
TEST(RealHome, IsNeverMappedWrong) {
  if (!std::filesystem::exists(kMaps)) {
    GTEST_SKIP() << "the maps of ../shared/data/maps are not here";
  }
  const MapResult result = *run_of(home("home_room_minibot", "sweep", 1)).map;
  EXPECT_EQ(result.tiles_wrong, 0);
  EXPECT_GT(result.tiles_mapped, 0);
}

}  // namespace
}  // namespace sensotwin::twin
