// SPDX-License-Identifier: MIT
#include "twin/scene/floor_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene_texts.hpp"
#include "twin/scene/plane.hpp"

namespace sensotwin::twin {
namespace {

TEST(Plane, MeasuresFromPointAndSegmentToSegment) {
  EXPECT_DOUBLE_EQ(distance_m(Vec2{0, 1}, {{-1, 0}, {1, 0}}), 1.0);
  EXPECT_DOUBLE_EQ(distance_m(Vec2{4, 4}, {{-1, 0}, {1, 0}}), 5.0);
  EXPECT_DOUBLE_EQ(distance_m(Vec2{3, 4}, {{0, 0}, {0, 0}}), 5.0);
  EXPECT_DOUBLE_EQ(distance_m(Segment{{0, 0}, {2, 2}}, Segment{{0, 2}, {2, 0}}), 0.0);
  EXPECT_DOUBLE_EQ(distance_m(Segment{{0, 0}, {2, 0}}, Segment{{3, 1}, {3, 5}}), std::sqrt(2.0));
}

TEST(Plane, TellsConvexFromBentAndFromStarred) {
  EXPECT_TRUE(convex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(convex({{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
  EXPECT_FALSE(convex({{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}));
  EXPECT_FALSE(convex({{0, 0}, {1, 0}, {2, 0}, {1, 1}}));
  std::vector<Vec2> pentagram;
  for (int i = 0; i < 5; ++i) {
    const double yaw = 2.0 * i * 2.0 * robot::kPi / 5.0;
    pentagram.push_back({std::cos(yaw), std::sin(yaw)});
  }
  EXPECT_FALSE(convex(pentagram));
}

TEST(Plane, FindsAWallThatCrossesItself) {
  EXPECT_FALSE(crosses_itself({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
}

TEST(FloorPlan, MeasuresToEveryShapeOfFurniture) {
  const Segment here{{0, 0}, {0, 0}};
  world::Furniture piece;
  piece.X_WF = {{2.0, 0.0}, robot::kPi / 4};
  piece.shape = world::FurnitureShape::kCircle;
  piece.radius_m = 0.5;
  EXPECT_DOUBLE_EQ(distance_m(here, piece), 1.5);
  piece.shape = world::FurnitureShape::kBox;
  piece.size_m = {1.0, 1.0};
  EXPECT_NEAR(distance_m(here, piece), 2.0 - std::sqrt(0.5), 1e-12);
  piece.shape = world::FurnitureShape::kLegs;
  piece.points_m = {{0.0, 0.0}, {0.0, std::sqrt(2.0)}};
  piece.leg_radius_m = 0.1;
  EXPECT_NEAR(distance_m(here, piece), std::sqrt(2.0) - 0.1, 1e-12);
  piece.shape = world::FurnitureShape::kPolygon;
  piece.points_m = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
  EXPECT_EQ(distance_m(here, piece), 0.0);
}

TEST(FloorPlan, StartsInTheLargerOfTwoHalvesThatAWallDivides) {
  // The wall at x = 3 leaves 6 columns of tiles on the left, 2 on the right.
  const std::string divided =
      edited(edited(kSoundScene, "[0, 3]] }",
                    "[0, 3]], partitions: [{ points_m: [[3, 0], [3, 3]], closed: false }] }"),
             "{ at_m: [1, 1], heading_deg: 0 }", "auto");
  const Scene scene = read_scene_text(divided, "s.yaml");
  EXPECT_LT(scene.robot.X_WR_start.p_m.x(), 3.0);
  EXPECT_NEAR(scene.robot.X_WR_start.p_m.x(), 1.5, 0.2501);
}

TEST(FloorPlan, FindsNoStartWhereTheRobotDoesNotFit) {
  const std::string narrow =
      edited(edited(kSoundScene, "[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [4, 0], [4, 0.4], [0, 0.4]]"),
             "  furniture:\n    - { name: table, at_m: [2, 2], size_m: [1, 0.5] }\n", "");
  EXPECT_EQ(
      messages(edited(narrow, "{ at_m: [1, 1], heading_deg: 0 }", "auto")),
      "s.yaml:8:10: error: robot.start: no tile has room for the robot; expected a start: { at_m: [x, y], "
      "heading_deg: 0 }");
}

}  // namespace
}  // namespace sensotwin::twin
