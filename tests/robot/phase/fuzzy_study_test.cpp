// SPDX-License-Identifier: MIT
// The paper's experiments in quick: a few seeds, wide bands. The figures proper: fuzzy_long_study_test.cpp.
#include "tests/robot/phase/fuzzy_study.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot::testing {
namespace {

constexpr std::uint64_t kFirstSeed = 5000;  // as the algorithms study
constexpr int kSeeds = 20;

double median_cm(const std::vector<FuzzyRun>& runs) {
  return 100.0 * quantile(runs, &FuzzyRun::rmse_m, 0.5);
}

TEST(FuzzyStudy, EveryExperimentOfThePaperArrives) {
  for (const PhaseExperiment& experiment :
       {line_at_90(), line_at_0(), star(), triangle(), zigzag(), hallway()}) {
    EXPECT_EQ(share_arrived(run_fuzzy(experiment, reproduction(), kFirstSeed, kSeeds)), 1.0)
        << experiment.name;
  }
}

// Of a distribution with its quartiles at 16.9 and 25 cm a median of twenty varies by about a fifth; the tail
// on the lower side is short.
TEST(FuzzyStudy, TheStarIsAsFarOffAsThePaperSays) {
  const double rmse_cm = median_cm(run_fuzzy(star(), reproduction(), kFirstSeed, kSeeds));
  EXPECT_GT(rmse_cm, 0.8 * 17.5);
  EXPECT_LT(rmse_cm, 1.4 * 17.5);
}

TEST(FuzzyStudy, TheFullTurnRateOfTheRoombaBeatsThePaper) {
  EXPECT_LT(median_cm(run_fuzzy(line_at_90(), tuned(), kFirstSeed, kSeeds)), 1.2);  // algorithms study, E: G3
  EXPECT_LT(median_cm(run_fuzzy(star(), tuned(), kFirstSeed, kSeeds)), 7.0);
  EXPECT_LT(median_cm(run_fuzzy(hallway(), tuned(), kFirstSeed, kSeeds)), 3.5);
}

// A.0: "flipping the sign converges in 0 of 120 runs".
TEST(FuzzyStudy, TheOtherSignNeverArrives) {
  FuzzySetup setup = reproduction();
  setup.pairing.phase_sign = -1.0;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kSeeds)), 0.0);
}

TEST(FuzzyStudy, SwappedAntennaCablesNeverArriveEither) {
  FuzzySetup setup = reproduction();
  setup.radio.cables_swapped = true;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kSeeds)), 0.0);
}

TEST(FuzzyStudy, AReaderWhosePhaseFallsArrivesWhenToldSo) {
  FuzzySetup setup = tuned();
  setup.radio.phase_sign = -1.0;
  setup.pairing.phase_sign = -1.0;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kSeeds)), 1.0);
}

// A.3: mono with b = 0.08 m is bistatic with 0.16 m, and with 0.16 m it is aliased.
TEST(FuzzyStudy, AMonostaticReaderWantsItsAntennasHalfAsFarApart) {
  FuzzySetup setup = reproduction();
  setup.radio.monostatic = true;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kSeeds)), 0.0);
  setup.radio.spacing_m = 0.08;
  EXPECT_EQ(share_arrived(run_fuzzy(line_at_90(), setup, kFirstSeed, kSeeds)), 1.0);
}

TEST(FuzzyStudy, TheSameSeedDrivesTheSameWay) {
  const FuzzyRun once = run_fuzzy(star(), reproduction(), kFirstSeed);
  const FuzzyRun again = run_fuzzy(star(), reproduction(), kFirstSeed);
  EXPECT_EQ(once.rmse_m, again.rmse_m);
  EXPECT_EQ(once.seconds, again.seconds);
}

}  // namespace
}  // namespace sensotwin::robot::testing
