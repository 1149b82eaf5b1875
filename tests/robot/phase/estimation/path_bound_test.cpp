// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/path_bound.hpp"

#include <gtest/gtest.h>

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

TEST(PathBound, GrowsWithTheNoise) {
  const double once = bound_cm(line_at_90(), 1.0, 1, 1);
  const double twice = bound_cm(line_at_90(), 2.0, 1, 1);
  EXPECT_GT(twice, 1.3 * once);
  EXPECT_LT(twice, 2.0 * once);
}

}  // namespace
}  // namespace sensotwin::robot::testing
