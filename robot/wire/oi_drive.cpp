// SPDX-License-Identifier: MIT
#include "robot/wire/oi_drive.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot::oi {
namespace {

constexpr double kMaxSpeed_mm_s = 500.0;  // page 13
constexpr double kMaxRadius_mm = 2000.0;  // page 13

[[nodiscard]] std::int16_t nearest_mm_s(double speed_mps) {
  return static_cast<std::int16_t>(
      std::lround(std::clamp(speed_mps * 1000.0, -kMaxSpeed_mm_s, kMaxSpeed_mm_s)));
}

}  // namespace

WheelSpeeds wheel_speeds(const Drive& drive, double wheel_base_m, bool straight_is_0x8000_only) {
  const double v_mps = drive.velocity_mm_s * 1e-3;
  if (drive.radius_mm == kStraight || drive.radius_mm == 0 ||
      (drive.radius_mm == kStraightToo && !straight_is_0x8000_only)) {
    return {v_mps, v_mps};
  }
  if (drive.radius_mm == kTurnClockwise) {
    return {v_mps, -v_mps};
  }
  if (drive.radius_mm == kTurnCounterClockwise) {
    return {-v_mps, v_mps};
  }
  const double ratio = 0.5 * wheel_base_m / (drive.radius_mm * 1e-3);
  return {v_mps * (1.0 - ratio), v_mps * (1.0 + ratio)};
}

Drive drive_for(const WheelSpeeds& wheels, double wheel_base_m) {
  const double mean_mps = 0.5 * (wheels.left_mps + wheels.right_mps);
  const double half_difference_mps = 0.5 * (wheels.right_mps - wheels.left_mps);
  const double radius_mm =
      half_difference_mps == 0.0 ? 0.0 : 500.0 * wheel_base_m * mean_mps / half_difference_mps;
  // Straight turns by 0, the widest arc by 1/R: beyond 2 R straight is the nearer one.
  if (half_difference_mps == 0.0 || std::abs(radius_mm) > 2.0 * kMaxRadius_mm) {
    return {nearest_mm_s(mean_mps), kStraight};
  }
  if (std::abs(radius_mm) < 2.0) {
    return {nearest_mm_s(std::abs(half_difference_mps)),
            half_difference_mps > 0.0 ? kTurnCounterClockwise : kTurnClockwise};
  }
  return {nearest_mm_s(mean_mps),
          static_cast<std::int16_t>(std::lround(std::clamp(radius_mm, -kMaxRadius_mm, kMaxRadius_mm)))};
}

DriveDirect drive_direct_for(const WheelSpeeds& wheels) {
  return {nearest_mm_s(wheels.right_mps), nearest_mm_s(wheels.left_mps)};
}

WheelSpeeds wheel_speeds(const DriveDirect& drive) {
  return {drive.left_mm_s * 1e-3, drive.right_mm_s * 1e-3};
}

}  // namespace sensotwin::robot::oi
