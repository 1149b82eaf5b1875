// SPDX-License-Identifier: MIT
#include "robot/mapping/spiral.hpp"

namespace sensotwin::robot {

std::optional<Move> Spiral::do_next(const TileMap& map, Tile at, Direction heading) {
  first_visits_ = static_cast<int>(map.visited_count());
  if (const auto step = way_.next(map, at, heading)) return Move{*step};
  for (const int left : {3, 0, 1, 2}) {
    const Direction side = turned(heading, left);
    if (map.untried(at, side)) return Move{neighbour(at, side)};
  }
  if (!way_.plan(map, at, heading, grey_tiles(map))) return std::nullopt;
  ++backtracks_;
  const auto step = way_.next(map, at, heading);
  return Move{*step};
}

}  // namespace sensotwin::robot
