// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/mapping/move_cost.hpp"
#include "robot/program/hallway_program.hpp"
#include "robot/program/mapping_program.hpp"
#include "robot/program/phase_program.hpp"
#include "robot/settings/robot_settings.hpp"

/// Settings made into what the programs take: the one place where it is done, for the machine and for the
/// twin.
namespace sensotwin::robot {

/// How the base is spoken to.
[[nodiscard]] RoombaConfig base_config_of(const BaseSettings& base);
[[nodiscard]] TagReaderConfig card_config_of(const CardReaderSettings& reader);
[[nodiscard]] UhfReaderConfig uhf_config_of(const UhfReaderSettings& reader);

/// What missions along ceiling tags believe of the wheels.
[[nodiscard]] WheelModel wheels_of(const BaseSettings& base);
[[nodiscard]] PhaseReaderModel reader_model_of(const UhfReaderSettings& reader);

/// \pre settings.mission.map
[[nodiscard]] MappingProgramConfig mapping_config_of(const RobotSettings& settings);
/// What the mission's explorer reckons with. \pre settings.mission.map
[[nodiscard]] MoveCost move_cost_of(const RobotSettings& settings);

/// \pre settings.mission.hallway; the places that it names are on the map
[[nodiscard]] HallwayProgramConfig hallway_config_of(const RobotSettings& settings);

/// Indices into the ceiling tags, in the order in which the mission goes to them. \pre settings.mission.phase
[[nodiscard]] std::vector<std::size_t> destinations_of(const RobotSettings& settings);
/// What our own controller is told, whichever controller the mission has. \pre settings.mission.phase
[[nodiscard]] CeilingMissionConfig ceiling_config_of(const RobotSettings& settings);
/// \pre settings.mission.phase
[[nodiscard]] PhaseProgramConfig phase_config_of(const RobotSettings& settings);

}  // namespace sensotwin::robot
