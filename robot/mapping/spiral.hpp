// SPDX-License-Identifier: MIT
#pragma once

#include "robot/mapping/explorer.hpp"
#include "robot/mapping/way_back.hpp"

namespace sensotwin::robot {

/// Backtracking spiral: keeps the visited and the blocked to its right, so that it winds inwards, and drives
/// to the nearest grey tag when it is shut in. Source: E. Gonzalez et al., BSA: A Complete Coverage
/// Algorithm, ICRA 2005.
class Spiral : public Explorer {
 private:
  std::optional<Move> do_next(const TileMap& map, Tile at, Direction heading) override;
  [[nodiscard]] int do_paper_visits() const override { return first_visits_ + backtracks_; }

  WayBack way_;
  int first_visits_{0};
  int backtracks_{0};
};

}  // namespace sensotwin::robot
