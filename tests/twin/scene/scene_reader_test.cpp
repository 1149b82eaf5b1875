// SPDX-License-Identifier: MIT
#include "twin/scene/scene_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(SceneReader, FillsWhatTheFileSaysAndLeavesTheRestAtItsDefault) {
  const Scene scene = read_scene_text(kSoundScene, "scenes/table.yaml");
  EXPECT_EQ(scene.name, "table");
  EXPECT_EQ(scene.title, "A room with a table.");
  EXPECT_EQ(scene.seed, 7u);
  ASSERT_EQ(scene.world.walls.size(), 1u);
  EXPECT_EQ(scene.world.walls[0].points_m[2], Vec2(4.0, 3.0));
  ASSERT_EQ(scene.world.furniture.size(), 1u);
  EXPECT_EQ(scene.world.furniture[0].shape, world::FurnitureShape::kBox);
  EXPECT_EQ(scene.world.furniture[0].size_m, Vec2(1.0, 0.5));
  EXPECT_EQ(scene.world.furniture[0].mass_kg, world::Furniture{}.mass_kg);
  EXPECT_EQ(scene.robot.base.radius_m, world::RoombaDescription{}.radius_m);
  EXPECT_EQ(scene.robot.forward_reader.read_radius_m, world::RobotDescription{}.forward_reader.read_radius_m);
  ASSERT_TRUE(scene.mission.map);
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kIdfm);
  ASSERT_EQ(scene.expect.size(), 1u);
  EXPECT_EQ(scene.expect[0].name, "tiles_mapped");
  EXPECT_EQ(scene.expect[0].min, 1.0);
  EXPECT_EQ(scene.expect[0].max, std::nullopt);
}

TEST(SceneReader, TurnsDegreesIntoRadians) {
  const Scene scene = read_scene_text(edited(kSoundScene, "heading_deg: 0", "heading_deg: 90"), "s.yaml");
  EXPECT_DOUBLE_EQ(scene.robot.X_WR_start.yaw_rad, robot::kPi / 2);
}

TEST(SceneReader, TakesTheTitleKeyBeforeTheFirstComment) {
  EXPECT_EQ(read_scene_text(edited(kSoundScene, "seed: 7", "seed: 7\ntitle: Another"), "s.yaml").title,
            "Another");
  EXPECT_EQ(read_scene_text("# SPDX-License-Identifier: MIT\n#\n" + kSoundScene, "s.yaml").title,
            "A room with a table.");
}

TEST(SceneReader, MapsTheCarpetByOurOwnExplorerWhenTheSceneNamesNoMission) {
  const Scene scene =
      read_scene_text(edited(kSoundScene, "mission:\n  map: { explorer: idfm }\n", ""), "s.yaml");
  ASSERT_TRUE(scene.mission.map);
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kSweep);
}

TEST(SceneReader, KnowsThePaceOfThePaperByName) {
  const Scene scene =
      read_scene_text(edited(kSoundScene, "explorer: idfm", "explorer: idfm, pace: paper"), "s.yaml");
  EXPECT_EQ(scene.mission.map->pace.tile_s, 3.4);
  EXPECT_EQ(scene.mission.map->pace.tag_s, 4.4);
  const Scene own =
      read_scene_text(edited(kSoundScene, "explorer: idfm", "explorer: idfm, pace: own"), "s.yaml");
  EXPECT_EQ(own.mission.map->pace.tile_s, 0.0);
}

TEST(SceneReader, KeepsSeedsOf64Bits) {
  const Scene scene = read_scene_text(edited(kSoundScene, "seed: 7", "seed: 18446744073709551615"), "s.yaml");
  EXPECT_EQ(scene.seed, 18446744073709551615u);
}

