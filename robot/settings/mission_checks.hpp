// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/settings/mission.hpp"
#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// A mistake that no field shows by itself.
struct MissionProblem {
  std::string path;  ///< of the key
  std::string what;
  std::string hint;
};

/// \param map  that the mission goes by; a survey needs none
[[nodiscard]] std::vector<MissionProblem> problems_of(const HallwaySection& mission, const HallwayMap& map);

/// \param tags      names of the ceiling tags that the robot is told of
/// \param antennas  of its UHF reader
/// \param tags_at   path of the list of tags, for messages
[[nodiscard]] std::vector<MissionProblem> problems_of(const PhaseMission& mission,
                                                      const std::vector<std::string>& tags,
                                                      std::size_t antennas, const std::string& tags_at);

}  // namespace sensotwin::robot
