// SPDX-License-Identifier: MIT
#include "twin/run/scene_bound.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "phase_case.hpp"

namespace sensotwin::twin {
namespace {

Scene variant(const std::string& name, const std::string& chosen, std::optional<std::uint64_t> seed = {}) {
  return read_scene(kSource / "scenes" / (name + ".yaml"), {.seed = seed, .variant = chosen});
}

TEST(SceneBound, OfTheLineLiesWhereTheStudyFoundIt) {
  const auto bound = bound_of(variant("line_at_90", "own_slow"));
  ASSERT_TRUE(bound);
  EXPECT_EQ(bound->legs, (std::vector<std::string>{"A", "B"}));
  // Algorithms study, A.6: 0.75 cm with the destination's reads alone, 0.65 to 0.86 with its neighbours'.
  EXPECT_NEAR(bound->bound.rms_m, 0.0072, 0.0012);
}

TEST(SceneBound, IsTheSameForEverySeedAndController) {
  const double own = bound_of(variant("line_at_90", "own_slow", 1))->bound.rms_m;
  EXPECT_EQ(bound_of(variant("line_at_90", "own_slow", 2))->bound.rms_m, own);
  EXPECT_EQ(bound_of(variant("line_at_90", ""))->bound.rms_m, own);
}

TEST(SceneBound, GrowsWithFewerReadsAndWithEchoes) {
  const double at_once = bound_of(variant("line_at_90", "own_slow"))->bound.rms_m;
  EXPECT_GT(bound_of(variant("line_at_90", "own_multiplexed"))->bound.rms_m, 1.2 * at_once);
  EXPECT_GT(bound_of(variant("line_at_90", "own_multipath"))->bound.rms_m, 2.0 * at_once);
}

TEST(SceneBound, FallsFromTheFirstLapToTheSecond) {
  const auto bound = bound_of(published("circle"));
  ASSERT_TRUE(bound);
  EXPECT_LT(bound->bound.second_half_rms_m, 0.5 * bound->bound.first_half_rms_m);
}

TEST(SceneBound, LeavesOutATagThatIsNotThereAndMissesItsReads) {
  Scene scene = variant("hallway", "own_slow");
  scene.world.radio->tags[2].present = false;
  const auto bound = bound_of(scene);
  ASSERT_TRUE(bound);
  EXPECT_EQ(bound->legs, (std::vector<std::string>{"T1", "T2", "T4", "T5", "T6", "T7"}));
}

TEST(SceneBound, IsNoneWithoutAPathAlongCeilingTags) {
  EXPECT_FALSE(bound_of(published("house")));
  EXPECT_FALSE(bound_of(published("line_at_90", {"mission.phase.destinations=[A]"})));
  Scene one = published("line_at_90");
  one.world.radio->tags[1].present = false;
  EXPECT_FALSE(bound_of(one));
  EXPECT_FALSE(bound_of(published("line_at_90", {"mission.phase.controller=own", "mission.phase.path=circle",
                                                 "mission.phase.destinations=[A, B, A]"})));
}

TEST(SceneBound, HoldsForACircleAboutATagAndOneThroughThree) {
  const auto about =
      bound_of(published("circle", {"mission.phase.path=circle_about", "mission.phase.destinations=[C1]"}));
  ASSERT_TRUE(about);
  EXPECT_EQ(about->legs.size(), 2u);
  EXPECT_GT(about->bound.rms_m, 0.001);
  const auto through = bound_of(published("circle", {"mission.phase.path=circle"}));
  ASSERT_TRUE(through);
  // Once all eight tags are known, the circle by them is as well known as the curve through them.
  EXPECT_NEAR(through->bound.second_half_rms_m, bound_of(published("circle"))->bound.second_half_rms_m,
              0.001);
}

TEST(PhaseRun, CarriesTheBoundOfOurOwnControllerAndNoneOfThePapers) {
  const Scene own = variant("line_at_90", "own_slow");
  const PathResult path = path_of(own);
  ASSERT_TRUE(path.bound);
  EXPECT_EQ(path.bound->bound_m, bound_of(own)->bound.rms_m);
  EXPECT_FALSE(path_of(published("line_at_90")).bound);
}

// 1084 reads in one control step: more than the mission once took, and then it heard nothing at all.
TEST(PhaseRun, HearsItsTagsAmongFiveHundred) {
  Scene scene = variant("line_at_90", "own_slow");
  scene.limits.time_limit_s = 90.0;
  for (int i = 0; i < 540; ++i) {
    world::CeilingTag far;
    far.name = "far " + std::to_string(i);
    far.epc.bytes[0] = 0x31;
    far.epc.bytes[10] = static_cast<std::uint8_t>(i >> 8);
    far.epc.bytes[11] = static_cast<std::uint8_t>(i & 0xFF);
    far.at_m = {20.0 + i % 30, 20.0 + i / 30};
    scene.world.radio->tags.push_back(far);
  }
  scene.mission.phase->destinations = {"A", "B"};
  const PathResult path = path_of(scene);
  EXPECT_EQ(path.arrived, 1);
  EXPECT_LT(path.rmse_m, 0.02);
}

TEST(ImageBound, OfAlmostSilentImagesIsTheBoundWithoutEchoes) {
  Scene scene = variant("line_at_90", "own_multipath");
  scene.world.radio->radio.image_amplitude = 1e-4;
  const auto among = image_bound_of(scene, 10);
  ASSERT_TRUE(among);
  EXPECT_NEAR(among->rms_m / bound_of(variant("line_at_90", "own_slow"))->bound.rms_m, 1.0, 0.03);
}

TEST(ImageBound, IsFarAboveTheBoundThatTakesEchoesForAGaussMarkovProcess) {
  const Scene scene = variant("line_at_90", "own_multipath");
  const auto among = image_bound_of(scene, 2000);
  ASSERT_TRUE(among);
  EXPECT_GT(among->rms_m, 1.2 * bound_of(scene)->bound.rms_m);
  // What the goal of 2.5 cm asks of a run, by the best linear estimator. Its median is known to 2 % here.
  EXPECT_NEAR(among->run_median_m, 0.0259, 0.0009);
}

TEST(ImageBound, FallsWithTheDistanceOfTheAntennas) {
  const auto near = image_bound_of(variant("line_at_90", "own_multipath"), 10);
  const auto wide = image_bound_of(variant("line_at_90", "own_multipath_wide"), 10);
  ASSERT_TRUE(near && wide);
  EXPECT_LT(wide->rms_m, 0.7 * near->rms_m);
}

TEST(ImageBound, IsNoneWithoutImagesOrWithAntennasReadInTurnOrOnACurve) {
  EXPECT_FALSE(image_bound_of(variant("line_at_90", "own_slow"), 1));
  EXPECT_FALSE(image_bound_of(variant("line_at_90", "own_multiplexed"), 1));
  EXPECT_FALSE(image_bound_of(published("smooth_curve", {"world.radio.images=3"}), 1));
}

}  // namespace
}  // namespace sensotwin::twin
