// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/settings/hallway_file.hpp"
#include "twin/scene/map_import.hpp"
#include "twin/scene/scene.hpp"
#include "world/description.hpp"

namespace sensotwin::twin {

/// The floor of a building that is nothing but the hallways of a map: a strip of their width between any two
/// places that are connected, half a width beyond both, slanted hallways with round ends; and of doorways and
/// rooms beside them. Walls are where it ends. \pre each place has a position
[[nodiscard]] OccupancyMap floor_of(const robot::HallwayFile& hallways,
                                    const std::vector<FloorPiece>& rooms = {});

/// Where the tags of a hallway map lie: on the side that they are met on, in the middle of the hallway. W is
/// the plan turned so that its north is +y. \pre each place with a tag has a position
[[nodiscard]] std::vector<world::HallwayTag> tags_of(const robot::HallwayFile& hallways);

}  // namespace sensotwin::twin
