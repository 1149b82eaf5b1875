// SPDX-License-Identifier: MIT
#include "robot/settings/robot_program.hpp"

#include "robot/mapping/explorer_kind.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {

RobotProgram::RobotProgram(const RobotLinks& links, const RobotSettings& settings) {
  if (settings.mission.phase) {
    phase_.emplace(PhaseLinks{links.base, links.uhf_reader, links.floor_reader, links.sensors},
                   phase_config_of(settings));
  } else if (settings.mission.hallway) {
    hallway_.emplace(HallwayLinks{links.base, links.floor_reader, links.sensors},
                     hallway_config_of(settings));
  } else {
    mapping_.emplace(MappingLinks{links.base, links.floor_reader, links.forward_reader, links.sensors},
                     mapping_config_of(settings),
                     make_explorer(settings.mission.map->explorer, move_cost_of(settings)));
  }
}

void RobotProgram::step(Instant now) {
  phase_ ? phase_->step(now) : hallway_ ? hallway_->step(now) : mapping_->step(now);
}

void RobotProgram::shut_down() {
  phase_ ? phase_->shut_down() : hallway_ ? hallway_->shut_down() : mapping_->shut_down();
}

bool RobotProgram::done() const {
  return phase_ ? phase_->done() : hallway_ ? hallway_->done() : mapping_->done();
}

const Roomba& RobotProgram::base() const {
  return phase_ ? phase_->base() : hallway_ ? hallway_->base() : mapping_->base();
}

const TagReader& RobotProgram::floor_reader() const {
  return phase_ ? phase_->floor_reader() : hallway_ ? hallway_->floor_reader() : mapping_->floor_reader();
}

const SensorBoard& RobotProgram::sensor_board() const {
  return phase_ ? phase_->sensor_board() : hallway_ ? hallway_->sensor_board() : mapping_->sensor_board();
}

const WheelSpeeds& RobotProgram::wheels() const {
  return phase_ ? phase_->wheels() : hallway_ ? hallway_->wheels() : mapping_->wheels();
}

}  // namespace sensotwin::robot
