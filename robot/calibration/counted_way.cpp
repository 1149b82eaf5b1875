// SPDX-License-Identifier: MIT
#include "robot/calibration/counted_way.hpp"

#include <algorithm>
#include <cmath>

#include "robot/base/time.hpp"

namespace sensotwin::robot {
namespace {

/// A count is 0.44 mm: at 0.1 m/s three steps have ten.
constexpr std::size_t kSpeedSteps = 4;

}  // namespace

CountedWay counted_way(const std::vector<CountedStep>& steps, std::size_t first, std::size_t end,
                       const OdometryModel& wheels) {
  CountedWay way;
  for (std::size_t i = first; i < std::min(end, steps.size()); ++i) {
    const RolledWheels rolled = rolled_m(wheels, steps[i].left, steps[i].right);
    const double forward_m = 0.5 * (rolled.left_m + rolled.right_m);
    const double turn_rad = (rolled.right_m - rolled.left_m) / wheels.wheel_base_m;
    const double middle_rad = way.X.yaw_rad + 0.5 * turn_rad;
    way.X.p_m += forward_m * Vec2{std::cos(middle_rad), std::sin(middle_rad)};
    way.X.yaw_rad = wrap_angle(way.X.yaw_rad + turn_rad);
    way.rolled_m += std::abs(forward_m);
    way.turned_rad += std::abs(turn_rad);
  }
  return way;
}

double speed_at(const std::vector<CountedStep>& steps, std::size_t step, const OdometryModel& wheels) {
  const std::size_t end = std::min(step + 1, steps.size());
  const std::size_t first = end > kSpeedSteps ? end - kSpeedSteps : 0;
  double forward_m = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const RolledWheels rolled = rolled_m(wheels, steps[i].left, steps[i].right);
    forward_m += 0.5 * (rolled.left_m + rolled.right_m);
  }
  return end > first ? forward_m / (static_cast<double>(end - first) * to_s(kTick)) : 0.0;
}

}  // namespace sensotwin::robot
