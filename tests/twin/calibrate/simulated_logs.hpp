// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin/calibrate/calibration.hpp"
#include "twin/output/tag_log.hpp"
#include "world/radio/profiles.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::twin {

/// What the twin's reader logs of a world whose robot stands still at the origin, written and read back.
inline TagLog simulated_log(const world::RadioWorld& world, double seconds, const std::string& name) {
  const TemporaryFolder folder;
  const auto file = folder.path() / (name + ".csv");
  TagLogWriter writer{robot::OutputFile{file}};
  world::Radio radio(world, robot::RandomStream{11}.fork(name));
  for (const world::RadioRead& read : radio.step({.begin_s = 0.0, .end_s = seconds})) {
    writer.add({.time_s = read.time_s,
                .epc = world.tags[read.tag].epc,
                .antenna = static_cast<std::uint16_t>(read.antenna + 1),
                .channel = static_cast<std::uint16_t>(read.channel + 1),
                .phase_rad = read.phase_rad,
                .rssi_dbm = read.rssi_dbm,
                .doppler_hz = read.doppler_hz});
  }
  writer.finish();
  return read_sllurp_log(file);
}

inline constexpr double kCable_s = 60e-9;

/// One antenna below one tag, so far from it.
inline world::RadioWorld tag_above(const world::RadioDescription& radio, double distance_m) {
  world::RadioWorld world{.radio = radio};
  world.tags.push_back({.name = "tag", .height_m = 0.1 + distance_m});
  world.tags[0].epc.bytes = {0x30, 0x34, 0x35, 0xfc, 0x88, 0x03, 0xd0, 0x56, 0xd1, 0x5b, 0x96, 0x3f};
  world.antennas.push_back(
      {.at_m = {0.0, 0.0, 0.1}, .gain_dbi = world::kReferenceGain_dbi, .cable_delay_s = kCable_s});
  return world;
}

/// A series of logs as the data study's Test13: the tag on the antenna's axis, farther and farther away.
struct Series {
  CalibrationInput input;
  world::RadioDescription radio;
};
inline Series series_of(world::RadioDescription radio, const std::vector<double>& distances_m,
                        double seconds) {
  Series series{.input = {}, .radio = radio};
  for (const double distance_m : distances_m) {
    series.input.logs.push_back(
        simulated_log(tag_above(radio, distance_m), seconds, std::to_string(distance_m)));
    series.input.distance_m.emplace_back(distance_m);
  }
  return series;
}

/// The real reader without what bends lines and hides laws: echoes and fading.
inline world::RadioDescription plain_r420() {
  world::RadioDescription radio = world::impinj_r420_radio(robot::RandomStream{5}, 1);
  radio.place_sigma_rad = 0.0;
  radio.place_sigma_db = 0.0;
  radio.channel_sigma_db = 0.0;
  return radio;
}

inline std::optional<Calibration> calibrated(const CalibrationInput& input,
                                             CalibrationSettings settings = {}) {
  settings.resamples = 60;
  return calibrate(input, settings, [] { return true; });
}

}  // namespace sensotwin::twin
