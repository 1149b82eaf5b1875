// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// The way to the nearest of `goals` over visited tiles, through passages not known to be blocked: fewest
/// tiles, and of those ways the one with the fewest quarter turns. A passage between two visited tiles that
/// nobody has driven through counts as open; when it turns out blocked, mark it and ask again. \param from
/// where the robot is: visited \param heading  the way it faces \returns the tiles to drive to one after the
/// other, the last of them a goal; empty when no goal can be
///          reached or `from` is one
[[nodiscard]] std::vector<Tile> shortest_route(const TileMap& map, Tile from, Direction heading,
                                               const std::vector<Tile>& goals);

/// Visited tiles with an untried side, in (column, row) order: the grey tiles of the paper.
[[nodiscard]] std::vector<Tile> grey_tiles(const TileMap& map);

}  // namespace sensotwin::robot
