// SPDX-License-Identifier: MIT
// Missions along ceiling tags, end to end as `twin run` does them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "phase_case.hpp"
#include "twin/run/ideal_path.hpp"
#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {
namespace {

TEST(IdealPath, ScoresEachLegAgainstItsOwnLineAndNotTheWayToTheFirstTag) {
  const IdealPath path(published("line_at_90"));
  EXPECT_EQ(path.legs(), 2u);
  EXPECT_FALSE(path.error_m(0, {-2.0, -2.0}));
  EXPECT_FALSE(path.error_m(2, {0.0, 5.0}));
  // From (0, 0) to (0, 5): left of travel is -x.
  EXPECT_NEAR(*path.error_m(1, {-0.1, 2.0}), 0.1, 1e-12);
  EXPECT_NEAR(*path.error_m(1, {0.3, 7.0}), -0.3, 1e-12);
  EXPECT_NEAR(path.distance_m({0.0, 7.0}), 2.0, 1e-12);
}

TEST(IdealPath, OfACircleByEightTagsIsASmoothCurveThroughThem) {
  const IdealPath path(published("circle"));
  EXPECT_EQ(path.legs(), 17u);
  EXPECT_NEAR(path.distance_m({0.0, 2.0}), 0.0, 1e-6);
  // A Catmull-Rom curve through eight points keeps within 0.85 % of the circle (algorithms study, A.5).
  EXPECT_LT(path.distance_m(2.0 * Vec2{std::cos(0.4), std::sin(0.4)}), 0.02);
}

TEST(PhaseRun, OfThePapersLineArrivesByFloorTagsAndLeavesAllItsFiles) {
  const TemporaryFolder folder;
  const Summary summary = phase_run(folder / "run", published("line_at_90"), true);
  ASSERT_TRUE(summary.path);
  EXPECT_EQ(summary.path->arrived, 1);
  EXPECT_EQ(summary.path->tags_reached, 2);
  // 7.07 m at 0.2 m/s, and a second for turning.
  EXPECT_GT(summary.path->time_to_first_s, 35.0);
  const auto files = files_in(folder / "run");
  for (const char* name : {"trace.csv", "events.jsonl", "summary.json", "reads.csv", "path.png", "plan.png",
                           "error.png", "noise.png", "controller.png", "oblique.png"}) {
    EXPECT_EQ(files.count(name), 1u) << name;
  }
  // Two antennas, one tag each twenty times a second and more tags in sight.
  const std::string& reads = files.at("reads.csv");
  EXPECT_GT(std::count(reads.begin(), reads.end(), '\n'), 40 * summary.sim_s);
}

TEST(PhaseRun, GivesTheSameBytesAgain) {
  const TemporaryFolder folder;
  const Scene scene = published("line_at_0", {}, 3);
  (void)phase_run(folder / "a", scene);
  (void)phase_run(folder / "b", scene);
  auto a = files_in(folder / "a");
  auto b = files_in(folder / "b");
  EXPECT_EQ(a, b);
}

TEST(PhaseRun, OfThePaperKeepsItsFiguresOnAFewSeeds) {
  for (const char* name : {"line_at_90", "line_at_0", "complex_path", "hallway"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const PathResult path = path_of(published(name, {}, seed));
      EXPECT_EQ(path.arrived, 1) << name << " seed " << seed;
      EXPECT_LT(path.rmse_m, 0.6) << name << " seed " << seed;
      EXPECT_EQ(path.wall_contacts, 0) << name << " seed " << seed;
    }
  }
}

TEST(PhaseRun, StartsAtAPlaceOfItsSeedWhereTheSceneAsksForOne) {
  const std::vector<std::string> within{"world.room.walls_m=[[-12,-12],[12,-12],[12,12],[-12,12]]",
                                        "robot.start={at_m: [1, 0], heading_deg: 0, within_m: 8}"};
  double farthest_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Scene scene = published("line_at_90", within, seed);
    const Vec2 start_m = placed(scene).robot.X_WR_start.p_m;
    EXPECT_EQ(start_m, placed(scene).robot.X_WR_start.p_m);
    EXPECT_NE(start_m, placed(published("line_at_90", within, seed + 1)).robot.X_WR_start.p_m);
    farthest_m = std::max(farthest_m, (start_m - Vec2{1.0, 0.0}).norm());
  }
  EXPECT_LE(farthest_m, 8.0);
  // All of 200 within 7.8 m of a disc of 8 m: (7.8 / 8)^400, 4 in 100 000.
  EXPECT_GT(farthest_m, 7.8);
  EXPECT_EQ(placed(published("line_at_90")).robot.X_WR_start.p_m, Vec2(-5.0, -5.0));
}

TEST(PhaseRun, FindsTheTagFromAnywhere) {
  const std::vector<std::string> within{"world.room.walls_m=[[-12,-12],[12,-12],[12,12],[-12,12]]",
                                        "robot.start={at_m: [0, 0], heading_deg: 0, within_m: 8}",
                                        "mission.phase.destinations=[A]"};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(path_of(published("line_at_90", within, seed)).arrived, 1) << seed;
  }
}

// Read one after the other and combined as if at once, the antennas' difference looks like a tag to the side:
// the robot circles the first tag for ever (algorithms study, A.3). Read 1-2-1 and interpolated, it arrives.
TEST(PhaseRun, FailsWithAntennasNaivelyMultiplexedAndIsRestoredByInterpolation) {
  const std::vector<std::string> multiplexed{"world.radio.simultaneous=false",
                                             "world.radio.slots_s=[0.05, 0.05]", "time_limit_s=300"};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    auto naive = multiplexed;
    naive.push_back("mission.phase.pairing=latest");
    EXPECT_EQ(path_of(published("line_at_90", naive, seed)).arrived, 0) << seed;
    auto restored = multiplexed;
    restored.push_back("mission.phase.pairing=interpolated");
    EXPECT_EQ(path_of(published("line_at_90", restored, seed)).arrived, 1) << seed;
  }
}

TEST(PhaseRun, ByOurOwnControllerKeepsWithinCentimetresOfCurvesAndCorners) {
  const std::vector<std::string> own{"mission.phase.controller=own", "mission.phase.corners=slow"};
  EXPECT_LT(path_of(published("hallway", own)).rmse_m, 0.05);
  EXPECT_LT(path_of(published("circle")).rmse_m, 0.03);
  EXPECT_LT(path_of(published("smooth_curve")).rmse_m, 0.03);
}

TEST(PhaseRun, WithTheMeasuredReaderHopsOverThatRunsOwnTable) {
  const Scene scene = published("hallway", {"world.radio.profile=impinj_r420"});
  const world::RadioWorld first = radio_of(scene, robot::RandomStream(1));
  const world::RadioWorld second = radio_of(scene, robot::RandomStream(2));
  EXPECT_EQ(first.radio.channels_hz.size(), 50u);
  EXPECT_EQ(first.radio.slots_s.size(), 2u);
  EXPECT_NE(first.radio.channels_hz, second.radio.channels_hz);
}

}  // namespace
}  // namespace sensotwin::twin
