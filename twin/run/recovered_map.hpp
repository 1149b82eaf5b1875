// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/mapping/tile.hpp"
#include "robot/record/recovered_map.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"

namespace sensotwin::twin {

using robot::recovered_grid;

/// Where the robot's origin lies on the carpet, by the tag it found first; nothing when it found none. The
/// robot starts square to the tiles within 45 degrees: its nose is +x of M.
[[nodiscard]] std::optional<MapPlacement> placement_of(const Scene& scene, const MappingTwin& twin);

/// The robot's own tile of a tile of the truth.
[[nodiscard]] robot::Tile tile_in_map(const MapPlacement& placement, int column, int row);

}  // namespace sensotwin::twin
