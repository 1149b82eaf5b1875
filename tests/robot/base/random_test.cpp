// SPDX-License-Identifier: MIT
#include "robot/base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace sensotwin::robot {
namespace {

/// Draws for the statistics, and the tolerance in standard deviations of the estimate: by chance one seed in
/// a million would fail (two-sided normal tail at 5 sigma, 6e-7); this one is fixed, so it always passes or
/// never.
constexpr int kDraws = 200'000;
constexpr double kSigmas = 5.0;

// Random123 1.14, tests/kat_vectors, "philox4x32 10": counter 0, key 0 gives 6627e8d5 e169c58d bc57ac4c
// 9b00dbd8. A stream of seed 0 begins at counter 0 with key 0; its 64-bit draws take the words low word
// first.
TEST(RandomStream, BeginsWithThePublishedVectorOfPhilox) {
  RandomStream random{0};
  EXPECT_EQ(random.next_u64(), 0xe169c58d'6627e8d5u);
  EXPECT_EQ(random.next_u64(), 0x9b00dbd8'bc57ac4cu);
}

// FNV-1a of eight zero bytes and "a", by the definition (offset basis cbf29ce484222325, prime 100000001b3):
// worked out with a dozen lines of Python. The names of streams are part of every golden run.
TEST(RandomStream, NamesAChildByFnv1aOfSeedAndName) {
  constexpr RandomStream kChild = RandomStream{0}.fork("a");
  EXPECT_EQ(kChild.seed(), 0xe604613a'248ff1acu);
}

TEST(RandomStream, GivesTheSameNumbersForTheSameSeed) {
  RandomStream a{42};
  RandomStream b{42};
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(a.next_u64(), b.next_u64());
  }
}

TEST(AForkedStream, DoesNotCareHowMuchItsParentDrew) {
  RandomStream parent{7};
  RandomStream early = parent.fork("reader");
  for (int i = 0; i < 1001; ++i) {
    static_cast<void>(parent.normal());
  }
  RandomStream late = parent.fork("reader");
  EXPECT_EQ(early.next_u64(), late.next_u64());
}

TEST(AForkedStream, TakesNothingFromItsParent) {
  RandomStream forked{7};
  RandomStream alone{7};
  static_cast<void>(forked.fork("reader").next_u64());
  EXPECT_EQ(forked.next_u64(), alone.next_u64());
}

TEST(AForkedStream, DependsOnItsNameAndOnEveryAncestor) {
  const RandomStream root{7};
  EXPECT_NE(root.fork("left").seed(), root.fork("right").seed());
  EXPECT_NE(root.fork("a").fork("b").seed(), root.fork("b").fork("a").seed());
  EXPECT_NE(root.fork("left").seed(), RandomStream{8}.fork("left").seed());
}

/// Correlation of two streams' uniform draws; its standard deviation is 1/sqrt(draws) when they are
/// independent.
double correlation(RandomStream a, RandomStream b) {
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    sum += (a.uniform() - 0.5) * (b.uniform() - 0.5) * 12.0;
  }
  return sum / kDraws;
}

TEST(AForkedStream, IsUncorrelatedWithItsParentAndItsSiblings) {
  const RandomStream root{7};
  const double tolerance = kSigmas / std::sqrt(kDraws);
  EXPECT_NEAR(correlation(root, root.fork("left")), 0.0, tolerance);
  EXPECT_NEAR(correlation(root.fork("left"), root.fork("right")), 0.0, tolerance);
  EXPECT_NEAR(correlation(RandomStream{1}, RandomStream{2}), 0.0, tolerance);
}

// Uniform on [0, 1): mean 1/2 with variance 1/12 a draw; E[(u - 1/2)^2] = 1/12 with variance 1/80 - 1/144 =
// 1/180.
TEST(UniformNumbers, HaveTheMomentsOfTheUniformLaw) {
  RandomStream random = RandomStream{11}.fork("uniform");
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += (u - 0.5) * (u - 0.5);
  }
  EXPECT_NEAR(sum / kDraws, 0.5, kSigmas * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 12.0, kSigmas * std::sqrt(1.0 / 180.0 / kDraws));
}

TEST(UniformNumbers, StayBetweenTheBoundsAskedFor) {
  RandomStream random = RandomStream{12}.fork("uniform");
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-3.0, -1.0);
    ASSERT_GE(x, -3.0);
    ASSERT_LT(x, -1.0);
  }
}

