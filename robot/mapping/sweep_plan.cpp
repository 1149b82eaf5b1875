// SPDX-License-Identifier: MIT
#include "robot/mapping/sweep_plan.hpp"

#include <algorithm>

namespace sensotwin::robot {
namespace {

/// Quarter turns for a left turn of 0, 90, 180, 270 degrees.
constexpr std::array<int, 4> kQuarterTurns{0, 1, 2, 1};

std::size_t idx(SweepField::Cell c) {
  return static_cast<std::size_t>(c);
}

}  // namespace

void SweepPlanner::set_out(const SweepField& field, Cell at, int heading) {
  field_ = &field;
  start_ = at;
  start_heading_ = heading;
  const Cell e = field.step(0);
  const Cell n = field.step(1);
  ring_ = {e,
           static_cast<Cell>(n + e),
           n,
           static_cast<Cell>(n - e),
           static_cast<Cell>(-e),
           static_cast<Cell>(-n - e),
           static_cast<Cell>(-n),
           static_cast<Cell>(e - n)};
  if (seen_in_search_.size() != field.size()) {
    seen_in_search_.assign(field.size(), 0);
    came_by_.assign(field.size(), 0);
    search_ = 0;
  }
}

void SweepPlanner::restart() {
  at_ = start_;
  heading_ = start_heading_;
  cost_s_ = 0.0;
  stuck_ = false;
  wanted_ = field_->wanted();
  wanted_left_ = field_->wanted_count();
  steps_.clear();
}

void SweepPlanner::drive(int side) {
  cost_s_ +=
      cost_.tile_s + cost_.quarter_turn_s * kQuarterTurns[static_cast<std::size_t>((side - heading_) & 3)];
  heading_ = side;
  at_ += field_->step(side);
  wanted_left_ -= wanted_[idx(at_)];
  wanted_[idx(at_)] = 0;
  steps_.push_back(at_);
}

int SweepPlanner::wanted_neighbours(Cell c) const {
  int count = 0;
  for (int side = 0; side < 4; ++side) {
    count += (field_->sides()[idx(c)] >> side & 1) & wanted_[idx(c + field_->step(side))];
  }
  return count;
}

bool SweepPlanner::splits(Cell c) const {
  // The wanted cells of the ring of eight fall into more than one run: there they may be parted.
  int changes = 0;
  std::uint8_t before = wanted_[idx(c + ring_[7])];
  for (const Cell to : ring_) {
    const std::uint8_t now = wanted_[idx(c + to)];
    changes += now != before;
    before = now;
  }
  return changes > 2;
}

int SweepPlanner::best_side(const SweepRule& rule) const {
  int best = -1;
  double best_sum = std::numeric_limits<double>::infinity();
  for (const int left : {0, 3, 1, 2}) {
    const int side = (heading_ + left) & 3;
    const Cell next = at_ + field_->step(side);
    if ((field_->sides()[idx(at_)] >> side & 1) == 0 || wanted_[idx(next)] == 0) continue;
    double sum = rule.per_wanted_neighbour * wanted_neighbours(next) + (left != 0 ? rule.not_straight : 0.0) +
                 (left == 3 ? rule.right : 0.0) + (left == 1 ? rule.left : 0.0);
    if (rule.splits != 0.0 && splits(next)) sum += rule.splits;
    if (sum < best_sum) {
      best_sum = sum;
      best = side;
    }
  }
  return best;
}

bool SweepPlanner::drive_to(Cell goal) {
  ++search_;
  queue_.clear();
  queue_.push_back(at_);
  seen_in_search_[idx(at_)] = search_;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Cell c = queue_[i];
    for (const int left : {0, 1, 3, 2}) {
      const int side = (heading_ + left) & 3;
      const Cell next = c + field_->step(side);
      if ((field_->sides()[idx(c)] >> side & 1) == 0 || seen_in_search_[idx(next)] == search_) continue;
      seen_in_search_[idx(next)] = search_;
      came_by_[idx(next)] = static_cast<std::int8_t>(side);
      queue_.push_back(next);
      if (goal < 0 ? wanted_[idx(next)] == 0 : next != goal) continue;
      way_.clear();
      for (Cell back = next; back != at_; back -= field_->step(came_by_[idx(back)])) {
        way_.push_back(came_by_[idx(back)]);
      }
      std::for_each(way_.rbegin(), way_.rend(), [this](std::int8_t s) { drive(s); });
      return true;
    }
  }
  return false;
}

void SweepPlanner::finish(const SweepRule& rule, double give_up_s) {
  while (wanted_left_ > 0 && cost_s_ < give_up_s) {
    const int side = best_side(rule);
    if (side >= 0) {
      drive(side);
    } else if (!drive_to(-1)) {
      return;  // what is left cannot be reached
    }
  }
}

SweepPlan SweepPlanner::result(double give_up_s) {
  if (cost_s_ >= give_up_s) return {};
  return {cost_s_, steps_};
}

SweepPlan SweepPlanner::follow(const SweepRule& rule, int first_side, double give_up_s) {
  restart();
  if (first_side >= 0) drive(first_side);
  finish(rule, give_up_s);
  return result(give_up_s);
}

SweepPlan SweepPlanner::repair(const std::vector<Cell>& order, const SweepRule& rule, double give_up_s) {
  restart();
  for (const Cell c : order) {
    if (wanted_[idx(c)] && cost_s_ < give_up_s) drive_to(c);
  }
  finish(rule, give_up_s);
  return result(give_up_s);
}

}  // namespace sensotwin::robot
