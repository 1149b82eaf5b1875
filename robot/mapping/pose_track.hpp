// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// What the robot believes of its own wheels, and how far it trusts them.
struct OdometryModel {
  double wheel_base_m{0.235};                     ///< Create 2 Open Interface 2016, packet 20
  double metres_per_count{kPi * 0.0720 / 508.8};  ///< same, packet 43
  double wheel_ratio{1.0};  ///< right wheel's diameter over the left's; metres_per_count is of their mean
  /// One sigma at the start of a run, of what stays the same through it. "After calibration 1 % and 1 to 2
  /// degrees per quarter turn" (algorithms study, C.2).
  double scale_sigma{0.01};                ///< travelled / counted distance - 1
  double turn_scale_sigma{0.02};           ///< turned / counted angle - 1
  double curvature_sigma_rad_per_m{0.02};  ///< unequal wheels: turn per metre driven straight
  /// One sigma of what changes: per square root of a metre, and per square root of a radian turned.
  double along_sigma_m{0.008};
  double across_sigma_m{0.010};
  double heading_sigma_rad{0.020};
  double turn_sigma_rad{0.03};
  /// One sigma of what touching something changes, beyond what drive() makes of it, per metre that the wheels
  /// roll while it lasts. Measured in the twin over 2 000 bumps of some 2 cm each: 2 to 4 mm and 0.3 degrees
  /// a bump, much of it the same way each time.
  double touch_sigma_m_per_m{0.15};
  double touch_sigma_rad_per_m{0.3};
};

/// What the robot believes of its compass: noise, and a bias by the iron nearby that changes from place to
/// place about what it was at the start (a Gauss-Markov process over the way driven).
struct CompassModel {
  double noise_sigma_rad{0.026};  ///< 1.5 degrees. Chosen: 1 degree of the element, and vibration
  /// "5 degrees of spatial distortion" (algorithms study, C.2), and the way over which it becomes another.
  /// Chosen: 1 m, the size of a radiator or a steel table frame.
  double bias_sigma_rad{0.087};
  double bias_length_m{1.0};
  /// Per square root of a radian turned: what is left of the robot's own iron after calibration. Chosen: 1
  /// degree.
  double turn_bias_sigma_rad{0.017};
};

/// One belief of where the robot is: an extended Kalman filter over
///
///     x = [ x_m, y_m, yaw_rad, scale, turn_scale, curvature, bias ]
///
/// (pose of R in M; the wheels' errors; compass reading less yaw)
///
/// driven by encoder counts (l, r in metres, b the wheel base),
///
///     d = (l + r)/2 (1 + scale),  dyaw = (r - l)/b (1 + turn_scale) + curvature d,
///     x += d cos(yaw + dyaw/2),  y += d sin(yaw + dyaw/2).
///
/// The compass measures yaw + bias, and the bias changes with the way driven: so the compass keeps the
/// heading within a few degrees wherever the robot has been carried or pushed, and says much more of a turn
/// on the spot, where the iron around stays the same.
///
/// The mean moves at every call; the covariance follows in steps of two centimetres, linearised about the way
/// taken.
class PoseTrack {
 public:
  PoseTrack(const OdometryModel& odometry, const CompassModel& compass)
      : model_(odometry), compass_(compass) {}

  /// Pose afresh, independent of what was believed before; the wheels' learned errors stay.
  void reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad);
  /// Encoder distances since the last call.
  /// \param contact_yaw_R_rad  where on the shell the body touches something meanwhile: the wheels may go on,
  ///   the body does not go that way, and slides along what it touches
  void drive(double left_m, double right_m, std::optional<double> contact_yaw_R_rad = std::nullopt);

  /// Shifts the belief so that `direction` . p becomes `value_m`, with this standard deviation.
  /// \returns log of the likelihood that the belief gave to it (up to a constant shared by all beliefs)
  double correct_position(const Vec2& direction_M, double value_m, double sigma_m);
  /// \param reading_rad  counter-clockwise from north
  double correct_by_compass(double reading_rad);
  /// Widens the pose by this factor on standard deviations, the heading to no more than the compass leaves
  /// open, and forgets what ties the pose to the rest.
  void doubt(double factor);

  [[nodiscard]] const Pose2& pose() const { return X_MR_; }
  /// Standard deviation of the position along a direction.
  [[nodiscard]] double position_sigma_m(const Vec2& direction_M);
  [[nodiscard]] double yaw_sigma_rad();

  /// Remembers the present place, `back_m` behind, to measure a way from.
  void mark(double back_m) {
    mark_M_m_ = X_MR_.p_m - back_m * X_MR_.direction();
    touched_since_mark_ = false;
  }
  /// Something was touched since: what the wheels count is not what was driven.
  [[nodiscard]] bool touched_since_mark() const { return touched_since_mark_; }
  /// From the mark to the present place, in M: exact to millimetres over a tag's zone, unless touched.
  [[nodiscard]] Vec2 since_mark_m() const { return X_MR_.p_m - mark_M_m_; }

 private:
  static constexpr int kStates = 7;
  using State = Eigen::Matrix<double, kStates, 1>;
  using Row = Eigen::Matrix<double, 1, kStates>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;
  void propagate_covariance();
  void grow_by_touch(double rolled_m);
  double correct(const Row& H, double innovation, double sigma);

  OdometryModel model_;
  CompassModel compass_;
  Pose2 X_MR_;
  double scale_{0.0};
  double turn_scale_{0.0};
  double curvature_rad_per_m_{0.0};
  double bias_rad_{0.0};
  double first_bias_rad_{0.0};
  bool bias_known_{false};
  Covariance P_{Covariance::Zero()};
  bool wheels_known_{false};
  double touched_m_{0.0};  ///< rolled in touches since the place was last measured
  double pending_m_{0.0};
  double pending_abs_m_{0.0};
  double pending_rad_{0.0};
  double pending_abs_rad_{0.0};
  Vec2 pending_start_m_{0.0, 0.0};
  Vec2 mark_M_m_{0.0, 0.0};
  bool touched_since_mark_{false};
};

}  // namespace sensotwin::robot
