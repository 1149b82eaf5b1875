// SPDX-License-Identifier: MIT
#include "robot/calibration/antenna_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/base/random.hpp"

namespace sensotwin::robot {
namespace {

/// Reads of a tag at two spots, turning; without echoes.
std::vector<PlacedRead> turned_under(const PhaseReaderModel& truth, const Vec2& tag_O_m, double sigma_rad,
                                     const std::vector<double>& channels_hz) {
  RandomStream random(7);
  std::vector<PlacedRead> reads;
  for (std::size_t i = 0; i < 2400; ++i) {
    PlacedRead placed;
    placed.spot = i / 1200;
    placed.X_OR = {{0.12 * static_cast<double>(placed.spot), 0.0},
                   wrap_angle(2.0 * kPi * static_cast<double>(i % 600) / 600.0)};
    placed.read.antenna = static_cast<std::uint16_t>(1 + i % truth.antennas.size());
    placed.read.frequency_hz = channels_hz[(i / 29) % channels_hz.size()];
    const AntennaMount& mount = truth.antennas[placed.read.antenna - 1u];
    const WayLength way = way_length(way_ends(truth, placed.read.antenna - 1u, Pose2{}), placed.X_OR,
                                     {tag_O_m.x(), tag_O_m.y(), 3.0});
    const double hop_hz = placed.read.frequency_hz - truth.centre_hz;
    const double phase = truth.phase_sign * (truth.wave_number(placed.read.frequency_hz) * way.length_m +
                                             2.0 * kPi * hop_hz * mount.cable_delay_s) +
                         mount.phase_offset_rad + 0.8 + sigma_rad * random.normal();
    const double half = truth.pi_ambiguous && random.chance(0.5) ? kPi : 0.0;
    placed.read.phase_rad = std::fmod(std::fmod(phase + half, 2.0 * kPi) + 2.0 * kPi, 2.0 * kPi);
    reads.push_back(placed);
  }
  return reads;
}

std::vector<double> band() {
  std::vector<double> channels_hz;
  for (int i = 0; i < 50; ++i) {
    channels_hz.push_back(902.75e6 + 0.5e6 * ((17 * i) % 50));
  }
  return channels_hz;
}

PhaseReaderModel two_ports(bool monostatic, bool pi_ambiguous) {
  PhaseReaderModel truth;
  truth.antennas = antenna_pair(0.2, 0.1);
  truth.monostatic = monostatic;
  truth.phase_sign = -1.0;
  truth.pi_ambiguous = pi_ambiguous;
  truth.antennas[0].cable_delay_s = 38e-9;
  truth.antennas[1].cable_delay_s = 46e-9;
  truth.antennas[1].phase_offset_rad = 1.1;
  return truth;
}

PhaseReaderModel untold(PhaseReaderModel model) {
  for (AntennaMount& antenna : model.antennas) {
    antenna.cable_delay_s = antenna.phase_offset_rad = 0.0;
  }
  return model;
}

TEST(AntennaFit, FindsOffsetsDelaysAndTheTagOfEachKindOfReader) {
  for (const bool monostatic : {false, true}) {
    for (const bool pi_ambiguous : {false, true}) {
      const PhaseReaderModel truth = two_ports(monostatic, pi_ambiguous);
      const auto fit =
          fit_antennas(turned_under(truth, {0.2, -0.3}, 0.05, band()), {.reader = untold(truth)});
      ASSERT_TRUE(fit);
      EXPECT_TRUE(fit->delays_known);
      EXPECT_NEAR(truth.wrap(fit->ports[1].phase_offset_rad.value - 1.1), 0.0, 0.05);
      EXPECT_NEAR(fit->ports[0].cable_delay_s.value, 38e-9, 1e-9);
      EXPECT_NEAR(fit->ports[1].cable_delay_s.value, 46e-9, 1e-9);
      EXPECT_NEAR(fit->spread_rad, 0.05, 0.01);
    }
  }
}

TEST(AntennaFit, LeavesDelaysAloneOnOneChannel) {
  const PhaseReaderModel truth = two_ports(true, false);
  PhaseReaderModel told = untold(truth);
  told.antennas[1].cable_delay_s = 7e-9;
  const auto fit = fit_antennas(turned_under(truth, {0.2, -0.3}, 0.05, {915e6}), {.reader = told});
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->delays_known);
  EXPECT_NEAR(fit->ports[1].cable_delay_s.value, 7e-9, 1e-12);
  EXPECT_NEAR(wrap_angle(fit->ports[1].phase_offset_rad.value - 1.1), 0.0, 0.05);
}

TEST(AntennaFit, RefusesPhasesThatNoPlaceExplains) {
  const PhaseReaderModel truth = two_ports(true, false);
  EXPECT_FALSE(fit_antennas(turned_under(truth, {0.2, -0.3}, 10.0, band()), {.reader = untold(truth)}));
}

TEST(AntennaFit, RefusesAPortThatHardlyHeardTheTag) {
  const PhaseReaderModel truth = two_ports(true, false);
  std::vector<PlacedRead> reads = turned_under(truth, {0.2, -0.3}, 0.05, band());
  std::erase_if(reads, [](const PlacedRead& placed) { return placed.read.antenna == 2; });
  EXPECT_FALSE(fit_antennas(reads, {.reader = untold(truth)}));
}

}  // namespace
}  // namespace sensotwin::robot
