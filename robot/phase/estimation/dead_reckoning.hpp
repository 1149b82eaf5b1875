// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "robot/base/geometry.hpp"
#include "robot/base/rolled_wheels.hpp"
#include "robot/base/time.hpp"

namespace sensotwin::robot {

/// What the robot believes of its wheels, and how far it trusts them: one sigma. Defaults of the algorithms
/// study, A.0 (a calibrated machine on a hard floor).
struct WheelModel {
  double wheel_base_m{0.235};                     ///< Create 2 Open Interface 2016, packet 20
  double metres_per_count{kPi * 0.0720 / 508.8};  ///< same, packet 43
  double wheel_ratio{1.0};  ///< right wheel's diameter over the left's; metres_per_count is of their mean
  /// What stays the same through a run.
  double scale_sigma{0.01};
  double turn_scale_sigma{0.01};
  double curvature_sigma_rad_per_m{0.004};
  /// What changes: per square root of a metre, and of a radian turned.
  double along_sigma_m{0.005};
  double across_sigma_m{0.002};
  double heading_sigma_rad{rad_from_deg(0.5)};
  double turn_sigma_rad{0.005};
  /// Added in every control step of touching something: the wheels go on, the body is held and turned.
  double touch_sigma_m{0.004};
  double touch_sigma_rad{0.02};
};

/// One step by the encoders' word.
struct WheelStep {
  double forward_m{0.0};
  double turn_rad{0.0};
};

[[nodiscard]] inline WheelStep wheel_step(const WheelModel& model, int counts_left, int counts_right) {
  const RolledWheels rolled = rolled_m(model, counts_left, counts_right);
  return {(rolled.left_m + rolled.right_m) / 2.0, (rolled.right_m - rolled.left_m) / model.wheel_base_m};
}

/// \returns the pose after driving a short arc, its chord taken
[[nodiscard]] inline Pose2 advanced(const Pose2& X, const WheelStep& step) {
  const double middle = X.yaw_rad + step.turn_rad / 2.0;
  return {X.p_m + step.forward_m * Vec2{std::cos(middle), std::sin(middle)},
          wrap_angle(X.yaw_rad + step.turn_rad)};
}

/// Poses of the last two seconds by dead reckoning, in a frame O of their own that drifts but never jumps: so
/// that a read is used where the robot was when the tag answered.
class DeadReckoning {
 public:
  void drive(Instant stamp, const WheelStep& step);
  [[nodiscard]] const Pose2& pose() const { return X_OR_; }
  /// Interpolated; outside the time remembered, its nearest end.
  [[nodiscard]] Pose2 pose_at(Instant at) const;

 private:
  struct Moment {
    Instant stamp;
    Pose2 X_OR;
  };
  [[nodiscard]] const Moment& back(std::size_t steps) const {
    return ring_[(newest_ + kRemembered - steps) % kRemembered];
  }
  static constexpr std::size_t kRemembered = 128;  ///< control steps: 1.9 s. Chosen: above any report's age
  std::array<Moment, kRemembered> ring_{};
  std::size_t newest_{0};
  std::size_t size_{0};
  Pose2 X_OR_;
};

}  // namespace sensotwin::robot
