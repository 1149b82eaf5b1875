// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "robot/mapping/move_cost.hpp"
#include "robot/mapping/sweep_field.hpp"

namespace sensotwin::robot {

/// A rule for the next cell: the wanted neighbour with the smallest sum. Where no neighbour is wanted, the
/// nearest wanted cell.
struct SweepRule {
  double per_wanted_neighbour{
      0.0};  ///< of the candidate: few of them means that it would be left behind (Warnsdorff)
  double not_straight{0.0};
  double right{0.0};
  double left{0.0};
  double splits{0.0};  ///< visiting the candidate would part the wanted cells around it
};

/// A drive through the field that visits all wanted cells that can be reached.
struct SweepPlan {
  double cost_s{std::numeric_limits<double>::infinity()};
  std::vector<SweepField::Cell> steps;  ///< cells driven to one after the other
};

/// Makes complete plans by trying things out in a field.
class SweepPlanner {
 public:
  using Cell = SweepField::Cell;

  explicit SweepPlanner(const MoveCost& cost) : cost_(cost) {}

  /// Everything that follows happens in `field` (kept by reference until the next call), starting from `at`.
  void set_out(const SweepField& field, Cell at, int heading);

  /// Follows `rule` to the end, the first step being through `first_side` unless that is negative.
  /// \param give_up_s  once the plan costs as much it is given up: the result has no steps
  [[nodiscard]] SweepPlan follow(const SweepRule& rule, int first_side, double give_up_s);
  /// Visits `order` in turn, leaving out what cannot be reached or is visited by the way, then follows
  /// `rule`.
  [[nodiscard]] SweepPlan repair(const std::vector<Cell>& order, const SweepRule& rule, double give_up_s);

 private:
  void restart();
  void drive(int side);
  [[nodiscard]] int best_side(const SweepRule& rule) const;
  [[nodiscard]] bool splits(Cell c) const;
  [[nodiscard]] int wanted_neighbours(Cell c) const;
  /// Drives the shortest way to `goal`, or to the nearest wanted cell when `goal` is negative.
  bool drive_to(Cell goal);
  void finish(const SweepRule& rule, double give_up_s);
  [[nodiscard]] SweepPlan result(double give_up_s);

  MoveCost cost_;
  const SweepField* field_{nullptr};
  Cell start_{0};
  int start_heading_{0};
  std::array<Cell, 8> ring_{};

  Cell at_{0};
  int heading_{0};
  double cost_s_{0.0};
  int wanted_left_{0};
  bool stuck_{false};
  std::vector<std::uint8_t> wanted_;
  std::vector<Cell> steps_;

  std::vector<std::uint32_t> seen_in_search_;  ///< number of the search that saw the cell last
  std::vector<std::int8_t> came_by_;
  std::vector<Cell> queue_;
  std::vector<std::int8_t> way_;
  std::uint32_t search_{0};
};

}  // namespace sensotwin::robot
