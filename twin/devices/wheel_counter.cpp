// SPDX-License-Identifier: MIT
#include "twin/devices/wheel_counter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/base/geometry.hpp"
#include "robot/base/time.hpp"

namespace sensotwin::twin {

WheelCounter::WheelCounter(double counts_per_turn, double acceleration_mps2, robot::Ticks start)
    : edges_per_rad_(counts_per_turn / (2.0 * robot::kPi)),
      set_point_step_mps_(acceleration_mps2 * robot::to_s(robot::kTick)),
      ticks_(start) {}

int WheelCounter::update(double angle_rad, double target_mps) {
  set_point_mps_ += std::clamp(target_mps - set_point_mps_, -set_point_step_mps_, set_point_step_mps_);
  if (set_point_mps_ != 0.0) {
    direction_ = set_point_mps_ > 0.0 ? 1 : -1;
    standing_ticks_ = 0;
  } else if (++standing_ticks_ > kRunOutTicks) {
    direction_ = 1;
  }
  const double edge = std::floor(angle_rad * edges_per_rad_);
  const int passed = edge_known_ ? static_cast<int>(std::abs(edge - edge_)) : 0;
  edge_ = edge;
  edge_known_ = true;
  const int counts = direction_ * passed;
  ticks_ = ticks_ + counts;
  return counts;
}

void WheelCounter::reset() {
  ticks_ = {};
  set_point_mps_ = 0.0;
  direction_ = 1;
}

}  // namespace sensotwin::twin
