// SPDX-License-Identifier: MIT
#include "world/free_space.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rooms.hpp"

namespace sensotwin::world {
namespace {

using Tiles = std::set<std::pair<int, int>>;

/// A room drawn from above, one letter a tile, the last line at the bottom: '#' a closed block of the size of
/// the tile, '.' a tile, 'S' the robot's start, 'x' a dead tag, ' ' bare floor.
struct Drawing {
  explicit Drawing(const std::vector<std::string>& lines) {
    const double tile_m = world.carpet.tile_m;
    const auto rows = static_cast<int>(lines.size());
    const auto columns = static_cast<int>(lines.front().size());
    world.walls.push_back(room(columns * tile_m, rows * tile_m));
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const char what = lines[static_cast<std::size_t>(rows - 1 - row)][static_cast<std::size_t>(column)];
        const Vec2 corner_m{column * tile_m, row * tile_m};
        if (what == '#') {
          world.walls.push_back({.points_m = {corner_m, corner_m + Vec2{tile_m, 0.0},
                                              corner_m + Vec2{tile_m, tile_m}, corner_m + Vec2{0.0, tile_m}},
                                 .closed = true});
        } else if (what != ' ') {
          world.carpet.tiles.emplace_back(column, row);
        }
        if (what == 'x') {
          world.carpet.unreadable.emplace_back(column, row);
        }
        if (what == 'S') {
          robot.X_WR_start.p_m = corner_m + 0.5 * Vec2{tile_m, tile_m};
        }
      }
    }
  }
  WorldDescription world;
  RobotDescription robot = exact_robot();
};

TEST(FreeSpace, ReachesEveryTileOfAnOpenRoom) {
  const Drawing room({"...",  //
                      "S.."});
  const ReachableTiles tiles = reachable_tiles(room.world, room.robot);
  EXPECT_EQ(tiles.reachable.size(), 6U);
  EXPECT_EQ(tiles.grid_reachable, tiles.reachable);
}

TEST(FreeSpace, StopsAtClosedWallsAndSkipsDeadTags) {
  const Drawing room({"..#.",  //
                      "S.#.",  //
                      ".x#."});
  const ReachableTiles tiles = reachable_tiles(room.world, room.robot);
  const Tiles expected{{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(tiles.reachable, expected);
  EXPECT_EQ(tiles.grid_reachable, expected);
}

TEST(FreeSpace, GoesRoundWhereStraightMovesCannot) {
  // A leg in the middle between two tiles: the straight move is barred, the way round it over bare floor is
  // free.
  Drawing room({"    ",  //
                "S.  ",  //
                "    "});
  room.world.furniture.push_back({.name = "leg",
                                  .shape = FurnitureShape::kLegs,
                                  .X_WF = {{0.508, 1.5 * 0.508}, 0.0},
                                  .points_m = {{0.0, 0.0}},
                                  .tag = {}});
  const ReachableTiles tiles = reachable_tiles(room.world, room.robot);
  EXPECT_EQ(tiles.reachable, (Tiles{{0, 1}, {1, 1}}));
  EXPECT_EQ(tiles.grid_reachable, (Tiles{{0, 1}}));
}

TEST(FreeSpace, PassesADoorOnlyWhenTheDiscAndItsMarginFit) {
  for (const double door_m : {0.35, 0.37}) {  // the disc is 0.34 m wide, the margin 0.01 m on each side
    Drawing room({"S ."});
    const double x_m = 1.5 * 0.508;
    room.world.walls.push_back({.points_m = {{x_m, 0.0}, {x_m, 0.254 - 0.5 * door_m}}, .closed = false});
    room.world.walls.push_back({.points_m = {{x_m, 0.254 + 0.5 * door_m}, {x_m, 0.508}}, .closed = false});
    const ReachableTiles tiles = reachable_tiles(room.world, room.robot);
    EXPECT_EQ(tiles.reachable.count({2, 0}), door_m > 0.36 ? 1U : 0U) << door_m;
  }
}

TEST(FreeSpace, CountsATagAsReachedFromBesideItWithinTheReadRadius) {
  // A post keeps the disc 0.05 m and more from the tag of the second tile: 8 cm read it, 3 cm do not.
  Drawing room({"S.",  //
                "  "});
  const Vec2 tag_m{1.5 * 0.508, 1.5 * 0.508};
  room.world.furniture.push_back({.name = "post",
                                  .shape = FurnitureShape::kCircle,
                                  .X_WF = {tag_m + Vec2{0.15, 0.0}, 0.0},
                                  .radius_m = 0.02,
                                  .points_m = {},
                                  .tag = {}});
  EXPECT_EQ(reachable_tiles(room.world, room.robot).reachable.count({1, 1}), 1U);
  room.robot.floor_reader.read_radius_m = 0.03;
  EXPECT_EQ(reachable_tiles(room.world, room.robot).reachable.count({1, 1}), 0U);
  // An antenna 10 cm off the middle sweeps over it again.
  room.robot.floor_reader.at_m = {0.10, 0.0};
  EXPECT_EQ(reachable_tiles(room.world, room.robot).reachable.count({1, 1}), 1U);
}

TEST(FreeSpace, LeavesOutPushableFurnitureAndWhatTheRobotPassesBeneath) {
  for (const bool pushable : {true, false}) {
    Drawing room({"S.."});
    room.world.furniture.push_back({.name = "bar",
                                    .shape = FurnitureShape::kBox,
                                    .X_WF = {{1.5 * 0.508, 0.254}, 0.0},
                                    .size_m = {0.1, 0.5},
                                    .points_m = {},
                                    .pushable = pushable,
                                    .tag = {}});
    EXPECT_EQ(reachable_tiles(room.world, room.robot).reachable.size(), pushable ? 3U : 1U);
    room.world.furniture[0].clearance_m = 0.2;
    EXPECT_EQ(reachable_tiles(room.world, room.robot).grid_reachable.size(), 3U);
  }
}

TEST(FreeSpace, DoesNotCrossAHole) {
  Drawing room({"S. ."});
  room.world.cliffs.push_back({{{1.1, 0.0}, {1.4, 0.0}, {1.4, 0.508}, {1.1, 0.508}}});
  EXPECT_EQ(reachable_tiles(room.world, room.robot).reachable, (Tiles{{0, 0}, {1, 0}}));
}

}  // namespace
}  // namespace sensotwin::world
