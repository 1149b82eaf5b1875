// SPDX-License-Identifier: MIT
#include "robot/mapping/floor_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

namespace sensotwin::robot {
namespace {

using Cell = FloorGrid::Cell;

/// Extra cost per metre of way inside the uncomfortable rim: chosen so that a detour of a few decimetres is
/// preferred to scraping along something.
constexpr double kRimCost = 4.0;
/// Cost per metre where the robot's centre has been before though by now something seems to stand too near:
/// chosen so that any open way is preferred. And where it was stopped there by touch since.
constexpr float kTroddenCost = 10.0F;
constexpr float kTroddenBumpedCost = 60.0F;
/// How far the robot may be inside the forbidden rim by an error of its pose: 5 cm.
constexpr int kLetOutCells = 2;
constexpr float kFar = std::numeric_limits<float>::infinity();

/// The box of the request as a dense array: how bad it is for the robot's centre to be in each cell.
class CostField {
 public:
  CostField(const FloorGrid& grid, const PlanRequest& request)
      : low_(FloorGrid::cell_at(request.low_M_m)), high_(FloorGrid::cell_at(request.high_M_m)) {
    width_ = high_.x - low_.x + 1;
    cost_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(high_.y - low_.y + 1), 1.0F);
    const int reach = static_cast<int>(std::ceil(request.comfort_m / FloorGrid::kCell_m));
    const std::vector<Stamp> stamp = stamp_of(request, reach);
    for (int y = low_.y - reach; y <= high_.y + reach; ++y) {
      for (int x = low_.x - reach; x <= high_.x + reach; ++x) {
        if (grid.occupied({x, y})) {
          for (const Stamp& s : stamp) {
            const Cell c{x + s.dx, y + s.dy};
            if (inside(c)) {
              cost_[index(c)] = std::max(cost_[index(c)], s.cost);
            }
          }
        }
        if (inside({x, y}) && grid.centre_forbidden({x, y})) {
          cost_[index({x, y})] = kFar;
        }
      }
    }
    allow_trodden(grid);
    let_out(grid, FloorGrid::cell_at(request.start_M_m));
  }
  [[nodiscard]] bool inside(Cell c) const {
    return c.x >= low_.x && c.x <= high_.x && c.y >= low_.y && c.y <= high_.y;
  }
  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y - low_.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(c.x - low_.x);
  }
  [[nodiscard]] Cell cell(std::size_t i) const {
    const int n = static_cast<int>(i);
    return {low_.x + n % width_, low_.y + n / width_};
  }
  [[nodiscard]] float cost(Cell c) const { return cost_[index(c)]; }
  [[nodiscard]] std::size_t size() const { return cost_.size(); }

 private:
  /// Cells round an obstacle, with what being there costs the robot's centre.
  struct Stamp {
    int dx;
    int dy;
    float cost;
  };
  [[nodiscard]] static std::vector<Stamp> stamp_of(const PlanRequest& request, int reach) {
    std::vector<Stamp> stamp;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double distance_m = std::hypot(dx, dy) * FloorGrid::kCell_m;
        if (distance_m < request.clearance_m) {
          stamp.push_back({dx, dy, kFar});
        } else if (distance_m < request.comfort_m) {
          stamp.push_back({dx, dy, static_cast<float>(1.0 + kRimCost)});
        }
      }
    }
    return stamp;
  }

  /// What was seen since from a place known badly may wall in what is open: the robot's own trail never is.
  void allow_trodden(const FloorGrid& grid) {
    for (int y = low_.y; y <= high_.y; ++y) {
      for (int x = low_.x; x <= high_.x; ++x) {
        float& cost = cost_[index({x, y})];
        if (cost == kFar && grid.trodden({x, y})) {
          cost = grid.centre_forbidden({x, y}) ? kTroddenBumpedCost : kTroddenCost;
        }
      }
    }
  }

  /// Where the robot stands is free, whatever the grid says: it may leave through the rim it stands in.
  void let_out(const FloorGrid& grid, Cell start) {
    for (int dy = -kLetOutCells; dy <= kLetOutCells; ++dy) {
      for (int dx = -kLetOutCells; dx <= kLetOutCells; ++dx) {
        const Cell c{start.x + dx, start.y + dy};
        if (inside(c) && cost_[index(c)] == kFar && !grid.centre_forbidden(c)) {
          cost_[index(c)] = static_cast<float>(1.0 + 2.0 * kRimCost);
        }
      }
    }
  }

  Cell low_;
  Cell high_;
  int width_{0};
  std::vector<float> cost_;
};

