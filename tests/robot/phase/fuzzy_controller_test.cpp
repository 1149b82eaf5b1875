// SPDX-License-Identifier: MIT
#include "robot/phase/fuzzy_controller.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/base/random.hpp"
#include "robot/phase/control_surface.hpp"

namespace sensotwin::robot {
namespace {

/// Centre of area by the book: the union of the clipped sets, summed over the middles of many thin slices.
double sampled_turn_rate(const FuzzySets& sets, double dphi, double low, double high, int slices) {
  const double negative = sets.negative_rad.degree(dphi);
  const double zero = sets.zero_rad.degree(dphi);
  const double positive = sets.positive_rad.degree(dphi);
  double area = 0.0;
  double moment = 0.0;
  for (int i = 0; i < slices; ++i) {
    const double y = low + (i + 0.5) / slices * (high - low);
    const double mu = std::max({std::min(negative, sets.counter_clockwise_radps.degree(y)),
                                std::min(zero, sets.straight_radps.degree(y)),
                                std::min(positive, sets.clockwise_radps.degree(y))});
    area += mu;
    moment += mu * y;
  }
  return area > 0.0 ? moment / area : 0.0;
}

Trapezoid random_set(RandomStream& random, double low, double high) {
  std::array<double, 4> corners{};
  for (double& corner : corners) {
    corner = random.uniform(low, high);
  }
  std::sort(corners.begin(), corners.end());
  return {corners[0], corners[1], corners[2], corners[3]};
}

TEST(Trapezoid, IsOneBetweenItsShouldersAndStraightDownToItsFeet) {
  constexpr Trapezoid set{0.0, 1.0, 2.0, 4.0};
  EXPECT_EQ(set.degree(-0.1), 0.0);
  EXPECT_EQ(set.degree(0.25), 0.25);
  EXPECT_EQ(set.degree(1.0), 1.0);
  EXPECT_EQ(set.degree(2.0), 1.0);
  EXPECT_EQ(set.degree(3.0), 0.5);
  EXPECT_EQ(set.degree(4.1), 0.0);
}

TEST(Trapezoid, WithAVerticalEdgeContainsTheEdge) {
  constexpr Trapezoid set{1.0, 1.0, 2.0, 2.0};
  EXPECT_EQ(set.degree(1.0), 1.0);
  EXPECT_EQ(set.degree(2.0), 1.0);
  EXPECT_EQ(set.degree(0.999), 0.0);
}

TEST(FuzzyController, TurnsLeftForANegativePhaseDifferenceAndRightForAPositiveOne) {
  const FuzzyController controller{kReproductionSets};
  EXPECT_GT(controller.turn_rate_radps(-0.5), 0.0);
  EXPECT_LT(controller.turn_rate_radps(0.5), 0.0);
  EXPECT_NEAR(controller.turn_rate_radps(0.0), 0.0, 1e-15);
}

TEST(FuzzyController, SaturatesAtTheRateOfItsOuterSets) {
  const FuzzyController controller{kReproductionSets};
  EXPECT_NEAR(controller.turn_rate_radps(-1.0), 1.1, 1e-12);
  EXPECT_NEAR(controller.turn_rate_radps(-2.5), 1.1, 1e-12);
  EXPECT_NEAR(controller.turn_rate_radps(kPi), -1.1, 1e-12);
  EXPECT_NEAR(controller.turn_rate_radps(100.0), -1.1, 1e-12);
}

// At dphi = -z/2 both rules hold by one half. With w = 1: zero is cut to a trapezoid of height 1/2 over
// [-1, 1], counter-clockwise to one over [0, 2]; the union has its slopes over [-1, -1/2] and [3/2, 2], is
// flat between, and is symmetric about 1/2.
TEST(FuzzyController, GivesHalfTheRateWhereTwoRulesHoldByHalf) {
  const FuzzyController controller{fuzzy_sets(1.0, 1.0)};
  EXPECT_NEAR(controller.turn_rate_radps(-0.5), 0.5, 1e-12);
}

TEST(FuzzyController, IsOddWhenItsSetsAreMirrored) {
  const FuzzyController controller{kTunedSets};
  for (int i = 0; i <= 300; ++i) {
    const double dphi = 0.01 * i;
    EXPECT_NEAR(controller.turn_rate_radps(dphi), -controller.turn_rate_radps(-dphi), 1e-13);
  }
}

TEST(FuzzyController, AgreesWithTheSampledCentreOfAreaOfThePresets) {
  constexpr int kSlices = 40'000;
  for (const FuzzySets& sets : {kReproductionSets, kTunedSets, fuzzy_sets(0.3, 0.85)}) {
    const FuzzyController controller{sets};
    const double low = sets.clockwise_radps.left_foot;
    const double high = sets.counter_clockwise_radps.right_foot;
    for (int i = -31; i <= 31; ++i) {
      // The midpoint rule is off by the slices in which the union has a corner, a dozen at most: of the order
      // of 12 (width / slices)^2 of an area that is not below half the width.
      EXPECT_NEAR(controller.turn_rate_radps(0.1 * i), sampled_turn_rate(sets, 0.1 * i, low, high, kSlices),
                  1e-7);
    }
  }
}

TEST(FuzzyController, AgreesWithTheSampledCentreOfAreaOfAnySets) {
  RandomStream random = RandomStream{1}.fork("sets");
  constexpr int kSlices = 20'000;
  for (int i = 0; i < 200; ++i) {
    const FuzzySets sets{.negative_rad = random_set(random, -3, 3),
                         .zero_rad = random_set(random, -3, 3),
                         .positive_rad = random_set(random, -3, 3),
                         .clockwise_radps = random_set(random, -2, 2),
                         .straight_radps = random_set(random, -2, 2),
                         .counter_clockwise_radps = random_set(random, -2, 2)};
    ASSERT_EQ(problem_of(sets), std::nullopt);
    const FuzzyController controller{sets};
    const double dphi = random.uniform(-3, 3);
    const std::array<double, 3> degrees = controller.degrees(dphi);
    // Slices are too coarse for a set that hardly holds or is narrower than a few of them.
    if (*std::max_element(degrees.begin(), degrees.end()) < 0.1) {
      continue;
    }
    EXPECT_NEAR(controller.turn_rate_radps(dphi), sampled_turn_rate(sets, dphi, -2, 2, kSlices), 1e-4)
        << "set " << i;
  }
}

TEST(FuzzyController, AsksForNoTurnWhereNoSetHolds) {
  FuzzySets sets = kReproductionSets;
  sets.zero_rad = triangle(-0.5, 0.0, 0.5);
  sets.negative_rad = {-kPi, -kPi, -1.5, -1.0};
  EXPECT_EQ(FuzzyController{sets}.turn_rate_radps(-0.75), 0.0);
}

TEST(FuzzyController, MakesTheHeadingStepOfEquationThree) {
  const FuzzyController controller{kReproductionSets};
  EXPECT_NEAR(controller.heading_step_rad(-1.0, 0.05), 1.1 * 0.05, 1e-12);
}

TEST(FuzzySets, ThatCannotBeUsedAreRefusedWithTheirName) {
  EXPECT_EQ(problem_of(kReproductionSets), std::nullopt);
  FuzzySets sets = kReproductionSets;
  sets.zero_rad = {1.0, 0.0, 0.0, -1.0};
  EXPECT_THAT(problem_of(sets).value_or(""), testing::StartsWith("zero: the corners"));
  sets = kReproductionSets;
  sets.clockwise_radps = {-2.0, -2.0, -1.0, 0.0};
  EXPECT_THAT(problem_of(sets).value_or(""), testing::StartsWith("clockwise: an output set"));
}

TEST(ControlSurface, IsTheControllersOwnAnswer) {
  const FuzzyController controller{kReproductionSets};
  const ControlSurface surface = control_surface(controller, 101);
  ASSERT_EQ(surface.inputs.size(), 101u);
  ASSERT_EQ(surface.outputs.size(), 101u);
  EXPECT_NEAR(surface.inputs.front().phase_difference_rad, -kPi, 1e-12);
  EXPECT_NEAR(surface.inputs.back().phase_difference_rad, kPi, 1e-12);
  EXPECT_NEAR(surface.outputs.front().turn_rate_radps, -2.2, 1e-12);
  EXPECT_NEAR(surface.outputs.back().turn_rate_radps, 2.2, 1e-12);
  for (const ControlSurface::Input& point : surface.inputs) {
    EXPECT_EQ(point.turn_rate_radps, controller.turn_rate_radps(point.phase_difference_rad));
    EXPECT_NEAR(point.negative + point.zero + point.positive, 1.0, 1e-12);
  }
  EXPECT_EQ(surface.inputs.front().negative, 1.0);
  EXPECT_EQ(surface.inputs[50].zero, 1.0);
  EXPECT_EQ(surface.outputs[75].counter_clockwise, 1.0);
}

}  // namespace
}  // namespace sensotwin::robot
