// SPDX-License-Identifier: MIT
#include "robot/mapping/bfm.hpp"

#include <algorithm>

namespace sensotwin::robot {

std::optional<Move> Bfm::do_next(const TileMap& map, Tile at, Direction heading) {
  list_as_unexplored(map, at);
  if (const auto step = way_.next(map, at, heading)) return Move{*step};
  while (!unexplored_.empty()) {
    const Tile t = unexplored_.front();
    const auto move = reading_ == BfmReading::kLazy ? explore_directly(map, t, at, heading)
                                                    : explore_out_and_back(map, t, at, heading);
    if (move) return move;
    unexplored_.pop_front();  // tag t has now been explored
    sides_done_ = 0;
  }
  return std::nullopt;
}

void Bfm::list_as_unexplored(const TileMap& map, Tile at) {
  first_visits_ = static_cast<int>(map.visited_count());
  if (listed_.at(at)) return;
  if (unexplored_.empty()) {
    // A start, or the continuation of a map that another run began: its grey tags are the unexplored ones.
    for (const Tile grey : grey_tiles(map)) {
      if (grey == at || listed_.at(grey)) continue;
      listed_.ref(grey) = true;
      unexplored_.push_back(grey);
    }
  }
  listed_.ref(at) = true;
  unexplored_.push_back(at);
}

bool Bfm::wanted(const TileMap& map, Tile t, Direction side) const {
  if (reading_ != BfmReading::kAllNeighbours) return map.untried(t, side);
  return map.passage(t, side) != Passage::kBlocked && !map.unreachable(neighbour(t, side));
}

std::optional<Move> Bfm::explore_directly(const TileMap& map, Tile t, Tile at, Direction heading) {
  for (const Direction side : kDirections) {
    if (!map.untried(t, side)) continue;
    const Tile unvisited = neighbour(t, side);
    std::vector<Tile> doors;  // visited tags from which it can be tried
    for (const Direction back : kDirections) {
      const Tile door = neighbour(unvisited, back);
      if (map.visited(door) && map.untried(door, opposite(back))) doors.push_back(door);
    }
    if (std::find(doors.begin(), doors.end(), at) != doors.end()) return Move{unvisited};
    if (const auto move = drive_to(map, at, heading, doors)) return move;
  }
  return std::nullopt;
}

std::optional<Move> Bfm::explore_out_and_back(const TileMap& map, Tile t, Tile at, Direction heading) {
  for (unsigned done = sides_done_; done < kDirections.size(); ++done) {
    const Direction side = kDirections[done];
    if (!wanted(map, t, side)) continue;
    if (at != t) return drive_to(map, at, heading, {t});
    sides_done_ = done + 1;
    return Move{neighbour(t, side)};
  }
  if (sides_done_ > 0 && at != t) return drive_to(map, at, heading, {t});
  return std::nullopt;
}

std::optional<Move> Bfm::drive_to(const TileMap& map, Tile at, Direction heading,
                                  const std::vector<Tile>& goals) {
  if (!way_.plan(map, at, heading, goals)) return std::nullopt;
  ++backtracks_;
  const auto step = way_.next(map, at, heading);
  return Move{*step};
}

}  // namespace sensotwin::robot
