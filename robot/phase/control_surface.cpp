// SPDX-License-Identifier: MIT
#include "robot/phase/control_surface.hpp"

#include <algorithm>
#include <cassert>

namespace sensotwin::robot {

ControlSurface control_surface(const FuzzyController& controller, int points) {
  assert(points >= 2);
  const FuzzySets& sets = controller.sets();
  const double lowest_rad = std::max(-kPi, sets.negative_rad.left_foot);
  const double highest_rad = std::min(kPi, sets.positive_rad.right_foot);
  const double slowest = std::min({sets.clockwise_radps.left_foot, sets.straight_radps.left_foot});
  const double fastest = std::max({sets.counter_clockwise_radps.right_foot, sets.straight_radps.right_foot});
  ControlSurface surface;
  for (int i = 0; i < points; ++i) {
    const double part = static_cast<double>(i) / (points - 1);
    const double dphi = lowest_rad + part * (highest_rad - lowest_rad);
    const auto [positive, zero, negative] = controller.degrees(dphi);
    surface.inputs.push_back({dphi, negative, zero, positive, controller.turn_rate_radps(dphi)});
    const double w = slowest + part * (fastest - slowest);
    surface.outputs.push_back({w, sets.clockwise_radps.degree(w), sets.straight_radps.degree(w),
                               sets.counter_clockwise_radps.degree(w)});
  }
  return surface;
}

}  // namespace sensotwin::robot
