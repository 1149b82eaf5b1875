// SPDX-License-Identifier: MIT
#include "twin/study/grid_room.hpp"

#include <gtest/gtest.h>

#include "robot/mapping/explorer_kind.hpp"
#include "twin/study/grid_drive.hpp"
#include "twin/study/obstacle_room.hpp"

namespace sensotwin::twin {
namespace {

using robot::Direction;
using robot::ExplorerKind;
using robot::Tile;

DriveTally drive_by(ExplorerKind kind, const GridRoom& room, const DriveOptions& options) {
  const auto explorer = robot::make_explorer(kind);
  return drive(*explorer, room, options);
}

TEST(GridRoom, IsReadFromItsPicture) {
  const std::string picture =
      ".#.\n"
      "S..\n";
  const GridRoom room = GridRoom::from_picture(picture);
  EXPECT_EQ(room.start(), (Tile{0, 0}));
  EXPECT_FALSE(room.free({1, 1}));
  EXPECT_FALSE(room.free({3, 0})) << "nothing lies outside";
  EXPECT_EQ(room.reachable().size(), 5u);
  EXPECT_EQ(room.picture(), picture);
}

TEST(GridRoom, WallsCloseAPassageFromBothSides) {
  GridRoom room = GridRoom::from_picture("S.\n");
  room.build_wall({0, 0}, Direction::kEast);
  EXPECT_FALSE(room.open({0, 0}, Direction::kEast));
  EXPECT_FALSE(room.open({1, 0}, Direction::kWest));
  EXPECT_EQ(room.reachable().size(), 1u);
}

TEST(GridDrive, CountsMovesTurnsAndBumps) {
  const GridRoom room = GridRoom::from_picture(
      "#.\n"
      "S.\n");
  const DriveTally knows = drive_by(ExplorerKind::kIdfm, room, {});
  EXPECT_EQ(knows.moves, 2);
  EXPECT_EQ(knows.quarter_turns, 1);
  EXPECT_EQ(knows.bumps, 0);
  EXPECT_DOUBLE_EQ(knows.physical_epsilon(), 0.0);
  EXPECT_DOUBLE_EQ(knows.paper_epsilon(), 0.0);
  const DriveTally tries = drive_by(ExplorerKind::kIdfm, room, {.knowledge = Knowledge::kBump});
  EXPECT_EQ(tries.bumps, 1) << "the east wall";
}

TEST(GridDrive, DfmDrivesEveryTagTwice) {
  const GridRoom room = obstacle_room({20, 8}, robot::RandomStream{3});
  const DriveTally tally = drive_by(ExplorerKind::kDfm, room, {.to_the_end = true});
  EXPECT_EQ(tally.moves, 2 * (tally.tags - 1));
  EXPECT_TRUE(tally.ended);
}

TEST(ObstacleRoom, BlocksThePercentageInSeparateChunks) {
  for (const int percent : {5, 15, 30}) {
    for (const int chunks : {1, 7, 16}) {
      const GridRoom room = obstacle_room({percent, chunks}, robot::RandomStream{11});
      int blocked = 0;
      int chunks_found = 0;
      robot::TileGrid<bool> seen{room.bounds(), false};
      for (int column = 0; column < kStudyRoomSide; ++column) {
        for (int row = 0; row < kStudyRoomSide; ++row) {
          const Tile t{column, row};
          if (room.free(t)) continue;
          ++blocked;
          if (seen.at(t)) continue;
          ++chunks_found;
          std::vector<Tile> queue{t};  // eight neighbours: chunks that touch at a corner would be one
          seen.ref(t) = true;
          while (!queue.empty()) {
            const Tile c = queue.back();
            queue.pop_back();
            for (int dx = -1; dx <= 1; ++dx) {
              for (int dy = -1; dy <= 1; ++dy) {
                const Tile n{c.column + dx, c.row + dy};
                if (!room.bounds().contains(n) || room.free(n) || seen.at(n)) continue;
                seen.ref(n) = true;
                queue.push_back(n);
              }
            }
          }
        }
      }
      EXPECT_EQ(blocked, static_cast<int>(percent * 3.24 + 0.5));
      EXPECT_EQ(chunks_found, chunks);
    }
  }
}

}  // namespace
}  // namespace sensotwin::twin
