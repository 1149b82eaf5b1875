// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace sensotwin::robot {

/// Frames follow REP-103: x forward, y left, yaw counter-clockwise; metres and radians.
/// X_AB is the pose of frame B in frame A, p_AB_A the vector from A to B expressed in A.
/// Letters: W world (only world/, twin/ and render/ may say W), R robot base (centre of the wheel axle),
/// M the robot's own map (origin at the first tag found), A antenna, T tag.
using Vec2 = Eigen::Vector2d;

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] constexpr double rad_from_deg(double deg) {
  return deg * kPi / 180.0;
}
[[nodiscard]] constexpr double deg_from_rad(double rad) {
  return rad * 180.0 / kPi;
}
/// Same angle in (-pi, pi].
[[nodiscard]] inline double wrap_angle(double rad) {
  // Most angles are wrapped already or off by one turn, where the difference is exact (Sterbenz): the same
  // bits as the remainder, without its tens of nanoseconds.
  if (rad > -kPi && rad <= kPi) {
    return rad;
  }
  if (rad > kPi && rad < 2.5 * kPi) {
    return rad - 2.0 * kPi;
  }
  if (rad < -kPi && rad > -2.5 * kPi) {
    return rad + 2.0 * kPi;
  }
  const double wrapped = std::remainder(rad, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// A rigid motion of the plane.
struct Pose2 {
  Vec2 p_m{0.0, 0.0};
  double yaw_rad{0.0};

  [[nodiscard]] Vec2 direction() const { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }
  /// Composition: X_AC = X_AB * X_BC.
  [[nodiscard]] Pose2 operator*(const Pose2& other) const {
    return {*this * other.p_m, wrap_angle(yaw_rad + other.yaw_rad)};
  }
  /// A point from frame B to frame A: p_A = X_AB * p_B.
  [[nodiscard]] Vec2 operator*(const Vec2& p_B) const {
    const double c = std::cos(yaw_rad);
    const double s = std::sin(yaw_rad);
    return {p_m.x() + c * p_B.x() - s * p_B.y(), p_m.y() + s * p_B.x() + c * p_B.y()};
  }
  [[nodiscard]] Pose2 inverse() const {
    const double c = std::cos(yaw_rad);
    const double s = std::sin(yaw_rad);
    return {{-c * p_m.x() - s * p_m.y(), s * p_m.x() - c * p_m.y()}, wrap_angle(-yaw_rad)};
  }
};

}  // namespace sensotwin::robot
