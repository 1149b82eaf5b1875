// SPDX-License-Identifier: MIT
#include "twin/run/phase_config.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "twin/run/machine.hpp"
#include "world/radio/profiles.hpp"

namespace sensotwin::twin {
namespace {

/// Measured with three echoes of a tenth on the line (twin validate, 200 seeds, 2026-11-22): 1, 1.5, 2
/// and 2.6 leave 3.9, 3.6, 3.5 and 3.4 cm in the root mean square, and the robot stops for longer with more.
constexpr double kImageCaution = 1.5;

std::vector<robot::Epc> codes_of(const Scene& scene) {
  std::vector<robot::Epc> codes;
  for (const std::size_t tag : destinations_of(scene)) {
    codes.push_back(scene.world.radio->tags[tag].epc);
  }
  return codes;
}

robot::WheelModel wheels_of(const Scene& scene) {
  robot::WheelModel wheels;
  wheels.wheel_base_m = scene.robot.base.wheel_base_m;
  wheels.metres_per_count = robot::kPi * scene.robot.base.wheel_diameter_m / scene.robot.base.counts_per_turn;
  return wheels;
}

robot::FuzzyMissionConfig fuzzy_of(const Scene& scene, const world::RadioWorld& radio) {
  const PhaseMission& mission = *scene.mission.phase;
  robot::FuzzyMissionConfig config;
  config.destinations = codes_of(scene);
  config.sets = mission.sets;
  config.speed_mps = mission.speed_mps;
  config.wheel_base_m = scene.robot.base.wheel_base_m;
  config.top_wheel_mps = scene.robot.base.speed_max_mps;
  const std::size_t left = radio.antennas[0].at_m.y() >= radio.antennas[1].at_m.y() ? 0 : 1;
  config.pairing = {.pairing = mission.pairing,
                    .left_port = static_cast<std::uint16_t>(left + 1),
                    .right_port = static_cast<std::uint16_t>(2 - left),
                    .phase_sign = radio.radio.phase_sign,
                    .pi_ambiguous = radio.radio.pi_ambiguous,
                    .left_delay_s = radio.antennas[left].cable_delay_s,
                    .right_delay_s = radio.antennas[1 - left].cable_delay_s};
  return config;
}

robot::PhaseReaderModel reader_model_of(const world::RadioWorld& world) {
  const world::RadioDescription& radio = world.radio;
  robot::PhaseReaderModel model;
  for (const world::AntennaDescription& antenna : world.antennas) {
    model.antennas.push_back({.at_R_m = antenna.at_m, .cable_delay_s = antenna.cable_delay_s});
  }
  model.monostatic = radio.path == world::PathKind::kMonostatic;
  model.transmitter_R_m = {0.0, 0.0, world.antennas.front().at_m.z()};
  model.phase_sign = radio.phase_sign;
  model.pi_ambiguous = radio.pi_ambiguous || radio.pi_flips;
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
  }
  return model;
}

}  // namespace

std::vector<std::size_t> destinations_of(const Scene& scene) {
  const std::vector<world::CeilingTag>& tags = scene.world.radio->tags;
  std::vector<std::size_t> order;
  for (const std::string& name : scene.mission.phase->destinations) {
    const auto found = std::find_if(tags.begin(), tags.end(),
                                    [&](const world::CeilingTag& tag) { return tag.name == name; });
    order.push_back(static_cast<std::size_t>(found - tags.begin()));
  }
  if (order.empty()) {
    order.resize(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  return order;
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

robot::CeilingMissionConfig ceiling_config_of(const Scene& scene, const world::RadioWorld& radio) {
  const PhaseMission& mission = *scene.mission.phase;
  robot::CeilingMissionConfig config;
  config.estimator.reader = reader_model_of(radio);
  config.estimator.wheels = wheels_of(scene);
  config.estimator.echo_caution = radio.radio.images > 0 ? kImageCaution : 1.0;
  config.estimator.floor_radius_m = radio.floor_tag_radius_m;
  config.follower.speed_mps = mission.speed_mps;
  config.follower.stop_at_corners = mission.slow_corners;
  config.follower.wheel_base_m = scene.robot.base.wheel_base_m;
  config.follower.top_wheel_mps = scene.robot.base.speed_max_mps;
  for (const std::size_t tag : destinations_of(scene)) {
    config.route.push_back({.epc = radio.tags[tag].epc, .height_m = radio.tags[tag].height_m});
  }
  config.path = static_cast<robot::TagPathKind>(mission.path);
  config.circle_radius_m = mission.circle_radius_m;
  config.circle_laps = mission.circle_laps;
  config.faults.on_missing = static_cast<robot::OnTagFault>(mission.on_missing);
  config.faults.corridor_half_width_m = mission.corridor_half_width_m;
  return config;
}

robot::PhaseProgramConfig phase_config_of(const Scene& scene, const world::RadioWorld& radio) {
  robot::PhaseProgramConfig config;
  config.base = base_config_of(scene);
  config.wheels = wheels_of(scene);
  config.uhf_reader.antennas.resize(radio.antennas.size());
  std::iota(config.uhf_reader.antennas.begin(), config.uhf_reader.antennas.end(), std::uint16_t{1});
  config.uhf_reader.report_every = static_cast<std::uint16_t>(radio.radio.report_every);
  if (scene.mission.phase->controller == PhaseController::kFuzzy) {
    config.mission = fuzzy_of(scene, radio);
  } else {
    config.mission = ceiling_config_of(scene, radio);
  }
  return config;
}

}  // namespace sensotwin::twin
