// SPDX-License-Identifier: MIT
#include "twin/run/hallway_run.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "hallway_case.hpp"
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
  robot::RunFolder results(folder / "run", robot::Existing::kRefuse);
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

TEST(HallwayRun, WaitsForPeopleAndGoesRoundThem) {
  const HallwayResult result = *run(office("people")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.wall_contacts, 0);
}

TEST(HallwayRun, GoesAnotherWayRoundACrowd) {
  const HallwayResult result = *run(office("crowd")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.wall_contacts, 0);
  EXPECT_EQ(result.blocked, 1);
}

TEST(HallwayRun, FindsItsWayAgainWhenSomebodyTurnsIt) {
  int shoved = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const HallwayResult result = *run(office("wrong_exits", {"world.shoves.share=0.2"}, seed)).hallway;
    EXPECT_EQ(result.arrived, 1) << seed;
    shoved += result.shoved;
  }
  EXPECT_GT(shoved, 2);
}

TEST(HallwayRun, KeepsToAWallWhenAsked) {
  for (const char* side : {"left", "right"}) {
    const HallwayResult result =
        *run(office("left_wall", {std::string("mission.hallway.follow=") + side})).hallway;
    EXPECT_EQ(result.arrived, 1) << side;
    EXPECT_EQ(result.wall_contacts, 0) << side;
  }
}

TEST(HallwayRun, TriesHallwaysWhoseEndsItsMapDoesNotKnow) {
  const HallwayResult result = *run(office("partial")).hallway;
  EXPECT_EQ(result.arrived, 1);
  EXPECT_EQ(result.explored, 1);
}

TEST(HallwayRun, NeedsNoWidthToldRight) {
  for (const double width_m : {1.2, 3.0}) {
    Scene scene = office("tags_missed", {"robot.floor_reader.missed_share=0.3"}, 3);
    scene.known = scene.hallways;
    scene.known->width_m = width_m;
    const HallwayResult result = *run(scene).hallway;
    EXPECT_EQ(result.arrived, 1) << width_m;
    EXPECT_EQ(result.wall_contacts, 0) << width_m;
    EXPECT_GT(result.tags_missed, 0) << width_m;
  }
}

// From every place to every other, 20 seeds each: hallway_long_test.cpp.
TEST(BuildingThatNobodyHereDrew, IsGoneThroughByPlacesAndTags) {
  if (!std::filesystem::exists(kMaps)) {
    GTEST_SKIP() << "the maps of ../shared/data/maps are not here";
  }
  for (const auto& [file, from, to] :
       {std::array{"buildings/hospital", "ward", "east"}, std::array{"buildings/hospital", "lobby", "sw"},
        std::array{"buildings/stata", "e", "g"}}) {
    const HallwayResult result = hallway_run(hallway_scene(file, "", from_to({}, from, to), 1)).result;
    EXPECT_EQ(result.arrived, 1) << file << " " << from << " " << to;
    EXPECT_EQ(result.wall_contacts, 0) << file << " " << from << " " << to;
    EXPECT_LT(result.detour, 1.05) << file << " " << from << " " << to;
  }
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
