// SPDX-License-Identifier: MIT
#include "robot/mapping/sweep.hpp"

#include <algorithm>
#include <cstdlib>

namespace sensotwin::robot {
namespace {
double env(const char* n, double d) { const char* v = std::getenv(n); return v ? std::atof(v) : d; }
std::vector<SweepRule> rules_from_env() {
  const double w = env("W", 1.925), ns = env("NS", .912), sp = env("SP", 1.47), h = env("H", .92);
  std::vector<SweepRule> r{{w, ns, -h, h, sp}};
  const int n = static_cast<int>(env("N", 1));
  if (n > 1) r.push_back({w, ns, h, -h, sp});
  if (n > 2) r.push_back({0, 1, -2, 2, 0});
  if (n > 3) r.push_back({0, 1, 2, -2, 0});
  if (n > 4) r.push_back({w, ns + 1.5, -h, h, sp});
  if (n > 5) r.push_back({w, ns + 1.5, h, -h, sp});
  return r;
}
const std::vector<SweepRule> kRules = rules_from_env();
}  // namespace

std::optional<Move> Sweep::do_next(const TileMap& map, Tile at, Direction heading) {
  first_visits_ = static_cast<int>(map.visited_count());
  auto move = straight_move(map, at, heading, false);
  if (!move) move = straight_move(map, at, heading, true);
  if (move) {
    const bool back = map.visited(move->target);
    if (back && !driving_back_) ++backtracks_;
    driving_back_ = back;
    return move;
  }
  plan_.clear();
  return detour(map, at);
}

std::optional<Move> Sweep::straight_move(const TileMap& map, Tile at, Direction heading, bool doubtful_too) {
  field_.build(map, doubtful_too);
  if (field_.wanted_count() == 0) return std::nullopt;
  if (!plan_.empty() && plan_.front() == at) plan_.erase(plan_.begin());
  improve_plan(at, heading);
  if (plan_.empty()) return std::nullopt;
  return Move{plan_.front()};
}

void Sweep::improve_plan(Tile at, Direction heading) {
  planner_.set_out(field_, field_.cell(at), static_cast<int>(heading));
  std::vector<SweepField::Cell> order;
  for (const Tile t : plan_) {
    if (field_.contains(t)) order.push_back(field_.cell(t));
  }
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  SweepPlan best = planner_.repair(order, kRules[0], kNoLimit);
  for (const SweepRule& rule : kRules) {
    for (int side = 0; side < 4; ++side) {
      const SweepField::Cell next = field_.cell(at) + field_.step(side);
      if (!(field_.sides()[static_cast<std::size_t>(field_.cell(at))] >> side & 1)) continue;
      if (!field_.wanted()[static_cast<std::size_t>(next)]) continue;
      SweepPlan plan = planner_.follow(rule, side, best.cost_s - 1e-6);
      if (plan.cost_s < best.cost_s) best = std::move(plan);
    }
  }
  plan_.clear();
  for (const SweepField::Cell c : best.steps) plan_.push_back(field_.tile(c));
}

std::optional<Move> Sweep::detour(const TileMap& map, Tile at) const {
  (void)map; (void)at;
  return std::nullopt;
}

}  // namespace sensotwin::robot
