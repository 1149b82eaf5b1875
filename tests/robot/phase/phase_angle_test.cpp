// SPDX-License-Identifier: MIT
#include "robot/phase/phase_angle.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

constexpr double kWaveNumber_radpm = 2.0 * kPi / 0.328;

/// Baseband of a path of this length: I + jQ = exp(-j k d).
double phase_over(double path_m) {
  return phase_from_iq(std::cos(-kWaveNumber_radpm * path_m), std::sin(-kWaveNumber_radpm * path_m));
}

TEST(PhaseAngle, OfEquationOneGrowsWithTheLengthOfThePath) {
  double before = phase_over(3.0);
  for (int i = 1; i <= 1000; ++i) {
    const double now = phase_over(3.0 + 0.001 * i);
    EXPECT_NEAR(wrap_angle(now - before), 0.001 * kWaveNumber_radpm, 1e-9);
    before = now;
  }
}

TEST(PhaseAngle, OfEquationOneIsAQuarterTurnAheadOfTheLag) {
  EXPECT_NEAR(wrap_angle(phase_over(3.0) - 3.0 * kWaveNumber_radpm), kPi / 2, 1e-9);
}

TEST(PhaseDifference, IsNegativeForATagOnTheLeft) {
  const double left_m = std::hypot(1.0 - 0.08, 2.9);
  const double right_m = std::hypot(1.0 + 0.08, 2.9);
  EXPECT_LT(phase_difference(phase_over(left_m), phase_over(right_m)), 0.0);
}

TEST(PhaseDifference, IsTheSameWhereverAPhaseWraps) {
  for (int turn = 0; turn < 100; ++turn) {
    const double common = 0.1 * turn;
    const double left = std::fmod(common, 2.0 * kPi);
    const double right = std::fmod(common + 0.7, 2.0 * kPi);
    EXPECT_NEAR(phase_difference(left, right), -0.7, 1e-12);
  }
}

TEST(PhaseDifference, ModuloPiForgivesHalfATurnOfEither) {
  EXPECT_NEAR(phase_difference_modulo_pi(1.0, 1.4), -0.4, 1e-12);
  EXPECT_NEAR(phase_difference_modulo_pi(1.0 + kPi, 1.4), -0.4, 1e-12);
  EXPECT_NEAR(phase_difference_modulo_pi(1.0, 1.4 + kPi), -0.4, 1e-12);
}

TEST(WidestSpacing, IsHalfAWavelengthForThePapersReader) {
  EXPECT_DOUBLE_EQ(widest_spacing_m(0.328, 1, false), 0.164);  // algorithms study, A.0
  EXPECT_DOUBLE_EQ(widest_spacing_m(0.328, 2, false), 0.082);
  EXPECT_DOUBLE_EQ(widest_spacing_m(0.328, 2, true), 0.041);
}

}  // namespace
}  // namespace sensotwin::robot
