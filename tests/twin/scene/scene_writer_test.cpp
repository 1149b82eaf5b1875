// SPDX-License-Identifier: MIT
#include "twin/scene/scene_writer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "robot/config/number_text.hpp"
#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

const std::string kRichScene = R"(version: 1
seed: 12345678901234567890
title: "Everything \"at once\": \\ and more"
world:
  room:
    walls_m: [[0, 0], [6.1, 0], [6.1, 5.3], [0, 5.3]]
    partitions: [{ points_m: [[3, 0], [3, 1]], closed: false }]
  carpet: { origin_m: [0.1, 0.2], region_m: [[0, 0], [5, 5]], without: [[1, 1]], unreadable: [[2, 2]] }
  furniture:
    - { name: table, at_m: [2, 2], heading_deg: 33.3, legs_m: [[-0.4, 0], [0.4, 0]], leg_radius_m: 0.03,
        tag: { category: 3, length: 12, width: 8, color: 255 } }
    - { name: chair, at_m: [4, 2], radius_m: 0.2, pushable: true, mass_kg: 4.5, friction: 0.35 }
    - { name: corner, at_m: [5, 4], points_m: [[0, 0], [0.7, 0], [0, 0.7]] }
    - { name: shelf, at_m: [1, 5], size_m: [1, 0.3], clearance_m: 0.15 }
  landmarks: [{ kind: closet_right, at_m: [0, 2] }]
  floor: { friction: 0.55, nap_yaw_deg: 12.3 }
  cliffs: [{ corners_m: [[4.5, 0], [5.5, 0], [5, 0.5]] }]
  virtual_walls: [{ at_m: [3, 4], heading_deg: 180, half_angle_deg: 7 }]
  home_base: { at_m: [0.05, 0.5], heading_deg: 0 }
  compass_distortions: [{ at_m: [3, 3], peak_deg: -17 }]
  north_deg: 77.7
robot:
  start: { at_m: [1, 1], heading_deg: -123.4 }
  base: { kind: roomba400, firmware: before_3.3.0 }
mission: { map: { explorer: bfm_out_and_back, pace: paper } }
expect: { tiles_mapped: { min: 1 }, "phase.rmse_m": { min: 0.001, max: 0.1, rate: { min: 0.95 },
          median: { max: 0.05 }, quantile_2_5: { min: 0.002, max: 0.01 } } }
time_limit_s: 77.5
)";

TEST(ShownScene, ReadsBackAsTheSameText) {
  for (const std::string& text : {kSoundScene, kRichScene}) {
    const std::string shown = scene_yaml(read_scene_text(text, "s.yaml"));
    EXPECT_EQ(scene_yaml(read_scene_text(shown, "t.yaml")), shown);
  }
}

TEST(ShownScene, ReadsBackAsTheSameWorld) {
  const Scene before = read_scene_text(kRichScene, "s.yaml");
  const Scene after = read_scene_text(scene_yaml(before), "t.yaml");
  EXPECT_EQ(after.seed, before.seed);
  EXPECT_EQ(after.title, before.title);
  EXPECT_EQ(after.world.carpet.tiles, before.world.carpet.tiles);
  EXPECT_EQ(after.world.carpet.unreadable, before.world.carpet.unreadable);
  ASSERT_EQ(after.world.walls.size(), before.world.walls.size());
  EXPECT_EQ(after.world.walls[1].points_m, before.world.walls[1].points_m);
  ASSERT_EQ(after.world.furniture.size(), 4u);
  EXPECT_EQ(after.world.furniture[0].X_WF.yaw_rad, before.world.furniture[0].X_WF.yaw_rad);
  EXPECT_EQ(after.world.furniture[2].points_m, before.world.furniture[2].points_m);
  EXPECT_EQ(after.robot.X_WR_start.yaw_rad, before.robot.X_WR_start.yaw_rad);
  EXPECT_EQ(after.robot.compass.noise_sigma_rad, before.robot.compass.noise_sigma_rad);
  EXPECT_EQ(after.mission.map->pace.tag_s, 4.4);
  EXPECT_EQ(after.expect[1].max, 0.1);
  EXPECT_EQ(after.expect[1].rate_min, 0.95);
  EXPECT_FALSE(after.expect[1].statistics[0]);
  EXPECT_EQ(after.expect[1].statistics[1]->max, 0.05);
  EXPECT_EQ(after.expect[1].statistics[1]->min, std::nullopt);
  EXPECT_EQ(after.expect[1].statistics[2]->min, 0.002);
  EXPECT_FALSE(after.expect[0].rate_min);
  EXPECT_EQ(after.limits.time_limit_s, 77.5);
}

TEST(ShownScene, HoldsEveryDefault) {
  const std::string shown = scene_yaml(read_scene_text(kSoundScene, "s.yaml"));
  for (const char* line :
       {"\n  carpet:\n    tile_m: 0.5\n    origin_m: [0, 0]\n", "\n    rolling_resistance: 0.04\n",
        "\n  north_deg: 90\n", "\n    kind: create2\n    firmware: current\n",
        "\n      speed_mps: 0.3\n      turn_degps: 90\n", "\n  steps_per_tick: 3\n",
        "\n    - name: \"table\"\n      at_m: [2, 2]\n", "\ntime_limit_s: 20700\n"}) {
    EXPECT_NE(shown.find(line), std::string::npos) << line << "is not in\n" << shown;
  }
}

TEST(ShownScene, ShowsTheStartThatTheTwinFound) {
  const Scene scene =
      read_scene_text(edited(kSoundScene, "{ at_m: [1, 1], heading_deg: 0 }", "auto"), "s.yaml");
  const Scene after = read_scene_text(scene_yaml(scene), "t.yaml");
  EXPECT_EQ(after.robot.X_WR_start.p_m, scene.robot.X_WR_start.p_m);
}

TEST(ShownScene, SpellsItsMapFromTheFolderItIsSavedIn) {
  Scene scene = read_scene_text(kSoundScene, "a/scenes/s.yaml");
  scene.layout.room.reset();
  scene.layout.map = MapPlan{"../maps/m.yaml"};
  EXPECT_NE(scene_yaml(scene).find("file: \"../maps/m.yaml\""), std::string::npos);
  EXPECT_NE(scene_yaml(scene, "a/runs/1").find("file: \"../../maps/m.yaml\""), std::string::npos);
}

TEST(Degrees, ReadBackAsTheSameRadiansForAThousandAngles) {
  for (int i = 0; i < 1000; ++i) {
    const double rad = robot::rad_from_deg(-360.0 + 0.7213 * i);
    EXPECT_EQ(robot::rad_from_deg(robot::degrees_for(rad)), rad);
  }
  EXPECT_EQ(robot::number_text(robot::degrees_for(robot::rad_from_deg(33.3))), "33.3");
}

}  // namespace
}  // namespace sensotwin::twin
