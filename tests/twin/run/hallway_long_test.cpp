// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hallway_case.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::uint64_t kSeeds = 20;

/// From every place to every other of a building, each with its own seeds.
class HallwaysOf : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::string(GetParam()) != "office" && !std::filesystem::exists(kMaps)) {
      GTEST_SKIP() << "the maps of ../shared/data/maps are not here";
    }
  }
  [[nodiscard]] static HallwayTally all(const std::vector<std::string>& set) {
    return every_pair(GetParam(), "", set, kSeeds);
  }
};

TEST_P(HallwaysOf, AreGoneFromEveryPlaceToEveryOther) {
  const HallwayTally tally = all({});
  EXPECT_EQ(tally.arrived, tally.runs);
  EXPECT_EQ(tally.contacts, 0);
  EXPECT_LT(tally.length_m / tally.shortest_m, 1.05);
}

TEST_P(HallwaysOf, AreGoneThoughATagInTenIsMissed) {
  const HallwayTally tally = all({"robot.floor_reader.missed_share=0.1"});
  EXPECT_EQ(tally.arrived, tally.runs);
  // Who takes a place by the sonars stands less exactly in it. In the basement that leads beside a pillar,
  // and past a corner between two cones: the bumper touches what no rangefinder sees.
  EXPECT_LE(tally.contacts, 0.01 * tally.runs);
  EXPECT_GT(tally.missed, 0);
  EXPECT_LT(tally.length_m / tally.shortest_m, 1.05);
}

TEST_P(HallwaysOf, AreGoneThoughOneIsBlocked) {
  const HallwayTally tally = every_pair(GetParam(), "blocked", {}, kSeeds);
  EXPECT_GE(tally.arrived, 0.95 * tally.runs);
  EXPECT_EQ(tally.silent, 0);
}

TEST_P(HallwaysOf, AreGoneThoughOneExitInTwentyIsWrong) {
  const HallwayTally tally = all({"world.shoves.share=0.05"});
  EXPECT_GE(tally.arrived, 0.95 * tally.runs);
  EXPECT_EQ(tally.silent, 0);
  EXPECT_GT(tally.shoved, 0);
}

INSTANTIATE_TEST_SUITE_P(Each, HallwaysOf,
                         ::testing::Values("office", "buildings/stata", "buildings/hospital"),
                         [](const ::testing::TestParamInfo<const char*>& each) {
                           const std::string file = each.param;
                           return file.substr(file.rfind('/') + 1);
                         });

}  // namespace
}  // namespace sensotwin::twin
