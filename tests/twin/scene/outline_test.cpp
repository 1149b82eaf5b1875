// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map_files.hpp"
#include "twin/scene/plane.hpp"

namespace sensotwin::twin {
namespace {

using testing::ElementsAre;

double enclosed_m2(const std::vector<world::Wall>& walls) {
  double area_m2 = 0.0;
  for (const world::Wall& wall : walls) {
    area_m2 += signed_area_m2(wall.points_m);
  }
  return area_m2;
}

TEST(Outline, OfARectangleHasFourCorners) {
  const auto walls = outline(drawn_map({"#####", "#...#", "#...#", "#####"}));
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_TRUE(walls[0].closed);
  EXPECT_THAT(walls[0].points_m, ElementsAre(Vec2(0.5, 0.5), Vec2(2.0, 0.5), Vec2(2.0, 1.5), Vec2(0.5, 1.5)));
}

TEST(Outline, ClosesAtTheEdgeOfThePicture) {
  const auto walls = outline(drawn_map({"..", ".."}));
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].points_m.size(), 4u);
}

TEST(Outline, OfAnObstacleRunsTheOtherWayRound) {
  const auto walls = outline(drawn_map({".....", ".....", "..#..", ".....", "....."}));
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_DOUBLE_EQ(signed_area_m2(walls[0].points_m), 25 * 0.25);
  EXPECT_DOUBLE_EQ(signed_area_m2(walls[1].points_m), -0.25);
}

TEST(Outline, KeepsASingleUnknownCell) {
  EXPECT_EQ(outline(drawn_map({"...", ".?.", "..."})).size(), 2u);
}

TEST(Outline, ClosesTheGapWhereTwoFreeCellsTouchAtACornerOnly) {
  const auto walls = outline(drawn_map({"#.", ".#"}));
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].points_m.size(), 4u);
  EXPECT_EQ(walls[1].points_m.size(), 4u);
}

TEST(Outline, OfNothingIsNothing) {
  EXPECT_TRUE(outline(drawn_map({"##", "??"})).empty());
}

TEST(Outline, EnclosesExactlyTheFreeCellsAndHasNoStraightCorner) {
  // 200 random pictures of 12 x 9 cells; the sum of signed areas is the free area whatever the shapes are.
  std::uint32_t state = 12345;
  for (int round = 0; round < 200; ++round) {
    OccupancyMap map{12, 9, 0.1, {{1.0, -2.0}, 0.3}, {}};
    for (int i = 0; i < 12 * 9; ++i) {
      state = state * 1664525u + 1013904223u;  // Numerical Recipes' generator: any fixed picture will do
      map.cells.push_back(state >> 30 == 0 ? Cell::kOccupied : Cell::kFree);
    }
    const auto walls = outline(map);
    EXPECT_NEAR(enclosed_m2(walls), counts(map, walls).free_m2, 1e-9);
    for (const world::Wall& wall : walls) {
      const std::size_t n = wall.points_m.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = wall.points_m[(i + 1) % n] - wall.points_m[i];
        const Vec2 b = wall.points_m[(i + 2) % n] - wall.points_m[(i + 1) % n];
        EXPECT_NEAR(a.normalized().dot(b.normalized()), 0.0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace sensotwin::twin
