// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// What the robot believes of its own wheels, and how far it trusts them.
struct OdometryModel {
  double wheel_base_m{0.235};                ///< Create 2 Open Interface 2016, packet 20
  double metres_per_count{3.14159265358979323846 * 0.0720 / 508.8};  ///< same, packet 43
  /// One sigma at the start of a run, of what stays the same through it. "After calibration 1 % and 1 to 2 degrees
  /// per quarter turn" (algorithms study, C.2).
  double scale_sigma{0.01};                  ///< travelled / counted distance - 1
  double turn_scale_sigma{0.02};             ///< turned / counted angle - 1
  double curvature_sigma_rad_per_m{0.02};    ///< unequal wheels: turn per metre when driving straight
  /// One sigma of what changes: per square root of a metre, and per radian turned.
  double along_sigma_m{0.006};
  double across_sigma_m{0.008};
  double heading_sigma_rad{0.012};
  double turn_sigma{0.015};
};

/// Where the robot is on its own map: an extended Kalman filter over
///
///     x = [ x_m, y_m, yaw_rad, scale, turn_scale, curvature ]     (pose of R in M, then the wheels' errors)
///
/// driven by encoder counts,
///
///     d = (l + r)/2 (1 + scale),  dyaw = (r - l)/b (1 + turn_scale) + curvature d,
///     x += d cos(yaw + dyaw/2),  y += d sin(yaw + dyaw/2),
///
/// and corrected whenever a tag of known place comes into the antenna's field or leaves it: at that moment the
/// antenna is on the rim of the tag's read zone, |p_A - p_T| = r. A pass off the middle of a tag corrects both along
/// and across the way, since the rim is met earlier or later; a pass through the middle says nothing about which side,
/// which is why the mission passes tags a little to one side on purpose.
/// The covariance is carried forward in steps of two centimetres, the mean at every call.
class PoseFilter {
 public:
  explicit PoseFilter(const OdometryModel& model) : model_(model) {}

  /// Starts afresh at `X_MR` with these standard deviations; the wheels' learned errors stay.
  void reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad);

  void drive(int counts_left, int counts_right);

  /// The antenna crossed the rim of a tag's read zone `ago` = (travelled since, in M) before now.
  /// \returns the innovation over its standard deviation; beyond 5 the covariance was inflated first.
  double correct_by_rim(const Vec2& tag_M_m, double read_radius_m, double rim_sigma_m, const Vec2& travelled_since_M_m);

  /// A heading in M from elsewhere (compass less its learned offset).
  double correct_heading(double yaw_rad, double sigma_rad);

  [[nodiscard]] const Pose2& pose() const { return X_MR_; }
  /// Standard deviation across and along the present heading, and of the heading.
  [[nodiscard]] double across_sigma_m();
  [[nodiscard]] double along_sigma_m();
  [[nodiscard]] double yaw_sigma_rad();
  /// Metres travelled by the encoders' word since construction, never reset.
  [[nodiscard]] double path_length_m() const { return path_length_m_; }
  /// Angle turned, absolute values added up.
  [[nodiscard]] double turned_rad() const { return turned_rad_; }
  /// Pose by encoders alone, from nominal geometry: for the log.
  [[nodiscard]] const Pose2& odometry() const { return X_OR_; }

 private:
  using State = Eigen::Matrix<double, 6, 1>;
  using Covariance = Eigen::Matrix<double, 6, 6>;
  void propagate_covariance();
  double correct(const Eigen::Matrix<double, 1, 6>& H, double innovation, double sigma);

  OdometryModel model_;
  Pose2 X_MR_;
  Pose2 X_OR_;
  double scale_{0.0};
  double turn_scale_{0.0};
  double curvature_rad_per_m_{0.0};
  Covariance P_{Covariance::Zero()};
  bool wheels_known_{false};
  /// Since the covariance was last carried forward.
  double pending_m_{0.0};
  double pending_abs_m_{0.0};
  double pending_rad_{0.0};
  double pending_abs_rad_{0.0};
  Vec2 pending_start_m_{0.0, 0.0};
  double path_length_m_{0.0};
  double turned_rad_{0.0};
};

}  // namespace sensotwin::robot
