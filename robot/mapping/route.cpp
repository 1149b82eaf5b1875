// SPDX-License-Identifier: MIT
#include "robot/mapping/route.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace sensotwin::robot {
namespace {

constexpr int kFar = std::numeric_limits<int>::max();

bool drivable(const TileMap& map, Tile tile, Direction side) {
  return map.visited(neighbour(tile, side)) && map.passage(tile, side) != Passage::kBlocked;
}

/// Breadth-first waves from the goals outwards; for each tile and heading also the fewest turns to the end.
class Waves {
 public:
  Waves(const TileMap& map, const std::vector<Tile>& goals)
      : map_(map), distance_(map.visited_bounds(), kFar), turns_(map.visited_bounds(), {}) {
    for (const Tile goal : goals) {
      if (map.visited(goal) && distance_.at(goal) != 0) {
        distance_.ref(goal) = 0;
        queue_.push_back(goal);
      }
    }
  }

  void spread_to(Tile from) {
    // Every tile of a wave is taken from the queue before those of the next, so the neighbours one step
    // nearer to the goal have their turns when they are asked for.
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Tile tile = queue_[i];
      const int here = distance_.at(tile);
      if (here > 0) count_turns(tile, here);
      if (tile == from) return;
      for (const Direction side : kDirections) {
        const Tile next = neighbour(tile, side);
        if (drivable(map_, tile, side) && distance_.at(next) == kFar) {
          distance_.ref(next) = here + 1;
          queue_.push_back(next);
        }
      }
    }
  }

  [[nodiscard]] std::vector<Tile> walk(Tile from, Direction heading) const {
    std::vector<Tile> route;
    int here = distance_.at(from);
    if (here == kFar) return route;
    for (; here > 0; --here) {
      heading = best_side(from, here, heading).first;
      from = neighbour(from, heading);
      route.push_back(from);
    }
    return route;
  }

 private:
  /// The side to leave by, and the quarter turns from there on.
  [[nodiscard]] std::pair<Direction, int> best_side(Tile tile, int here, Direction heading) const {
    std::pair<Direction, int> best{heading, kFar};
    for (const int left : {0, 1, 3, 2}) {
      const Direction side = turned(heading, left);
      const Tile next = neighbour(tile, side);
      if (!drivable(map_, tile, side) || distance_.at(next) != here - 1) continue;
      const int turns = quarter_turns(heading, side) + turns_.at(next)[static_cast<std::size_t>(side)];
      if (turns < best.second) best = {side, turns};
    }
    return best;
  }
  void count_turns(Tile tile, int here) {
    for (const Direction heading : kDirections) {
      turns_.ref(tile)[static_cast<std::size_t>(heading)] = best_side(tile, here, heading).second;
    }
  }

  const TileMap& map_;
  TileGrid<int> distance_;
  TileGrid<std::array<int, 4>> turns_;
  std::vector<Tile> queue_;
};

}  // namespace

std::vector<Tile> shortest_route(const TileMap& map, Tile from, Direction heading,
                                 const std::vector<Tile>& goals) {
  Waves waves{map, goals};
  waves.spread_to(from);
  return waves.walk(from, heading);
}

std::vector<Tile> grey_tiles(const TileMap& map) {
  std::vector<Tile> grey;
  for (const auto& [tile, tag] : map.tiles()) {
    if (map.color(tile) == TileColor::kGrey) grey.push_back(tile);
  }
  return grey;
}

}  // namespace sensotwin::robot
