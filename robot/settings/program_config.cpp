// SPDX-License-Identifier: MIT
#include "robot/settings/program_config.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace sensotwin::robot {
namespace {

double metres_per_count(const BaseSettings& base) {
  return kPi * base.wheel_diameter_m / base.counts_per_turn;
}

FuzzyMissionConfig fuzzy_of(const RobotSettings& settings) {
  const PhaseMission& mission = *settings.mission.phase;
  const UhfReaderSettings& reader = settings.uhf_reader;
  FuzzyMissionConfig config;
  for (const std::size_t tag : destinations_of(settings)) {
    config.destinations.push_back(settings.ceiling_tags[tag].epc);
  }
  config.sets = mission.sets;
  config.speed_mps = mission.speed_mps;
  config.wheel_base_m = settings.base.wheel_base_m;
  config.metres_per_count = metres_per_count(settings.base);
  config.wheel_ratio = settings.base.wheel_ratio;
  config.top_wheel_mps = settings.base.speed_max_mps;
  const std::size_t left = reader.antennas[0].at_R_m.y() >= reader.antennas[1].at_R_m.y() ? 0 : 1;
  config.pairing = {.pairing = mission.pairing,
                    .left_port = static_cast<std::uint16_t>(left + 1),
                    .right_port = static_cast<std::uint16_t>(2 - left),
                    .phase_sign = reader.phase_sign,
                    .pi_ambiguous = reader.pi_ambiguous,
                    .left_delay_s = reader.antennas[left].cable_delay_s,
                    .right_delay_s = reader.antennas[1 - left].cable_delay_s};
  return config;
}

}  // namespace

WheelModel wheels_of(const BaseSettings& base) {
  WheelModel wheels;
  wheels.wheel_base_m = base.wheel_base_m;
  wheels.metres_per_count = metres_per_count(base);
  wheels.wheel_ratio = base.wheel_ratio;
  return wheels;
}

PhaseReaderModel reader_model_of(const UhfReaderSettings& reader) {
  PhaseReaderModel model;
  model.antennas = reader.antennas;
  model.monostatic = reader.monostatic;
  model.transmitter_R_m = {0.0, 0.0, reader.antennas.front().at_R_m.z()};
  model.phase_sign = reader.phase_sign;
  model.pi_ambiguous = reader.pi_ambiguous;
  model.centre_hz = reader.centre_hz;
  model.noise = reader.noise;
  return model;
}

RoombaConfig base_config_of(const BaseSettings& base) {
  RoombaConfig config;
  // Seen at the next step, so the wheels stand within 90 ms of the last frame and what the stop takes on the
  // line. Chosen: four frames lost in a row are forgiven.
  config.stream_timeout = std::chrono::milliseconds{75};
  if (base.firmware == BaseFirmware::kWifi) {
    config.mode_report_offset = 1;
  }
  if (base.kind == BaseKind::kRoomba400) {
    config.interface = RoombaConfig::Interface::kSci;
    config.sci_wheel_base_m = base.wheel_base_m;
  }
  return config;
}

TagReaderConfig card_config_of(const CardReaderSettings& reader) {
  TagReaderConfig config;
  config.uid_order = reader.uid_order;
  config.exchange_limit = from_s(reader.exchange_limit_s);
  config.blocks_per_command = static_cast<std::uint8_t>(reader.blocks_per_command);
  return config;
}

UhfReaderConfig uhf_config_of(const UhfReaderSettings& reader) {
  UhfReaderConfig config;
  config.antennas.resize(reader.antennas.size());
  std::iota(config.antennas.begin(), config.antennas.end(), std::uint16_t{1});
  config.report_every = static_cast<std::uint16_t>(reader.report_every);
  return config;
}

MappingProgramConfig mapping_config_of(const RobotSettings& settings) {
  const MapMission& mission = *settings.mission.map;
  MappingProgramConfig config;
  config.map_id = settings.map_id;
  config.mapping.tile_m = settings.tile_m;
  config.mapping.pace = {.speed_mps = mission.pace.speed_mps,
                         .turn_radps = mission.pace.turn_radps,
                         .tile_s = mission.pace.tile_s,
                         .tag_s = mission.pace.tag_s};
  config.mapping.odometry.wheel_base_m = settings.base.wheel_base_m;
  config.mapping.odometry.metres_per_count = metres_per_count(settings.base);
  config.mapping.odometry.wheel_ratio = settings.base.wheel_ratio;
  config.mapping.body_radius_m = settings.base.radius_m;
  config.mapping.light_bumper.shell_radius_m = settings.base.radius_m;
  config.mapping.read_radius_m = settings.floor_reader.read_radius_m;
  config.mapping.rim_delay_s = settings.floor_reader.notice_delay_s;
  config.mapping.rim_sigma_m =
      std::hypot(config.mapping.rim_sigma_m, settings.floor_reader.notice_sigma_s * mission.pace.speed_mps);
  config.base = base_config_of(settings.base);
  config.reader = card_config_of(settings.floor_reader);
  return config;
}

