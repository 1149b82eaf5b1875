// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "carpet.hpp"
#include "robot/mapping/sweep.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::IsTrue;

TEST(Detours, FindTagsThatNoStraightMoveLeadsTo) {
  // A jamb stands in every straight way into the right half.
  Carpet carpet{{"....", "S..."}};
  carpet.wall({1, 0}, Direction::kEast);
  carpet.wall({1, 1}, Direction::kEast);
  Walk walk{.carpet = carpet};
  Sweep sweep;
  ASSERT_TRUE(walk.run(sweep, 1000));
  EXPECT_TRUE(walk.map.visited({2, 0}));
  EXPECT_TRUE(walk.map.visited({3, 1}));
  EXPECT_THAT(walk.detours, Each(Field(&Move::detour, IsTrue())));
  EXPECT_EQ(walk.claimed_twice, 0);
}

TEST(Detours, GoOnRoundTilesThatADetourFound) {
  // Each tag touches the next at a corner only.
  const Carpet carpet{{"##.", "#.#", "S##"}};
  Walk walk{.carpet = carpet};
  Sweep sweep;
  ASSERT_TRUE(walk.run(sweep, 1000));
  EXPECT_TRUE(walk.map.visited({2, 2}));
}

TEST(Detours, AreTriedOnceEachAndThenTheMapIsComplete) {
  const Carpet carpet{{"S"}};
  Walk walk{.carpet = carpet};
  Sweep sweep;
  ASSERT_TRUE(walk.run(sweep, 1000));
  EXPECT_EQ(walk.detours.size(), 8u) << "the eight tiles around the only one";
  EXPECT_FALSE(sweep.next(walk.map, walk.at, walk.heading).has_value());
}

TEST(Detours, StartWithTheNearest) {
  TileMap map;
  for (int column = 0; column < 5; ++column) {
    ASSERT_TRUE(map.mark_visited({column, 0}, static_cast<TagUid>(column + 1)));
    for (const int row : {-1, 1}) map.mark_unreachable({column, row});
  }
  for (const int row : {-1, 0, 1}) map.mark_unreachable({5, row});
  for (const int row : {-1, 1}) map.mark_unreachable({-1, row});
  EXPECT_EQ(nearest_detour(map, {4, 0}), (Tile{-1, 0})) << "the only one left";
  map.mark_unreachable({-1, 0});
  EXPECT_FALSE(nearest_detour(map, {4, 0}).has_value());
}

TEST(Detours, WaitForTheLastStraightMove) {
  TileMap map;
  ASSERT_TRUE(map.mark_visited({0, 0}, 1));
  for (const Direction side : {Direction::kNorth, Direction::kWest, Direction::kSouth}) {
    map.mark_passage({0, 0}, side, Passage::kBlocked);
  }
  Sweep sweep;
  const auto move = sweep.next(map, {0, 0}, Direction::kEast);
  ASSERT_TRUE(move.has_value());
  EXPECT_FALSE(move->detour);
  EXPECT_EQ(move->target, (Tile{1, 0}));
}

}  // namespace
}  // namespace sensotwin::robot
