// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "robot/mapping/mapping_mission.hpp"
#include "robot/mapping/tile_map.hpp"
#include "robot/output/map_export.hpp"
#include "robot/output/run_folder.hpp"

namespace sensotwin::robot {

/// The floor plan that the robot drew, in its own frame M: free where it drove or mapped a tile, occupied
/// where it felt or saw something, unknown elsewhere. 5 cm a cell, map_server's usual resolution.
[[nodiscard]] OccupancyGrid recovered_grid(const MappingMission& mission, double tile_m);

/// The tiles that were mapped, in (column, row) order: "column,row,state,tag", a line each, the tag's unique
/// number in 16 hexadecimal digits; the state is the colour of SensoBot, section IV. What two runs in the
/// same room have in common: unlike the floor plan, it holds nothing that was measured.
[[nodiscard]] std::string tiles_csv(const TileMap& map);

/// map.pgm, map.yaml and tiles.csv. \throws OutputError
void write_recovered_map(RunFolder& folder, const MappingMission& mission, double tile_m);

}  // namespace sensotwin::robot