TEST(SceneReader, LaysATileWhereverItsMiddleLiesInTheRoom) {
  // 4 m by 3 m, tiles of 0.5 m from the corner: 8 x 6, under the table too.
  EXPECT_EQ(read_scene_text(kSoundScene, "s.yaml").world.carpet.tiles.size(), 48u);
  // A ninth column's middle would be at 4.25 + 0.24 - 0.5 = 3.99 m.
  const Scene moved =
      read_scene_text(edited(kSoundScene, "tile_m: 0.5", "tile_m: 0.5, origin_m: [0.24, 0]"), "s.yaml");
  EXPECT_EQ(moved.world.carpet.tiles.size(), 48u);
  EXPECT_EQ(moved.world.carpet.tiles.front().first, 0);
  const Scene further =
      read_scene_text(edited(kSoundScene, "tile_m: 0.5", "tile_m: 0.5, origin_m: [0.26, 0]"), "s.yaml");
  EXPECT_EQ(further.world.carpet.tiles.front().first, -1);
  EXPECT_EQ(further.world.carpet.tiles.size(), 48u);
}

TEST(SceneReader, LaysOnlyTheTilesThatTheSceneLists) {
  const Scene scene = read_scene_text(
      edited(kSoundScene, "tile_m: 0.5", "tile_m: 0.5, tiles: [[1, 1], [2, 1], [3, 1]], without: [[2, 1]]"),
      "s.yaml");
  EXPECT_THAT(scene.world.carpet.tiles, ElementsAre(Pair(1, 1), Pair(3, 1)));
}

TEST(SceneReader, LaysNoCarpetWhenToldSo) {
  // Nothing to map yet is a mistake today, since mapping is the only mission.
  EXPECT_THAT(messages(edited(kSoundScene, "carpet: { tile_m: 0.5 }", "carpet: none")),
              testing::HasSubstr("world.carpet: is none"));
}

TEST(SceneReader, CarpetsARoomByDefault) {
  const Scene scene = read_scene_text(edited(kSoundScene, "  carpet: { tile_m: 0.5 }\n", ""), "s.yaml");
  EXPECT_EQ(scene.world.carpet.tile_m, 0.508);
  EXPECT_EQ(scene.world.carpet.tiles.size(), 8u * 6u);
}

TEST(SceneReader, FindsAStartWithRoomForTheRobotWhenTheSceneNamesNone) {
  const Scene scene = read_scene_text(
      edited(kSoundScene, "robot:\n  start: { at_m: [1, 1], heading_deg: 0 }\n", ""), "s.yaml");
  // The group of free tiles spans the room; its middle is (2, 1.5), and the tile nearest to it that is clear
  // of the table (whose lower edge is at 1.75) has its middle at y = 1.25.
  EXPECT_DOUBLE_EQ(scene.robot.X_WR_start.p_m.y(), 1.25);
  EXPECT_NEAR(scene.robot.X_WR_start.p_m.x(), 2.0, 0.2501);
  EXPECT_EQ(scene.robot.X_WR_start.yaw_rad, 0.0);
}

TEST(SceneReader, AcceptsEveryShapeOfFurniture) {
  for (const char* shape : {"radius_m: 0.3", "size_m: [0.4, 0.4]", "points_m: [[0, 0], [0.5, 0], [0, 0.5]]",
                            "legs_m: [[-0.4, 0], [0.4, 0]], leg_radius_m: 0.03"}) {
    EXPECT_EQ(messages(edited(kSoundScene, "size_m: [1, 0.5]", shape)), "no error") << shape;
  }
}

TEST(SceneReader, LetsTheRobotStartUnderATableThatIsHighEnough) {
  const std::string under = edited(kSoundScene, "at_m: [1, 1]", "at_m: [2, 2]");
  EXPECT_EQ(messages(edited(under, "size_m: [1, 0.5]", "size_m: [1, 0.5], clearance_m: 0.3")), "no error");
  EXPECT_NE(messages(edited(under, "size_m: [1, 0.5]", "size_m: [1, 0.5], clearance_m: 0.05")), "no error");
}

TEST(SceneReader, PutsPartitionsAmongTheWalls) {
  const Scene scene = read_scene_text(
      edited(kSoundScene, "[0, 3]] }", "[0, 3]], partitions: [{ points_m: [[3, 0], [3, 1]] }] }"), "s.yaml");
  ASSERT_EQ(scene.world.walls.size(), 2u);
  EXPECT_FALSE(scene.world.walls[1].closed);
}

}  // namespace
}  // namespace sensotwin::twin