MoveCost move_cost_of(const RobotSettings& settings) {
  const PaceSection& pace = settings.mission.map->pace;
  if (pace.tile_s > 0.0) {
    return {.tile_s = pace.tile_s, .quarter_turn_s = 0.0};
  }
  // A turn costs its angle, the ramps of turning, and the stop before it and the start after it.
  const MappingConfig drive;
  const double ramps_s =
      pace.speed_mps / drive.acceleration_mps2 + pace.turn_radps / drive.turn_acceleration_radps2;
  return {.tile_s = settings.tile_m / pace.speed_mps,
          .quarter_turn_s = kPi / 2.0 / pace.turn_radps + ramps_s};
}

std::vector<std::size_t> destinations_of(const RobotSettings& settings) {
  const std::vector<KnownTag>& tags = settings.ceiling_tags;
  std::vector<std::size_t> order;
  for (const std::string& name : settings.mission.phase->destinations) {
    const auto found =
        std::find_if(tags.begin(), tags.end(), [&](const KnownTag& tag) { return tag.name == name; });
    order.push_back(static_cast<std::size_t>(found - tags.begin()));
  }
  if (order.empty()) {
    order.resize(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  return order;
}

CeilingMissionConfig ceiling_config_of(const RobotSettings& settings) {
  const PhaseMission& mission = *settings.mission.phase;
  CeilingMissionConfig config;
  config.estimator.reader = reader_model_of(settings.uhf_reader);
  config.estimator.wheels = wheels_of(settings.base);
  config.estimator.echo_caution = settings.uhf_reader.echo_caution;
  config.estimator.floor_radius_m = settings.floor_tag_radius_m;
  config.follower.speed_mps = mission.speed_mps;
  config.follower.stop_at_corners = mission.slow_corners;
  config.follower.wheel_base_m = settings.base.wheel_base_m;
  config.follower.top_wheel_mps = settings.base.speed_max_mps;
  for (const std::size_t tag : destinations_of(settings)) {
    const KnownTag& known = settings.ceiling_tags[tag];
    config.route.push_back({.epc = known.epc, .height_m = known.height_m});
  }
  config.path = static_cast<TagPathKind>(mission.path);
  config.circle_radius_m = mission.circle_radius_m;
  config.circle_laps = mission.circle_laps;
  config.faults.on_missing = static_cast<OnTagFault>(mission.on_missing);
  config.faults.order_factor = mission.order_factor;
  config.faults.on_order = static_cast<OnTagFault>(mission.on_order);
  config.faults.corridor_half_width_m = mission.corridor_half_width_m;
  return config;
}

PhaseProgramConfig phase_config_of(const RobotSettings& settings) {
  PhaseProgramConfig config;
  config.base = base_config_of(settings.base);
  config.wheels = wheels_of(settings.base);
  config.uhf_reader = uhf_config_of(settings.uhf_reader);
  config.floor_reader = card_config_of(settings.floor_reader);
  if (settings.mission.phase->controller == PhaseController::kFuzzy) {
    config.mission = fuzzy_of(settings);
  } else {
    config.mission = ceiling_config_of(settings);
  }
  return config;
}

HallwayProgramConfig hallway_config_of(const RobotSettings& settings) {
  const HallwaySection& mission = *settings.mission.hallway;
  const HallwayFile& hallways = settings.hallways;
  HallwayProgramConfig config;
  config.base = base_config_of(settings.base);
  config.floor_reader = card_config_of(settings.floor_reader);
  HallwayConfig robot;
  robot.wheel_base_m = settings.base.wheel_base_m;
  robot.metres_per_count = metres_per_count(settings.base);
  robot.wheel_ratio = settings.base.wheel_ratio;
  robot.radius_m = settings.base.radius_m;
  robot.plan_north_rad = hallways.north_rad;
  robot.hallway_width_m = hallways.width_m;
  robot.tag_to_middle_m = hallways.tag_to_middle_m;
  robot.tag_reach_m = hallways.tag_reach_m;
  robot.speed_mps = mission.speed_mps;
  robot.follow = mission.follow;
  robot.wall_m = mission.wall_m;
  if (mission.survey) {
    config.mission = HallwaySurveyConfig{.robot = robot};
    return config;
  }
  config.mission = HallwayMissionConfig{.robot = robot,
                                        .map = hallways.map,
                                        .start = hallways.map.find(mission.from),
                                        .goal = hallways.map.find(mission.to).value_or(0)};
  return config;
}

}  // namespace sensotwin::robot
