// SPDX-License-Identifier: MIT
#include "robot/mapping/tile_map.hpp"

#include <gmock/gmock.h>

#include "robot/mapping/explorer_kind.hpp"
#include "robot/mapping/route.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TileMap, RefusesATagThatIsKnownOnAnotherTile) {
  TileMap map;
  ASSERT_TRUE(map.mark_visited({0, 0}, 7));
  EXPECT_FALSE(map.mark_visited({1, 0}, 7));
  EXPECT_FALSE(map.visited({1, 0}));
  EXPECT_TRUE(map.mark_visited({0, 0}, 7)) << "the same again is no contradiction";
}

TEST(TileMap, RefusesASecondTagOnOneTile) {
  TileMap map;
  ASSERT_TRUE(map.mark_visited({0, 0}, 7));
  EXPECT_FALSE(map.mark_visited({0, 0}, 8));
  EXPECT_EQ(map.tag_on({0, 0}), TagUid{7});
  EXPECT_FALSE(map.tile_of(8).has_value());
}

TEST(TileMap, SharesAPassageBetweenItsTwoTiles) {
  TileMap map;
  map.mark_passage({0, 0}, Direction::kEast, Passage::kBlocked);
  EXPECT_EQ(map.passage({1, 0}, Direction::kWest), Passage::kBlocked);
  EXPECT_EQ(map.passage({1, 0}, Direction::kEast), Passage::kUnknown);
}

TEST(TileMap, IsWhiteThenGreyThenBlack) {
  TileMap map;
  EXPECT_EQ(map.color({0, 0}), TileColor::kWhite);
  ASSERT_TRUE(map.mark_visited({0, 0}, 1));
  EXPECT_EQ(map.color({0, 0}), TileColor::kGrey);
  map.mark_passage({0, 0}, Direction::kEast, Passage::kBlocked);
  map.mark_unreachable({0, 1});
  ASSERT_TRUE(map.mark_visited({-1, 0}, 2));
  EXPECT_EQ(map.color({0, 0}), TileColor::kGrey) << "south is still open";
  ASSERT_TRUE(map.mark_visited({0, -1}, 3));
  EXPECT_EQ(map.color({0, 0}), TileColor::kBlack);
}

TEST(TileMap, GrowsInAllFourDirections) {
  TileMap map;
  for (const Tile t : {Tile{0, 0}, Tile{40, 0}, Tile{-40, 3}, Tile{2, 50}, Tile{1, -50}}) {
    ASSERT_TRUE(map.mark_visited(t, static_cast<TagUid>(1000 + 100 * t.column + t.row)));
  }
  for (const auto& [tile, tag] : map.tiles()) EXPECT_TRUE(map.visited(tile));
  EXPECT_EQ(map.visited_bounds(), (TileBounds{{-40, -50}, {40, 50}}));
}

TEST(ShortestRoute, GoesRoundABlockedPassageWithTheFewestTurns) {
  TileMap map;  // 3 x 2 tiles, all visited
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(map.mark_visited({i % 3, i / 3}, static_cast<TagUid>(i + 1)));
  EXPECT_THAT(shortest_route(map, {0, 0}, Direction::kEast, {{2, 0}}), ElementsAre(Tile{1, 0}, Tile{2, 0}));
  map.mark_passage({1, 0}, Direction::kEast, Passage::kBlocked);
  // Over the north row; up at once and then straight is one turn cheaper than east, north, east.
  EXPECT_THAT(shortest_route(map, {0, 0}, Direction::kNorth, {{2, 0}}),
              ElementsAre(Tile{0, 1}, Tile{1, 1}, Tile{2, 1}, Tile{2, 0}));
  map.mark_passage({1, 1}, Direction::kEast, Passage::kBlocked);
  EXPECT_THAT(shortest_route(map, {0, 0}, Direction::kNorth, {{2, 0}}), IsEmpty());
}

TEST(ExplorerKind, ReadsEachNameThatItWrites) {
  for (const ExplorerKind kind : kExplorerKinds) EXPECT_EQ(explorer_kind_from(name_of(kind)), kind);
  EXPECT_FALSE(explorer_kind_from("IDFM").has_value());
}

}  // namespace
}  // namespace sensotwin::robot
