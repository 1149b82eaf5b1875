// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "robot/mapping/route.hpp"

namespace sensotwin::robot {

/// A drive over visited tiles that takes several moves: remembers where it leads and yields one tile at a
/// time.
class WayBack {
 public:
  /// Plans the shortest way to the nearest of `goals`. \returns false when there is none or `at` is a goal.
  bool plan(const TileMap& map, Tile at, Direction heading, const std::vector<Tile>& goals) {
    goals_ = goals;
    route_ = shortest_route(map, at, heading, goals_);
    steps_done_ = 0;
    return !route_.empty();
  }
  /// The next tile of the way, or nothing once it is driven. Plans anew when a move failed or the robot was
  /// carried off.
  [[nodiscard]] std::optional<Tile> next(const TileMap& map, Tile at, Direction heading) {
    if (route_.empty()) return std::nullopt;
    const bool as_planned = steps_done_ == 0 || route_[steps_done_ - 1] == at;
    if (!as_planned && !plan(map, at, heading, goals_)) return std::nullopt;
    if (steps_done_ == route_.size()) {
      route_.clear();
      return std::nullopt;
    }
    return route_[steps_done_++];
  }

 private:
  std::vector<Tile> goals_;
  std::vector<Tile> route_;
  std::size_t steps_done_{0};
};

}  // namespace sensotwin::robot
