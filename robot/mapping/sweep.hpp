// SPDX-License-Identifier: MIT
#pragma once

#include "robot/mapping/explorer.hpp"
#include "robot/mapping/sweep_plan.hpp"

namespace sensotwin::robot {

class Sweep : public Explorer {
 public:
  explicit Sweep(const MoveCost& cost = {}) : cost_(cost), planner_(cost) {}

 private:
  std::optional<Move> do_next(const TileMap& map, Tile at, Direction heading) override;
  [[nodiscard]] int do_paper_visits() const override { return first_visits_ + backtracks_; }

  void improve_plan(Tile at, Direction heading);
  [[nodiscard]] std::optional<Move> straight_move(const TileMap& map, Tile at, Direction heading,
                                                  bool doubtful_too);
  [[nodiscard]] std::optional<Move> detour(const TileMap& map, Tile at) const;

  MoveCost cost_;
  SweepField field_;
  SweepPlanner planner_;
  std::vector<Tile> plan_;  ///< tiles still to be driven to, in order
  int first_visits_{0};
  int backtracks_{0};
  bool driving_back_{false};
};

}  // namespace sensotwin::robot
