// SPDX-License-Identifier: MIT
#include "robot/mapping/dfm.hpp"

namespace sensotwin::robot {

std::optional<Move> Dfm::do_next(const TileMap& map, Tile at, Direction heading) {
  first_visits_ = static_cast<int>(map.visited_count());
  if (const auto step = way_.next(map, at, heading)) return Move{*step};
  push(map, at);
  for (const int left : {0, 1, 3, 2}) {
    const Direction side = turned(heading, left);
    if (map.untried(at, side)) return Move{neighbour(at, side)};
  }
  return backtrack(map, at, heading);
}

void Dfm::push(const TileMap& map, Tile at) {
  if (!started_) {
    // Continuing a map that another run began: its grey tags are what that run's stack still held.
    stack_ = grey_tiles(map);
    started_ = true;
  }
  if (stack_.empty() || stack_.back() != at) stack_.push_back(at);
}

std::optional<Move> Dfm::backtrack(const TileMap& map, Tile at, Direction heading) {
  while (!stack_.empty()) {
    const Tile tag = stack_.back();
    const bool worth_driving =
        backtracking_ == Backtracking::kRetraceAll || map.color(tag) == TileColor::kGrey;
    if (worth_driving && way_.plan(map, at, heading, {tag})) {
      ++backtracks_;
      const auto step = way_.next(map, at, heading);
      return Move{*step};
    }
    stack_.pop_back();  // the tag under the robot, an explored tag, or one that no known way leads to
  }
  return std::nullopt;
}

}  // namespace sensotwin::robot
