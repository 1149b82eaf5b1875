// SPDX-License-Identifier: MIT
#include "robot/program/hallway_program.hpp"

#include <algorithm>

namespace sensotwin::robot {

HallwayProgram::HallwayProgram(const HallwayLinks& links, const HallwayProgramConfig& config)
    : base_(links.base, config.base),
      floor_reader_(links.floor_reader, config.floor_reader),
      sensor_board_(links.sensors),
      mode_keeper_(config.base.mode) {
  if (const auto* mission = std::get_if<HallwayMissionConfig>(&config.mission)) {
    mission_.emplace(*mission);
  } else {
    survey_.emplace(std::get<HallwaySurveyConfig>(config.mission));
  }
}

void HallwayProgram::step(Instant now) {
  base_.step(now);
  floor_reader_.step(now);
  sensor_board_.step(now);
  gather_tags();
  if (const RoombaState* state = base_.fresh()) {
    state_ = *state;
  }
  if (state_) {
    mode_keeper_.step(base_, *state_);
  }
  if (const RoombaState* state = base_.fresh()) {
    sense(*state);
    wheels_ = (mission_ ? mission_->step(sensed_) : survey_->step(sensed_)).wheels;
    sensed_ = {};
    // Refused while the robot is not ready; it stands then, and the encoders tell the mission so.
    (void)base_.drive(wheels_);
  }
}

void HallwayProgram::gather_tags() {
  while (const auto event = floor_reader_.next_event()) {
    if (const auto* identified = std::get_if<TagIdentified>(&*event)) {
      sensed_.tag = identified->uid;
    }
  }
}

void HallwayProgram::sense(const RoombaState& state) {
  base_sensing_.take(state, sensor_board_, sensed_);
  if (const auto& round = sensor_board_.sonars(); round && round->stamp > sonar_stamp_) {
    sonar_stamp_ = round->stamp;
    SonarRanges ranges;
    std::copy_n(round->range_m.begin(), ranges.size(), ranges.begin());
    sensed_.ranges_m = ranges;
  }
}

}  // namespace sensotwin::robot
