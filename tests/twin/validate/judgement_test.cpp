// SPDX-License-Identifier: MIT
#include "twin/validate/judgement.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "seeds_of_figures.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::ElementsAre;

constexpr std::size_t kMean = 0;
constexpr std::size_t kMedian = 1;
constexpr std::size_t kQuantile95 = 4;

JudgedThreshold only(const Expectation& expectation, const std::vector<RunOutcome>& runs,
                     const JudgementOptions& options = {}) {
  const auto judged = judge_seeds(expecting(expectation), runs, options);
  EXPECT_EQ(judged.size(), 1u);
  return judged.front();
}

TEST(Thresholds, AreEachBoundOfTheSceneInItsOrder) {
  Expectation expectation{.name = "minutes", .min = 1.0, .max = 5.0};
  expectation.statistics[kMedian] = Bounds{std::nullopt, 3.0};
  std::vector<std::string> sentences;
  for (const Threshold& threshold : thresholds_of(expecting(expectation), 1.0)) {
    sentences.push_back(sentence_of(threshold));
  }
  EXPECT_THAT(sentences, ElementsAre("minutes at least 1 in every seed", "minutes at most 5 in every seed",
                                     "median of minutes at most 3"));
}

TEST(Judgement, AsksEverySeedByDefault) {
  const Expectation expectation{.name = "minutes", .min = std::nullopt, .max = 199.0};
  const JudgedThreshold judged = only(expectation, runs_with(up_to(200)));
  EXPECT_EQ(judged.outcome, Outcome::kMissed);
  ASSERT_EQ(judged.failing.size(), 1u);
  EXPECT_EQ(judged.failing[0].seed, 200u);
  EXPECT_EQ(judged.worst->seed, 200u);
  EXPECT_EQ(only({.name = "minutes", .min = 1.0, .max = std::nullopt}, runs_with(up_to(200))).outcome,
            Outcome::kKept);
}

TEST(Judgement, OfARateDemandsThatTheLowerEndReachesIt) {
  // Clopper and Pearson at 95 %: the rate is above 0.95 when P(k or more of 200 | 0.95) <= 2.5 %, which is
  // 0.9 % for 197 and 2.6 % for 196; below when P(k or fewer) <= 2.5 %: 2.4 % for 183, 4.4 % for 184.
  const auto with_max = [](double max) {
    return only({.name = "minutes", .min = std::nullopt, .max = max, .rate_min = 0.95},
                runs_with(up_to(200)));
  };
  EXPECT_EQ(with_max(197.0).outcome, Outcome::kKept);
  EXPECT_EQ(with_max(196.0).outcome, Outcome::kOpen);
  EXPECT_EQ(with_max(184.0).outcome, Outcome::kOpen);
  EXPECT_EQ(with_max(183.0).outcome, Outcome::kMissed);
}

TEST(Judgement, TakesTheCommandLinesRateWhereTheSceneStatesNone) {
  const Expectation plain{.name = "minutes", .min = std::nullopt, .max = 199.0};
  EXPECT_EQ(only(plain, runs_with(up_to(200)), {.rate = 0.95}).outcome, Outcome::kKept);
  Expectation strict = plain;
  strict.rate_min = 1.0;
  EXPECT_EQ(only(strict, runs_with(up_to(200)), {.rate = 0.95}).outcome, Outcome::kMissed);
}

TEST(Judgement, OfAMedianIsOpenWhileItsIntervalHoldsTheLimit) {
  // 100 values 1 .. 100: the median's interval is 40 .. 61 (Conover).
  const auto with_max = [](double max) {
    Expectation expectation{.name = "minutes", .min = std::nullopt, .max = std::nullopt};
    expectation.statistics[kMedian] = Bounds{std::nullopt, max};
    return only(expectation, runs_with(up_to(100))).outcome;
  };
  EXPECT_EQ(with_max(61.0), Outcome::kKept);
  EXPECT_EQ(with_max(60.0), Outcome::kOpen);
  EXPECT_EQ(with_max(40.0), Outcome::kOpen);
  EXPECT_EQ(with_max(39.0), Outcome::kMissed);
}

TEST(Judgement, OfAnOuterQuantileFromFewSeedsIsOpen) {
  Expectation expectation{.name = "minutes", .min = std::nullopt, .max = std::nullopt};
  expectation.statistics[kQuantile95] = Bounds{std::nullopt, 1000.0};
  EXPECT_EQ(only(expectation, runs_with(up_to(71))).outcome, Outcome::kOpen);
  EXPECT_EQ(only(expectation, runs_with(up_to(72))).outcome, Outcome::kKept);
}

TEST(Judgement, OfAMeanUsesBothBounds) {
  Expectation expectation{.name = "minutes", .min = std::nullopt, .max = std::nullopt};
  expectation.statistics[kMean] = Bounds{3.0, 8.0};
  const auto judged = judge_seeds(expecting(expectation), runs_with(up_to(10)), {});
  ASSERT_EQ(judged.size(), 2u);
  EXPECT_EQ(judged[0].outcome, Outcome::kKept);  // 5.5 -+ 2.17
  EXPECT_EQ(judged[1].outcome, Outcome::kKept);
  EXPECT_DOUBLE_EQ(judged[0].estimate, 5.5);
}

TEST(Judgement, CountsAFigureThatDoesNotExistAsMissed) {
  std::vector<RunOutcome> runs = runs_with({1.0, std::numeric_limits<double>::quiet_NaN(), 1.0});
  runs[2].figures.clear();
  Expectation expectation{.name = "minutes", .min = std::nullopt, .max = 5.0};
  expectation.statistics[kMedian] = Bounds{std::nullopt, 5.0};
  const auto judged = judge_seeds(expecting(expectation), runs, {});
  EXPECT_EQ(judged[0].kept, 1);
  EXPECT_EQ(judged[0].failing.size(), 2u);
  EXPECT_EQ(judged[0].worst->seed, 2u);
  EXPECT_EQ(judged[1].outcome, Outcome::kMissed);
}

TEST(Judgement, OfNoSeedIsOpen) {
  const Expectation expectation{.name = "minutes", .min = std::nullopt, .max = 5.0};
  EXPECT_EQ(only(expectation, {}).outcome, Outcome::kOpen);
}

TEST(WorstSeeds, AreTheWorstOfEachThresholdMissedOnesFirst) {
  Scene scene = expecting({.name = "minutes", .min = std::nullopt, .max = 9.0});
  scene.expect.push_back({.name = "metres", .min = std::nullopt, .max = 1.0});
  std::vector<RunOutcome> runs = runs_with({1, 2, 3, 4});
  const double metres[] = {5, 3, 2, 0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].figures["metres"] = metres[i];
  }
  const auto judged = judge_seeds(scene, runs, {});
  EXPECT_THAT(worst_seeds(judged, runs, 3), ElementsAre(1, 4, 2));
  EXPECT_THAT(worst_seeds(judged, runs, 0), ElementsAre());
  EXPECT_THAT(worst_seeds(judged, runs, 9), ElementsAre(1, 4, 2, 3));
}

TEST(WorstSeeds, AreNoneWhereAllAreAlikeAndNothingIsMissed) {
  const Scene scene = expecting({.name = "minutes", .min = 2.0, .max = std::nullopt});
  const auto runs = runs_with({2, 2, 2});
  EXPECT_THAT(worst_seeds(judge_seeds(scene, runs, {}), runs, 3), ElementsAre());
}

}  // namespace
}  // namespace sensotwin::twin
