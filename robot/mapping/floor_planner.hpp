// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/mapping/floor_grid.hpp"

namespace sensotwin::robot {

/// A way over the floor for the robot's centre, believing that what is not known to be blocked is free.
struct PlanRequest {
  Vec2 start_M_m{0.0, 0.0};
  Vec2 goal_M_m{0.0, 0.0};
  /// The goal is reached anywhere within this distance of it.
  double goal_radius_m{0.05};
  /// Hard: the centre never comes closer than this to something known.
  double clearance_m{0.15};
  /// Soft: closer than this costs extra.
  double comfort_m{0.21};
  /// The centre stays inside this box.
  Vec2 low_M_m{0.0, 0.0};
  Vec2 high_M_m{0.0, 0.0};
};

/// A* on the cells of the grid (eight neighbours), shortened to corner points that see each other.
/// \returns corner points from the start (exclusive) to the goal region; empty when there is no way in the
/// box. Cost: one distance transform and one search over the box.
[[nodiscard]] std::vector<Vec2> plan_over_floor(const FloorGrid& grid, const PlanRequest& request);

}  // namespace sensotwin::robot
