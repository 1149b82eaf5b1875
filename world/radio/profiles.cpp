// SPDX-License-Identifier: MIT
#include "world/radio/profiles.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace sensotwin::world {
namespace {

/// The 50 channels of the FCC band (47 CFR 15.247; capabilities of an R420 in the data study's recordings).
constexpr int kFccChannels = 50;
constexpr double kFccFirst_hz = 902.75e6;
constexpr double kFccStep_hz = 0.5e6;

std::vector<double> shuffled_fcc_channels_hz(robot::RandomStream& random) {
  std::vector<double> channels_hz;
  channels_hz.reserve(kFccChannels);
  for (int i = 0; i < kFccChannels; ++i) {
    channels_hz.push_back(kFccFirst_hz + kFccStep_hz * i);
  }
  for (std::size_t i = channels_hz.size() - 1; i > 0; --i) {
    std::swap(channels_hz[i], channels_hz[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  return channels_hz;
}

}  // namespace

std::vector<AntennaDescription> pair_of_antennas() {
  return {{.at_m = {0.0, 0.08, 0.1}}, {.at_m = {0.0, -0.08, 0.1}}};
}

std::vector<AntennaDescription> roof_of_antennas() {
  constexpr double kElevation_rad = robot::rad_from_deg(40.0);
  constexpr double kBeside_m = 0.07;  // two plates of 0.13 m side by side
  constexpr double kAhead_m = 0.06;   // their lower edge is then 0.10 m from the middle
  constexpr double kHigh_m = 0.16;    // and just above the robot's 0.09 m
  std::vector<AntennaDescription> antennas;
  for (const double ahead : {1.0, -1.0}) {
    for (const double left : {1.0, -1.0}) {
      antennas.push_back({.at_m = {ahead * kAhead_m, left * kBeside_m, kHigh_m},
                          .boresight = {ahead * std::cos(kElevation_rad), 0.0, std::sin(kElevation_rad)}});
    }
  }
  return antennas;
}

RadioDescription paper_radio() {
  return {};
}

std::vector<double> measured_slots_s(std::size_t antennas) {
  assert(antennas > 0);
  constexpr std::array<double, 3> kSlots_s = {0.0289, 0.0293, 0.0310};
  std::vector<double> slots_s;
  for (std::size_t i = 0; i + 1 < antennas; ++i) {
    slots_s.push_back(kSlots_s[i % kSlots_s.size()]);
  }
  slots_s.push_back(0.01402);
  return slots_s;
}

RadioDescription impinj_r420_radio(robot::RandomStream random, std::size_t antennas) {
  RadioDescription radio;
  radio.profile = "impinj_r420";
  radio.path = PathKind::kMonostatic;
  radio.channels_hz = shuffled_fcc_channels_hz(random);  // 3.1: index is a position in the reader's own table
  radio.dwell_s = 0.20335;                               // 3.8, mean
  radio.hop_dead_s = 0.006;                              // 3.8
  radio.simultaneous = false;
  radio.slots_s = measured_slots_s(antennas);
  // Logs of Test8: from port 1 to port 3, with port 2 silent, 70.1 to 71.3 ms at four spots, less 28.9 ms.
  // One antenna alone misses reads in steps of its slot (3.8).
  radio.silent_slot_s = antennas > 1 ? 0.0416 : 0.0;
  radio.per_tag_s = 0.0007;  // 3.8: 0.6 to 1.1 ms
  radio.noise_law = NoiseLaw::kRssi;
  radio.noise_per_m_rad = 0.0;        // 3.5: no distance effect left once RSSI is in the law
  radio.noise_floor_rad = 0.0078;     // 3.5, Tests 12-15, 117 files
  radio.noise_at_50dbm_rad = 0.0155;  // 3.5, the same
  radio.phase_sign = -1.0;            // 3.2
  radio.phase_steps = 1024;           // 3.3: 4 of 4096
  radio.drift_sigma_rad = 0.01;       // 4: fixed tags
  radio.drift_time_s = 2.0;           // 4: 1 to 5 s
  radio.place_sigma_rad = 0.3;        // 3.11
  radio.place_length_m = 0.08;        // 4: a quarter of the wavelength
  // Leaves a coherence of 0.995 with a straight line across the band, which is what 3.1 measured. The delay
  // read off the slope then scatters by 2.6 ns; 3.4 found 5.5 to 9.3 ns in a room with people.
  radio.place_delay_s = 18e-9;
  radio.pi_flips = true;         // 3.7
  radio.rssi_at_1m_dbm = -35.0;  // 3.6, 9 dBic
  radio.rssi_slope_db = -22.2;   // 3.6, Test13: ceiling antennas, tag on the axis
  // 3.6: 3.5 dB from place to place in all, of which the mean over the channels of what follows makes 1.5.
  radio.place_sigma_db = 3.2;
  // 3.3: 0.4 to 3.1 dB between the channels of one place; 2 dB with 30 ns give 1.35 dB within the band, and
  // fades some 8 MHz wide as in 3.8 (17 of 50 channels lost, in one block).
  radio.channel_sigma_db = 2.0;
  radio.channel_delay_s = 30e-9;
  radio.rssi_sigma_db = 0.4;        // 3.3: 0.15 to 0.65
  radio.rssi_step_db = 0.5;         // 3.3, Impinj's own RSSI
  radio.cutoff_dbm = -70.0;         // 3.6
  radio.doppler_bias_hz = 9.75;     // 3.10: 117 to 195 sixteenths
  radio.doppler_floor_hz = 6.6;     // 3.10, at -35 dBm
  radio.doppler_at_50dbm_hz = 8.8;  // 3.10: 17 Hz at -55 and 40 Hz at -63 dBm are both on this curve
  return radio;
}

}  // namespace sensotwin::world