// Standard normal: the estimates of its first four moments have standard deviations 1, sqrt 2, sqrt 15, sqrt
// 96 over sqrt n (E[x^2k] = 1, 3, 15, 105 for k = 1..4, less the squares of the means 0, 1, 0, 3).
TEST(NormalNumbers, HaveTheMomentsOfTheNormalLaw) {
  RandomStream random = RandomStream{13}.fork("normal");
  std::array<double, 4> moments{};
  int within_one_sigma = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    double power = 1.0;
    for (double& moment : moments) {
      power *= x;
      moment += power / kDraws;
    }
    within_one_sigma += std::abs(x) < 1.0 ? 1 : 0;
  }
  const double unit = kSigmas / std::sqrt(kDraws);
  EXPECT_NEAR(moments[0], 0.0, unit);
  EXPECT_NEAR(moments[1], 1.0, unit * std::sqrt(2.0));
  EXPECT_NEAR(moments[2], 0.0, unit * std::sqrt(15.0));
  EXPECT_NEAR(moments[3], 3.0, unit * std::sqrt(96.0));
  const double inside = std::erf(1.0 / std::sqrt(2.0));
  EXPECT_NEAR(static_cast<double>(within_one_sigma) / kDraws, inside,
              unit * std::sqrt(inside * (1.0 - inside)));
}

// Box-Muller gives two numbers from one radius: they must not know of each other.
TEST(NormalNumbers, AreUncorrelatedWithTheirTwinsAndSoAreTheirSquares) {
  RandomStream random = RandomStream{14}.fork("normal");
  double product = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    const double y = random.normal();
    product += x * y / kDraws;
    squares += (x * x - 1.0) * (y * y - 1.0) / kDraws;
  }
  EXPECT_NEAR(product, 0.0, kSigmas / std::sqrt(kDraws));
  EXPECT_NEAR(squares, 0.0, kSigmas * 2.0 / std::sqrt(kDraws)) << "variance of x^2 is 2, of the product 4";
}

TEST(NormalNumbers, AreShiftedAndScaledAsAskedFor) {
  RandomStream standard{15};
  RandomStream scaled{15};
  for (int i = 0; i < 10; ++i) {
    EXPECT_DOUBLE_EQ(scaled.normal(2.0, 0.5), 2.0 + 0.5 * standard.normal());
  }
}

TEST(NumbersBelowN, FallIntoEachOfThemEqually) {
  RandomStream random = RandomStream{16}.fork("below");
  std::array<int, 6> seen{};
  for (int i = 0; i < kDraws; ++i) {
    ++seen.at(random.below(6));
  }
  double chi_squared = 0.0;
  for (const int n : seen) {
    const double expected = kDraws / 6.0;
    chi_squared += (n - expected) * (n - expected) / expected;
  }
  EXPECT_LT(chi_squared, 25.7) << "99.99 % quantile of chi squared with 5 degrees of freedom";
}

TEST(Chances, AreTakenAsOftenAsTheyShould) {
  RandomStream random = RandomStream{17}.fork("chance");
  int taken = 0;
  for (int i = 0; i < kDraws; ++i) {
    taken += random.chance(0.03) ? 1 : 0;
  }
  EXPECT_NEAR(taken, 0.03 * kDraws, kSigmas * std::sqrt(kDraws * 0.03 * 0.97));
  EXPECT_FALSE(random.chance(0.0));
  EXPECT_TRUE(random.chance(1.0));
}

}  // namespace
}  // namespace sensotwin::robot
