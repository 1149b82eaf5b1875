// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <span>
#include <utility>

#include "world/description.hpp"

namespace sensotwin::world {

struct FreeSpaceSettings {
  /// Spacing of the grid on which free space is explored. Chosen: an eighth of the default read radius.
  double cell_m{0.01};
  /// Room the disc must have beyond its own radius, so that what is called reachable is so for a machine that
  /// cannot steer to the last millimetre. Chosen.
  double margin_m{0.01};
};

/// The tiles a perfect driver could map, as (column, row). Truth for the verdict; the robot never sees it.
///
/// Obstacles are walls and fixed furniture that the robot does not pass beneath; pushable furniture is left
/// out (where it will stand is not known beforehand), and so are cliffs' edges in the middle of a move: a
/// position is free when the disc touches no obstacle and its middle is over no hole. Dead tags are in
/// neither set.
struct ReachableTiles {
  /// Some position of the disc's middle, connected to the start through free positions, brings the floor
  /// antenna within its read radius of the tag. The robot may turn where it stands, so that an antenna off
  /// the middle sweeps a circle.
  std::set<std::pair<int, int>> reachable;
  /// Connected to the start's tile by moves from the middle of a tile straight to the middle of one of its
  /// four neighbours, the swept disc touching no obstacle; no move ends on a dead tag. Empty when the start
  /// is on no tile.
  std::set<std::pair<int, int>> grid_reachable;
};

/// \param carpet_tags_m where the carpet's tags are, in the order of its tiles; empty: in the middle of each
[[nodiscard]] ReachableTiles reachable_tiles(const WorldDescription& world, const RobotDescription& robot,
                                             const FreeSpaceSettings& settings = {},
                                             std::span<const Vec2> carpet_tags_m = {});

}  // namespace sensotwin::world