struct Open {
  float estimate;
  std::size_t index;
  bool operator>(const Open& other) const {
    return estimate != other.estimate ? estimate > other.estimate : index > other.index;
  }
};

/// \returns the chain of cells from start to goal, or nothing.
std::vector<Cell> search(const CostField& field, const PlanRequest& request) {
  const Cell start = FloorGrid::cell_at(request.start_M_m);
  if (!field.inside(start)) {
    return {};
  }
  std::vector<float> best(field.size(), kFar);
  std::vector<std::uint32_t> parent(field.size(), 0);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto to_go = [&](Cell c) {
    const double d = (FloorGrid::centre_m(c) - request.goal_M_m).norm() - request.goal_radius_m;
    return static_cast<float>(std::max(0.0, d) / FloorGrid::kCell_m);
  };
  best[field.index(start)] = 0.0F;
  open.push({to_go(start), field.index(start)});
  while (!open.empty()) {
    const std::size_t here = open.top().index;
    const float estimate = open.top().estimate;
    open.pop();
    const Cell c = field.cell(here);
    if (estimate > best[here] + to_go(c) + 1e-3F) {
      continue;
    }
    if ((FloorGrid::centre_m(c) - request.goal_M_m).norm() <= request.goal_radius_m) {
      std::vector<Cell> chain{c};
      for (std::size_t i = here; i != field.index(start); i = parent[i]) {
        chain.push_back(field.cell(parent[i]));
      }
      std::reverse(chain.begin(), chain.end());
      return chain;
    }
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell n{c.x + dx, c.y + dy};
        if ((dx == 0 && dy == 0) || !field.inside(n) || field.cost(n) == kFar) {
          continue;
        }
        const float step = (dx != 0 && dy != 0 ? 1.41421356F : 1.0F) * field.cost(n);
        const std::size_t i = field.index(n);
        if (best[here] + step < best[i]) {
          best[i] = best[here] + step;
          parent[i] = static_cast<std::uint32_t>(here);
          open.push({best[i] + to_go(n), i});
        }
      }
    }
  }
  return {};
}

/// True when the straight way between the two cells costs no more than comfortable cells do, or is free at
/// all when both ends are already in the rim.
bool sees(const CostField& field, Cell a, Cell b) {
  const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) * 2;
  const float limit = std::max(field.cost(a) == kFar ? 1.0F : field.cost(a), field.cost(b));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Cell c{static_cast<int>(std::lround(a.x + t * (b.x - a.x))),
                 static_cast<int>(std::lround(a.y + t * (b.y - a.y)))};
    if (!field.inside(c) || field.cost(c) > limit) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Vec2> plan_over_floor(const FloorGrid& grid, const PlanRequest& request) {
  const CostField field(grid, request);
  const std::vector<Cell> chain = search(field, request);
  std::vector<Vec2> corners;
  std::size_t from = 0;
  while (!chain.empty() && from + 1 < chain.size()) {
    std::size_t to = from + 1;
    while (to + 1 < chain.size() && sees(field, chain[from], chain[to + 1])) {
      ++to;
    }
    corners.push_back(FloorGrid::centre_m(chain[to]));
    from = to;
  }
  if (corners.empty() && chain.size() == 1) {
    corners.push_back(FloorGrid::centre_m(chain.front()));
  }
  return corners;
}

}  // namespace sensotwin::robot
