// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "one_tag.hpp"

namespace sensotwin::world {
namespace {

double phase_rad(const RadioWorld& world, const robot::Pose2& X_WR, std::size_t read = 0) {
  return reads_at_rest(world, 0.0, X_WR).at(read).phase_rad;
}

TEST(RadioPhase, MonostaticTurnsOnceForEachHalfWavelength) {
  RadioWorld world = one_tag(1);
  world.radio.path = PathKind::kMonostatic;
  world.antennas[0].at_m = {0.0, 0.0, 0.1};
  const double half_wave_m = 0.5 * kLight_mps / world.radio.channels_hz[0];
  const double first_rad = phase_rad(world, {});
  for (const int turns : {1, 2, 3}) {
    world.antennas[0].at_m.z() = 0.1 + turns * half_wave_m;
    EXPECT_NEAR(between_rad(phase_rad(world, {}), first_rad), 0.0, 1e-9);
  }
  world.antennas[0].at_m.z() = 0.1 + 0.25 * half_wave_m;
  EXPECT_NEAR(between_rad(phase_rad(world, {}), first_rad), -0.5 * robot::kPi, 1e-9) << "nearer: it falls";
}

TEST(RadioPhase, FallsWithDistanceWhereTheSignSaysSo) {
  RadioWorld world = one_tag(1);
  const double near_rad = phase_rad(world, {{0.5, 0.0}, 0.0});
  const double rising = between_rad(phase_rad(world, {{0.6, 0.0}, 0.0}), near_rad);
  world.radio.phase_sign = -1.0;
  const double falling =
      between_rad(phase_rad(world, {{0.6, 0.0}, 0.0}), phase_rad(world, {{0.5, 0.0}, 0.0}));
  EXPECT_GT(rising, 0.5);
  EXPECT_NEAR(falling, -rising, 1e-9);
}

TEST(RadioPhase, BistaticIsTheWayFromTheMiddleOfTheRobotAndBackToTheAntenna) {
  const RadioWorld world = one_tag();
  const robot::Pose2 X_WR{{1.2, -0.7}, 0.4};
  const double k_radpm = 2.0 * robot::kPi * 915e6 / kLight_mps;
  const double out_m = std::hypot(X_WR.p_m.norm(), 2.9);
  for (std::size_t a = 0; a < 2; ++a) {
    const robot::Vec2 antenna_m = X_WR * robot::Vec2{world.antennas[a].at_m.head<2>()};
    const double expected_rad = k_radpm * (out_m + std::hypot(antenna_m.norm(), 2.9));
    EXPECT_NEAR(between_rad(phase_rad(world, X_WR, a), expected_rad), 0.0, 1e-9);
  }
}

// The fuzzy controller's premise (algorithms study, A.0).
TEST(RadioPhase, IsSmallerOnTheSideOfTheTag) {
  const RadioWorld world = one_tag();
  const auto reads = reads_at_rest(world, 0.0, {{0.0, -2.0}, 0.0});
  ASSERT_EQ(reads.size(), 2U);
  EXPECT_LT(between_rad(reads[0].phase_rad, reads[1].phase_rad), -0.5) << "antenna 1 is the left one";
}

TEST(RadioPhase, IsLinearInFrequencyWithPathAndCableAsItsSlope) {
  RadioWorld world = one_tag(1);
  world.radio.path = PathKind::kMonostatic;
  world.antennas[0].cable_delay_s = 50e-9;
  world.radio.channels_hz = {902.75e6, 903.25e6, 920.75e6, 927.25e6};
  world.radio.dwell_s = 0.1;
  const auto reads = reads_at_rest(world, 0.35);
  const double delay_s = 2.0 * std::hypot(2.9, 0.08) / kLight_mps + 50e-9;
  for (const RadioRead& read : reads) {
    const double cycles = world.radio.channels_hz[read.channel] * delay_s;
    EXPECT_NEAR(between_rad(read.phase_rad, 2.0 * robot::kPi * (cycles - std::floor(cycles))), 0.0, 1e-6);
  }
  EXPECT_EQ(reads.back().channel, 3);
}

TEST(RadioPhase, OfEachReadIsThatOfItsOwnInstantWithinTheTick) {
  const RadioWorld world = one_tag(1);
  const robot::Pose2 begin{{0.5, 0.2}, 3.0};
  const robot::Pose2 end{{0.9, -0.2}, -3.0};
  Radio radio(world, robot::RandomStream{1});
  const auto reads = radio.step({.begin_s = 0.0, .end_s = 0.2, .X_WR_begin = begin, .X_WR_end = end});
  ASSERT_EQ(reads.size(), 5U);
  const robot::Pose2 half{{0.7, 0.0}, robot::kPi};
  EXPECT_NEAR(reads[2].time_s, 0.1, 1e-12);
  EXPECT_NEAR(between_rad(reads[2].phase_rad, phase_rad(world, half)), 0.0, 1e-9);
  EXPECT_NEAR(between_rad(reads[0].phase_rad, phase_rad(world, begin)), 0.0, 1e-9);
  EXPECT_NEAR(between_rad(reads[4].phase_rad, phase_rad(world, end)), 0.0, 1e-9);
}

TEST(RadioPhase, ComesInTheStepsOfTheReader) {
  RadioWorld world = one_tag(1);
  world.radio.phase_steps = 1024;
  world.radio.noise_per_m_rad = 0.3;
  const double exact_rad = phase_rad(one_tag(1), {});
  double farthest_rad = 0.0;
  for (const RadioRead& read : reads_at_rest(world, 50.0)) {
    const double steps = read.phase_rad / (2.0 * robot::kPi) * 1024.0;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LT(read.phase_rad, 2.0 * robot::kPi);
    EXPECT_GE(read.phase_rad, 0.0);
    farthest_rad = std::max(farthest_rad, std::abs(between_rad(read.phase_rad, exact_rad)));
  }
  EXPECT_GT(farthest_rad, 1.0);
}

TEST(RadioPhase, CarriesTheTagsOwnConstant) {
  RadioWorld world = one_tag(1);
  const double bare_rad = phase_rad(world, {});
  world.tags[0].phase_offset_rad = 1.25;
  EXPECT_NEAR(between_rad(phase_rad(world, {}), bare_rad), 1.25, 1e-9);
  world.tags[0].phase_offset_rad.reset();
  Radio radio(world, robot::RandomStream{4});
  const double drawn_rad = radio.tag_phase_rad(0);
  EXPECT_NE(drawn_rad, Radio(world, robot::RandomStream{5}).tag_phase_rad(0)) << "drawn once per run";
  EXPECT_NEAR(between_rad(reads_at_rest(radio, {}, 0.0)[0].phase_rad, bare_rad), robot::wrap_angle(drawn_rad),
              1e-9);
}

// A single image of relative amplitude a turns the phase by asin(a) at most, on each of the two ways.
TEST(RadioPhase, IsBentByImageSourcesWithinTheirAmplitude) {
  RadioWorld world = one_tag(1);
  const RadioWorld clean = world;
  world.radio.images = 1;
  world.radio.image_amplitude = 0.1;
  double worst_rad = 0.0;
  for (double x_m = 0.0; x_m < 3.0; x_m += 0.01) {
    const robot::Pose2 X_WR{{x_m, 0.3}, 0.0};
    worst_rad = std::max(worst_rad, std::abs(between_rad(phase_rad(world, X_WR), phase_rad(clean, X_WR))));
  }
  EXPECT_LE(worst_rad, 2.0 * std::asin(0.1) + 1e-9);
  EXPECT_GT(worst_rad, 1.5 * std::asin(0.1));
}

}  // namespace
}  // namespace sensotwin::world
