// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "one_tag.hpp"

namespace sensotwin::world {
namespace {

double rssi_dbm(const RadioWorld& world, const robot::Pose2& X_WR = {}) {
  return reads_at_rest(world, 0.0, X_WR).at(0).rssi_dbm;
}

/// An antenna of the reference gain, straight below the tag, by so far.
RadioWorld below(double distance_m) {
  RadioWorld world = one_tag(1);
  world.radio.path = PathKind::kMonostatic;
  world.antennas[0] = {.at_m = {0.0, 0.0, 3.0 - distance_m}, .gain_dbi = kReferenceGain_dbi};
  return world;
}

TEST(RadioStrength, FallsByItsSlopePerDecadeFromItsValueAtOneMetre) {
  EXPECT_NEAR(rssi_dbm(below(1.0)), -35.0, 1e-9);
  EXPECT_NEAR(rssi_dbm(below(0.1)), 5.0, 1e-9);
  RadioWorld world = below(2.9);
  world.radio.rssi_slope_db = -22.2;
  EXPECT_NEAR(rssi_dbm(world), -35.0 - 22.2 * std::log10(2.9), 1e-9);
}

TEST(RadioStrength, LosesGainAndShadowTwiceAndHalfThePowerAtTheEdgeOfTheBeam) {
  RadioWorld world = below(2.0);
  const double clear_dbm = rssi_dbm(world);
  world.antennas[0].gain_dbi -= 3.5;
  EXPECT_NEAR(rssi_dbm(world), clear_dbm - 7.0, 1e-9);
  world.antennas[0].gain_dbi += 3.5;
  world.tags[0].shadow_db = 4.0;
  EXPECT_NEAR(rssi_dbm(world), clear_dbm - 8.0, 1e-9);
  world.tags[0].shadow_db = 0.0;
  const double half_beam_rad = 0.5 * world.antennas[0].beam_width_rad;
  world.antennas[0].boresight = {std::sin(half_beam_rad), 0.0, std::cos(half_beam_rad)};
  EXPECT_NEAR(rssi_dbm(world), clear_dbm - 2.0 * 10.0 * std::log10(2.0), 1e-9);
  world.antennas[0].boresight = {0.0, 0.0, -1.0};
  EXPECT_NEAR(rssi_dbm(world), clear_dbm - 40.0, 1e-9) << "side lobes, twice 20 dB down";
}

TEST(RadioStrength, TurnsItsBeamWithTheRobot) {
  RadioWorld world = one_tag(1);
  world.antennas[0].boresight = {std::sin(0.6), 0.0, std::cos(0.6)};
  const robot::Pose2 towards{{-2.0, 0.0}, 0.0};
  const robot::Pose2 away{{-2.0, 0.0}, robot::kPi};
  EXPECT_GT(rssi_dbm(world, towards), rssi_dbm(world, away) + 5.0);
}

TEST(RadioStrength, DecidesAtTheCutOffWhetherATagIsRead) {
  RadioWorld world = below(2.0);
  world.radio.cutoff_dbm = rssi_dbm(world) + 0.01;
  EXPECT_TRUE(reads_at_rest(world, 10.0).empty());
  world.radio.cutoff_dbm -= 0.02;
  EXPECT_EQ(reads_at_rest(world, 10.0).size(), 201U);
  world.radio.rssi_sigma_db = 0.4;
  world.radio.cutoff_dbm += 0.01;
  EXPECT_NEAR(static_cast<double>(reads_at_rest(world, 100.0).size()) / 2001.0, 0.5,
              4.0 * 0.5 / std::sqrt(2001.0));
}

TEST(RadioStrength, HearsNothingOfATagThatIsNotThere) {
  RadioWorld world = one_tag(2);
  world.tags[0].present = false;
  EXPECT_TRUE(reads_at_rest(world, 1.0).empty());
}

TEST(RadioStrength, FadesByChannelInBlocksOfNeighbouringFrequencies) {
  RadioWorld world = below(2.0);
  world.radio.channels_hz.clear();
  for (int i = 0; i < 50; ++i) {
    world.radio.channels_hz.push_back(902.75e6 + 0.5e6 * i);
  }
  world.radio.channel_sigma_db = 2.0;
  world.radio.channel_delay_s = 30e-9;
  world.radio.dwell_s = 0.05;
  double neighbours2 = 0.0;
  double band2 = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto reads = reads_at_rest(world, 2.49, {}, seed);
    double mean = 0.0;
    for (const RadioRead& read : reads) {
      mean += read.rssi_dbm / 50.0;
    }
    ASSERT_EQ(reads.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i) {
      band2 += std::pow(reads[i].rssi_dbm - mean, 2) / 50.0 / 200.0;
      neighbours2 += i > 0 ? std::pow(reads[i].rssi_dbm - reads[i - 1].rssi_dbm, 2) / 49.0 / 200.0 : 0.0;
    }
  }
  // Data study, 3.3: 0.4 to 3.1 dB between the channels of one place.
  EXPECT_GT(std::sqrt(band2), 1.0);
  EXPECT_LT(std::sqrt(band2), 1.7);
  EXPECT_LT(std::sqrt(neighbours2), 0.25);
}

TEST(RadioStrength, IsReportedInTheReadersSteps) {
  RadioWorld world = below(2.0);
  world.radio.rssi_sigma_db = 1.0;
  world.radio.rssi_step_db = 0.5;
  std::set<double> seen;
  for (const RadioRead& read : reads_at_rest(world, 20.0)) {
    EXPECT_EQ(read.rssi_dbm * 2.0, std::round(read.rssi_dbm * 2.0));
    seen.insert(read.rssi_dbm);
  }
  EXPECT_GT(seen.size(), 6U);
}

}  // namespace
}  // namespace sensotwin::world
