// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/mapping/mapping_mission.hpp"
#include "twin/output/map_export.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"

namespace sensotwin::twin {

/// The floor plan that the robot drew, in its own frame M: free where it drove or mapped a tile, occupied
/// where it felt or saw something, unknown elsewhere. 5 cm a cell, map_server's usual resolution.
[[nodiscard]] OccupancyGrid recovered_grid(const robot::MappingMission& mission, double tile_m);

/// Where the robot's origin lies on the carpet, by the tag it found first; nothing when it found none. The
/// robot starts square to the tiles within 45 degrees: its nose is +x of M.
[[nodiscard]] std::optional<MapPlacement> placement_of(const Scene& scene, const MappingTwin& twin);

/// The robot's own tile of a tile of the truth.
[[nodiscard]] robot::Tile tile_in_map(const MapPlacement& placement, int column, int row);

}  // namespace sensotwin::twin
