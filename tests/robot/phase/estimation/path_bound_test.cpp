// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/path_bound.hpp"

#include <gtest/gtest.h>

#include "robot/phase/estimation/path_shape.hpp"
#include "tests/robot/phase/estimation/mission_runs.hpp"

namespace sensotwin::robot::testing {
namespace {

double bound_cm(const PhaseExperiment& experiment, double noise_factor, int ahead, int behind) {
  KinematicRadio radio;
  radio.noise_rad_per_m *= noise_factor;
  CeilingMissionConfig config = mission_for(experiment, radio, true);
  config.tags_ahead = ahead;
  config.tags_behind = behind;
  return 100.0 * posterior_bound(bound_for(experiment, config, radio)).rms_m;
}

TEST(PathBound, LiesWhereTheStudyFoundItWithTheDestinationAlone) {
  // Algorithms study, A.6: line 0.75, star 0.82, hallway 0.95 cm with the destination's reads alone. There
  // floor tags fixed the place at every tag; here the last tag's reads (behind = 0 keeps none older) do.
  EXPECT_NEAR(bound_cm(line_at_90(), 1.0, 0, 0), 0.75, 0.15);
  EXPECT_NEAR(bound_cm(star(), 1.0, 0, 0), 0.82, 0.25);
  EXPECT_NEAR(bound_cm(hallway(), 1.0, 0, 0), 0.95, 0.25);
}

TEST(PathBound, FallsWhenMoreTagsAreUsed) {
  EXPECT_LT(bound_cm(star(), 1.0, 2, 2), bound_cm(star(), 1.0, 0, 0));
}

TEST(PathBound, NeedsReads) {
  CeilingMissionConfig config = mission_for(line_at_90(), {}, true);
  PathBoundTask task = bound_for(line_at_90(), config, {});
  const double heard = posterior_bound(task).rms_m;
  task.hear = [](const BoundMotion&) { return std::span<const BoundRead>{}; };
  EXPECT_GT(posterior_bound(task).rms_m, 100.0 * heard);
}

TEST(PathShape, TellsTheErrorBesideALineByTheRobotAndBothItsTags) {
  const PathShape line({}, {{0.0, 0.0}, {4.0, 0.0}}, {0, 1}, {0.0, 0.0});
  const PathShape::Beside beside = line.beside(1, {1.0, 0.1});
  EXPECT_NEAR(beside.by_robot.y(), 1.0, 1e-6);
  ASSERT_EQ(beside.by_places.size(), 2u);
  EXPECT_NEAR(beside.by_places[0].by_place.y(), -0.75, 1e-6);
  EXPECT_NEAR(beside.by_places[1].by_place.y(), -0.25, 1e-6);
}

TEST(PathShape, OfASmoothCurveMovesWithItsTags) {
  const PathShape curve({.path = TagPathKind::kSmooth}, {{0, 0}, {2, 1}, {4, 0}, {6, -1}}, {0, 1, 2, 3},
                        {0.0, 0.0});
  Vec2 all{0.0, 0.0};
  const Vec2 middle = curve.points_m(2)[49];
  const PathShape::Beside beside = curve.beside(2, middle);
  for (const PathShape::Pull& pull : beside.by_places) {
    all += pull.by_place;
  }
  EXPECT_EQ(beside.by_places.size(), 4u);
  // Robot and tags moved together: the error stays.
  EXPECT_LT((all + beside.by_robot).norm(), 1e-4);
  EXPECT_NEAR(beside.by_robot.norm(), 1.0, 1e-3);
}

TEST(PathShape, OfACircleAboutATagIsGoneRoundAsOftenAsAsked) {
  const PathShape circle({.path = TagPathKind::kCircleAbout, .circle_radius_m = 2.0, .circle_laps = 1.5},
                         {{0.0, 0.0}}, {0}, {3.0, 0.0});
  EXPECT_LT((circle.points_m(0).back() - Vec2(2.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((circle.points_m(1).back() - Vec2(-2.0, 0.0)).norm(), 1e-9);
  EXPECT_NEAR(circle.beside(1, {2.0, 0.0}).by_robot.x(), -1.0, 1e-6);
}

TEST(PathBound, GrowsWithTheNoise) {
  const double once = bound_cm(line_at_90(), 1.0, 1, 1);
  const double twice = bound_cm(line_at_90(), 2.0, 1, 1);
  EXPECT_GT(twice, 1.3 * once);
  EXPECT_LT(twice, 2.0 * once);
}

}  // namespace
}  // namespace sensotwin::robot::testing
