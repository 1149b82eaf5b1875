// SPDX-License-Identifier: MIT
#include "twin/validate/intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::twin {
namespace {

/// R. G. Newcombe, Two-sided confidence intervals for the single proportion, Stat. Med. 17, 1998, table I:
/// its four examples at 95 %, methods 3 (Wilson) and 5 (Clopper and Pearson).
struct Published {
  int kept;
  int runs;
  Interval wilson;
  Interval clopper_pearson;
};
const std::vector<Published> kNewcombe{{81, 263, {0.2553, 0.3662}, {0.2527, 0.3676}},
                                       {15, 148, {0.0624, 0.1605}, {0.0578, 0.1617}},
                                       {0, 20, {0.0000, 0.1611}, {0.0000, 0.1684}},
                                       {1, 29, {0.0061, 0.1718}, {0.0009, 0.1776}}};
constexpr double kFourDigits = 0.5e-4;

TEST(RateInterval, EqualsThePublishedOnesOfClopperAndPearson) {
  for (const Published& row : kNewcombe) {
    const Interval got = rate_interval(row.kept, row.runs, 0.95, RateMethod::kClopperPearson);
    EXPECT_NEAR(got.low, row.clopper_pearson.low, kFourDigits) << row.kept << " of " << row.runs;
    EXPECT_NEAR(got.high, row.clopper_pearson.high, kFourDigits) << row.kept << " of " << row.runs;
  }
}

TEST(RateInterval, EqualsThePublishedOnesOfWilson) {
  for (const Published& row : kNewcombe) {
    const Interval got = rate_interval(row.kept, row.runs, 0.95, RateMethod::kWilson);
    EXPECT_NEAR(got.low, row.wilson.low, kFourDigits) << row.kept << " of " << row.runs;
    EXPECT_NEAR(got.high, row.wilson.high, kFourDigits) << row.kept << " of " << row.runs;
  }
}

TEST(RateInterval, OfAllRunsHasTheClosedFormOfTheRuleOfThree) {
  // Clopper and Pearson with n of n: low = (alpha / 2)^(1 / n).
  const Interval all = rate_interval(200, 200, 0.95, RateMethod::kClopperPearson);
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 200.0), 1e-12);
  EXPECT_EQ(all.high, 1.0);
  EXPECT_EQ(rate_interval(200, 200, 0.95, RateMethod::kWilson).high, 1.0);
  EXPECT_EQ(rate_interval(0, 200, 0.95, RateMethod::kWilson).low, 0.0);
}

TEST(MeanInterval, EqualsTheTextbookOneByStudentsT) {
  // 1 .. 10: mean 5.5, s = 3.02765, t(9, 0.975) = 2.26216 (table of Student's t).
  std::vector<double> values(10);
  std::iota(values.begin(), values.end(), 1.0);
  const Interval got = mean_interval(values, 0.95);
  const double half = 2.26216 * 3.02765 / std::sqrt(10.0);
  EXPECT_NEAR(got.low, 5.5 - half, 1e-4);
  EXPECT_NEAR(got.high, 5.5 + half, 1e-4);
}

TEST(MeanInterval, OfOneValueBoundsNothing) {
  const std::vector<double> one{3.0};
  EXPECT_TRUE(std::isinf(mean_interval(one, 0.95).low));
  EXPECT_TRUE(std::isinf(mean_interval(one, 0.95).high));
}

std::vector<double> ranks(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(QuantileInterval, OfTheMedianHasTheTabulatedRanks) {
  // W. J. Conover, Practical Nonparametric Statistics, 3rd ed., section 3.2; two-sided 95 %.
  const struct {
    int n;
    Interval expected;
  } table[] = {{6, {1, 6}}, {10, {2, 9}}, {20, {6, 15}}, {25, {8, 18}}, {50, {18, 33}}, {100, {40, 61}}};
  for (const auto& row : table) {
    const Interval got = quantile_interval(ranks(row.n), 0.5, 0.95);
    EXPECT_EQ(got.low, row.expected.low) << row.n;
    EXPECT_EQ(got.high, row.expected.high) << row.n;
  }
}

TEST(QuantileInterval, OfAnOuterQuantileIsOpenUntilThereAreEnoughValues) {
  // 0.95^72 <= 0.025 < 0.95^71.
  EXPECT_TRUE(std::isinf(quantile_interval(ranks(72), 0.95, 0.95).high) == false);
  EXPECT_TRUE(std::isinf(quantile_interval(ranks(71), 0.95, 0.95).high));
  EXPECT_TRUE(std::isinf(quantile_interval(ranks(71), 0.05, 0.95).low));
  EXPECT_TRUE(std::isinf(quantile_interval(ranks(5), 0.5, 0.95).low));
}

TEST(QuantileInterval, MirrorsWithItsQuantile) {
  const Interval low = quantile_interval(ranks(200), 0.05, 0.95);
  const Interval high = quantile_interval(ranks(200), 0.95, 0.95);
  EXPECT_EQ(low.low, 201.0 - high.high);
  EXPECT_EQ(low.high, 201.0 - high.low);
}

TEST(QuantileInterval, CoversTheTruthAtLeastAsOftenAsItSays) {
  // Squares of uniform numbers: the 90 % quantile is 0.81. 2000 samples of 100; the share that covers it has
  // a standard deviation of sqrt(0.95 * 0.05 / 2000) = 0.5 %.
  robot::RandomStream random{20261122};
  int covered = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    std::vector<double> values(100);
    std::generate(values.begin(), values.end(), [&] {
      const double u = random.uniform();
      return u * u;
    });
    std::sort(values.begin(), values.end());
    const Interval interval = quantile_interval(values, 0.9, 0.95);
    covered += interval.low <= 0.81 && 0.81 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(covered / 2000.0, 0.95 - 4 * 0.005);
}

TEST(Quantile, LiesBetweenOrderStatistics) {
  const std::vector<double> values{1.0, 2.0, 4.0, 8.0};
  EXPECT_DOUBLE_EQ(quantile_of(values, 0.5), 3.0);
  EXPECT_DOUBLE_EQ(quantile_of(values, 0.95), 4.0 + 0.85 * 4.0);
  EXPECT_DOUBLE_EQ(quantile_of(std::vector<double>{7.0}, 0.95), 7.0);
}

}  // namespace
}  // namespace sensotwin::twin
