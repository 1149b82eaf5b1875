// SPDX-License-Identifier: MIT
// The figures of the paper, by its controller, on hundreds of seeds.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "tests/robot/phase/fuzzy_study.hpp"

namespace sensotwin::robot::testing {
namespace {

constexpr std::uint64_t kFirstSeed = 5000;  // as the algorithms study
constexpr int kSeeds = 500;

double median_cm(const std::vector<FuzzyRun>& runs) {
  return 100.0 * quantile(runs, &FuzzyRun::rmse_m, 0.5);
}

/// The paper's RMSE, and ours within a fifth of it; every run arrives.
void expect_reproduced(const PhaseExperiment& experiment, double paper_cm) {
  const std::vector<FuzzyRun> runs = run_fuzzy(experiment, reproduction(), kFirstSeed, kSeeds);
  EXPECT_EQ(share_arrived(runs), 1.0);
  EXPECT_NEAR(median_cm(runs), paper_cm, 0.2 * paper_cm);
}

TEST(FuzzyFigures, LineAt90IsWithinAFifthOfThePaper) {
  expect_reproduced(line_at_90(), 3.4);
}
TEST(FuzzyFigures, StarIsWithinAFifthOfThePaper) {
  expect_reproduced(star(), 17.5);
}
TEST(FuzzyFigures, HallwayIsWithinAFifthOfThePaper) {
  expect_reproduced(hallway(), 13.0);
}

// Each figure of the paper is one draw; lines at 90 and 0 degrees are mirror images of each other (A.2).
TEST(FuzzyFigures, LineAt0OfThePaperIsOneOfOurs) {
  const std::vector<FuzzyRun> runs = run_fuzzy(line_at_0(), reproduction(), kFirstSeed, kSeeds);
  EXPECT_LT(quantile(runs, &FuzzyRun::rmse_m, 0.025), 0.093);
  EXPECT_GT(quantile(runs, &FuzzyRun::rmse_m, 0.975), 0.093);
}

TEST(FuzzyFigures, The110SecondsToTheFirstTagAreOneOfOurs) {
  const std::vector<FuzzyRun> runs = run_fuzzy(line_at_90(), reproduction(), kFirstSeed, kSeeds);
  EXPECT_LT(quantile(runs, &FuzzyRun::first_tag_s, 0.025), 110.0);
  EXPECT_GT(quantile(runs, &FuzzyRun::first_tag_s, 0.975), 110.0);
}

TEST(FuzzyFigures, AThousandOfAThousandPosesWithinEightMetresConverge) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    EXPECT_TRUE(run_fuzzy(homing(8.0, seed), reproduction(), seed).arrived) << "seed " << seed;
  }
}

// A.3, "tuned FLC": 0.9, 6.3, 2.7 cm; bounds of E, G3.
TEST(FuzzyFigures, TheTunedPresetBeatsThePaperByFar) {
  EXPECT_LT(median_cm(run_fuzzy(line_at_90(), tuned(), kFirstSeed, kSeeds)), 1.2);
  EXPECT_LT(median_cm(run_fuzzy(star(), tuned(), kFirstSeed, kSeeds)), 7.0);
  EXPECT_LT(median_cm(run_fuzzy(hallway(), tuned(), kFirstSeed, kSeeds)), 3.5);
}

// A.3's read patterns: floor tags within 3 cm, w = 0.85 rad/s, antennas 50 ms apart.
TEST(FuzzyFigures, NaivelyMultiplexedAntennasFailAndReading121Restores) {
  constexpr int kFewer = 200;
  FuzzySetup setup;
  setup.sets = fuzzy_sets(1.0, 0.85);
  setup.radio.floor_radius_m = 0.03;
  const double simultaneous_cm = median_cm(run_fuzzy(hallway(), setup, kFirstSeed, kFewer));
  setup.radio.simultaneous = false;
  setup.radio.slot_s = 0.05;
  setup.pairing.pairing = Pairing::kLatest;
  EXPECT_LT(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kFewer)), 0.05);
  EXPECT_LT(share_arrived(run_fuzzy(hallway(), setup, kFirstSeed, kFewer)), 0.05);
  setup.pairing.pairing = Pairing::kInterpolated;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kFewer)), 1.0);
  const std::vector<FuzzyRun> restored = run_fuzzy(hallway(), setup, kFirstSeed, kFewer);
  EXPECT_EQ(share_arrived(restored), 1.0);
  EXPECT_NEAR(median_cm(restored), simultaneous_cm, 0.1 * simultaneous_cm);  // E, G6
}

TEST(FuzzyCost, OneStepTakesLessThanTwoMicroseconds) {
  const FuzzyController controller{kReproductionSets};
  constexpr int kSteps = 1000;
  double best_us = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  // Other programs may hold the processor: the best of many short batches is the cost of the step itself.
  for (int batch = 0; batch < 100; ++batch) {
    const auto begun = std::chrono::steady_clock::now();
    for (int i = 0; i < kSteps; ++i) {
      sum += controller.turn_rate_radps(-1.5 + 0.003 * i);
    }
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begun;
    best_us = std::min(best_us, took.count() / kSteps);
  }
  RecordProperty("step_us", std::to_string(best_us));
  EXPECT_NE(sum, 1.0);
  EXPECT_LT(best_us, 2.0);
}

}  // namespace
}  // namespace sensotwin::robot::testing
