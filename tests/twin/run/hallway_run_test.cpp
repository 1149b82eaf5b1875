// SPDX-License-Identifier: MIT
#include "twin/run/hallway_run.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "mapping_case.hpp"
#include "twin/run/hallway_recorder.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

Scene office(const std::string& variant = "", const std::vector<std::string>& set = {},
             std::uint64_t seed = 7) {
  return read_scene(std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes/office.yaml",
                    {.set = set, .seed = seed, .variant = variant});
}

Summary run(const Scene& scene, bool pictures = false) {
  const TemporaryFolder folder;
  RunFolder results(folder / "run", Existing::kRefuse);
  SceneRunOptions options;
  options.scene_as_given = scene.name;
  options.pictures = pictures;
  const Summary summary = run_hallway(scene, results, options);
  EXPECT_EQ(std::filesystem::exists(folder / "run/plan.png"), pictures);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/summary.json"));
  EXPECT_EQ(std::filesystem::exists(folder / "run/hallways.yaml"), scene.mission.hallway->survey);
  return summary;
}

TEST(HallwayRun, GoesTheShortestWayAndTouchesNothing) {
  const Summary summary = run(office(), true);
  const HallwayResult& result = *summary.hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.wall_contacts, 0);
  EXPECT_EQ(result.shortest_m, 33.0);
  EXPECT_LT(result.detour, 1.01);
  EXPECT_LT(result.end_error_m, 0.1);
  EXPECT_EQ(result.tags_missed, 0);
  EXPECT_EQ(verdict_of(summary), "accepted");
}

TEST(HallwayRun, RepeatsItselfToTheLastBitAndDiffersBySeed) {
  const std::string hash = run(office()).state_hash;
  EXPECT_EQ(run(office()).state_hash, hash);
  EXPECT_NE(run(office("", {}, 8)).state_hash, hash);
}

TEST(HallwayRun, KnowsJunctionsByItsSonarsWhereTagsAreNotRead) {
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const HallwayResult result =
        *run(office("tags_missed", {"robot.floor_reader.missed_share=0.3"}, seed)).hallway;
    EXPECT_EQ(result.arrived, 1) << seed;
    EXPECT_EQ(result.wall_contacts, 0) << seed;
    missed += result.tags_missed;
  }
  EXPECT_GT(missed, 2);
}

TEST(HallwayRun, GivesUpAHallwayThatBoxesClose) {
  const HallwayResult result = *run(office("blocked")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.blocked, 1);
  EXPECT_EQ(result.wall_contacts, 0);
}

TEST(HallwayRun, GoesRoundABox) {
  const HallwayResult result = *run(office("box")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.went_round, 1);
  EXPECT_EQ(result.wall_contacts, 0);
}

TEST(HallwayRun, FindsOutWhereItIsByTheFirstTag) {
  const HallwayResult result = *run(office("", {"mission.hallway={ to: c3 }"})).hallway;
  EXPECT_EQ(result.arrived, 1);
}

TEST(HallwayRun, SurveysTheWholeOfficeFromOneTagAndTheCompass) {
  const HallwayResult result = *run(office("survey")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.places, 12);
  EXPECT_EQ(result.map_differences, 0);
}

TEST(HallwayRun, WithoutACompassStandsStillAndSaysSo) {
  const HallwayResult result = *run(office("", {"robot.compass.rate_hz=0.1", "time_limit_s=5"})).hallway;
  EXPECT_EQ(result.arrived, 0);
  EXPECT_LT(result.length_m, 0.01);
}

TEST(HallwayDifferences, AreCountedSideBySide) {
  const robot::HallwayMap drawn = office().hallways.map;
  EXPECT_EQ(differences(drawn, drawn), 0);
  std::vector<robot::HallwayNode> nodes = drawn.nodes();
  nodes[0].side(robot::CompassPoint::kEast).length_m = 9.0;
  EXPECT_EQ(differences(drawn, robot::HallwayMap::from_nodes(nodes)), 1);
  nodes = drawn.nodes();
  nodes[0].side(robot::CompassPoint::kEast).tags.clear();
  EXPECT_EQ(differences(drawn, robot::HallwayMap::from_nodes(nodes)), 1);
}

}  // namespace
}  // namespace sensotwin::twin
