// SPDX-License-Identifier: MIT
#include "twin/run/phase_config.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "robot/settings/program_config.hpp"
#include "twin/run/machine.hpp"
#include "world/radio/profiles.hpp"

namespace sensotwin::twin {
namespace {

/// Measured with three echoes of a tenth on the line (twin validate, 200 seeds, 2026-11-22): 1, 1.5, 2
/// and 2.6 leave 3.9, 3.6, 3.5 and 3.4 cm in the root mean square, and the robot stops for longer with more.
constexpr double kImageCaution = 1.5;

/// What the robot is told of a tag's code.
robot::Epc told_code(const Scene& scene, std::size_t tag) {
  const std::vector<world::CeilingTag>& tags = scene.world.radio->tags;
  const std::vector<std::string>& exchanged = scene.mission.phase->exchanged;
  const auto self = std::find(exchanged.begin(), exchanged.end(), tags[tag].name);
  if (exchanged.size() != 2 || self == exchanged.end()) {
    return tags[tag].epc;
  }
  const std::string& other = self == exchanged.begin() ? exchanged.back() : exchanged.front();
  return std::find_if(tags.begin(), tags.end(), [&](const auto& t) { return t.name == other; })->epc;
}

robot::UhfReaderSettings reader_of(const world::RadioWorld& world) {
  const world::RadioDescription& radio = world.radio;
  robot::UhfReaderSettings model;
  model.antennas.clear();
  for (const world::AntennaDescription& antenna : world.antennas) {
    model.antennas.push_back({.at_R_m = antenna.at_m, .cable_delay_s = antenna.cable_delay_s});
  }
  model.monostatic = radio.path == world::PathKind::kMonostatic;
  model.phase_sign = radio.phase_sign;
  model.pi_ambiguous = radio.pi_ambiguous;
  model.centre_hz = std::accumulate(radio.channels_hz.begin(), radio.channels_hz.end(), 0.0) /
                    static_cast<double>(radio.channels_hz.size());
  model.noise.floor_rad = radio.noise_law == world::NoiseLaw::kProportional ? 0.0 : radio.noise_floor_rad;
  model.noise.per_m_rad = radio.noise_law == world::NoiseLaw::kRssi ? 0.0 : radio.noise_per_m_rad;
  model.noise.at_50dbm_rad = radio.noise_law == world::NoiseLaw::kRssi ? radio.noise_at_50dbm_rad : 0.0;
  // An echo of amplitude a turns the phase of one way by a sin(x): a / sqrt(2) in the mean square. Out and
  // back come together: the same echo twice, or two of two places.
  const double ways = model.monostatic ? 2.0 : std::sqrt(2.0);
  const double images_rad = ways * radio.image_amplitude * std::sqrt(radio.images / 2.0);
  model.noise.echo_rad = std::hypot(radio.place_sigma_rad, images_rad);
  if (radio.place_length_m > 0.0 && radio.place_sigma_rad > 0.0) {
    model.noise.echo_length_m = radio.place_length_m;
    model.noise.echo_delay_s = radio.place_delay_s;
  }
  model.report_every = radio.report_every;
  model.echo_caution = radio.images > 0 ? kImageCaution : 1.0;
  return model;
}

}  // namespace

std::vector<std::size_t> destinations_of(const Scene& scene) {
  return robot::destinations_of(robot_settings_of(scene, *scene.world.radio));
}

world::RadioWorld radio_of(const Scene& scene, const robot::RandomStream& random) {
  world::RadioWorld radio = *scene.world.radio;
  if (radio.radio.channels_hz.empty()) {
    radio.radio.channels_hz =
        world::impinj_r420_radio(random.fork("hop table"), radio.antennas.size()).channels_hz;
  }
  if (radio.radio.slots_s.empty()) {
    radio.radio.slots_s = world::measured_slots_s(radio.antennas.size());
  }
  if (radio.antennas.size() == 1) {
    radio.radio.silent_slot_s = 0.0;  // of several antennas only
  }
  return radio;
}

robot::RobotSettings robot_settings_of(const Scene& scene, const world::RadioWorld& radio) {
  robot::RobotSettings settings = robot_settings_of(scene);
  settings.uhf_reader = reader_of(radio);
  settings.floor_tag_radius_m = radio.floor_tag_radius_m;
  for (std::size_t i = 0; i < radio.tags.size(); ++i) {
    const world::CeilingTag& tag = radio.tags[i];
    settings.ceiling_tags.push_back({.name = tag.name, .epc = told_code(scene, i), .height_m = tag.height_m});
  }
  return settings;
}

robot::CeilingMissionConfig ceiling_config_of(const Scene& scene, const world::RadioWorld& radio) {
  return robot::ceiling_config_of(robot_settings_of(scene, radio));
}

robot::PhaseProgramConfig phase_config_of(const Scene& scene, const world::RadioWorld& radio) {
  return robot::phase_config_of(robot_settings_of(scene, radio));
}

}  // namespace sensotwin::twin
