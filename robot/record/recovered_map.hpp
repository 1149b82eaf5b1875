// SPDX-License-Identifier: MIT
#pragma once

#include "robot/mapping/mapping_mission.hpp"
#include "robot/output/map_export.hpp"

namespace sensotwin::robot {

/// The floor plan that the robot drew, in its own frame M: free where it drove or mapped a tile, occupied
/// where it felt or saw something, unknown elsewhere. 5 cm a cell, map_server's usual resolution.
[[nodiscard]] OccupancyGrid recovered_grid(const MappingMission& mission, double tile_m);

}  // namespace sensotwin::robot
