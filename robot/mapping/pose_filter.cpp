// SPDX-License-Identifier: MIT
#include "robot/mapping/pose_filter.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// The covariance is carried forward after this much travel or turn: small against the 2 cm that matter.
constexpr double kCovarianceStep_m = 0.02;
constexpr double kCovarianceStep_rad = 0.05;
/// Beyond this many standard deviations the filter has been too sure of itself.
constexpr double kGateSigmas = 5.0;

double squared(double x) {
  return x * x;
}

}  // namespace

void PoseFilter::reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad) {
  propagate_covariance();
  X_MR_ = X_MR;
  P_.topRows<3>().setZero();
  P_.leftCols<3>().setZero();
  P_(0, 0) = P_(1, 1) = squared(position_sigma_m);
  P_(2, 2) = squared(yaw_sigma_rad);
  if (!wheels_known_) {
    P_(3, 3) = squared(model_.scale_sigma);
    P_(4, 4) = squared(model_.turn_scale_sigma);
    P_(5, 5) = squared(model_.curvature_sigma_rad_per_m);
    wheels_known_ = true;
  }
  pending_start_m_ = X_MR_.p_m;
}

void PoseFilter::drive(int counts_left, int counts_right) {
  if (counts_left == 0 && counts_right == 0) {
    return;
  }
  const double left_m = counts_left * model_.metres_per_count;
  const double right_m = counts_right * model_.metres_per_count;
  const double counted_m = (left_m + right_m) / 2.0;
  const double counted_rad = (right_m - left_m) / model_.wheel_base_m;

  const double odometry_yaw = X_OR_.yaw_rad + counted_rad / 2.0;
  X_OR_.p_m += counted_m * Vec2{std::cos(odometry_yaw), std::sin(odometry_yaw)};
  X_OR_.yaw_rad = wrap_angle(X_OR_.yaw_rad + counted_rad);

  const double d_m = counted_m * (1.0 + scale_);
  const double dyaw = counted_rad * (1.0 + turn_scale_) + curvature_rad_per_m_ * d_m;
  const double yaw = X_MR_.yaw_rad + dyaw / 2.0;
  X_MR_.p_m += d_m * Vec2{std::cos(yaw), std::sin(yaw)};
  X_MR_.yaw_rad = wrap_angle(X_MR_.yaw_rad + dyaw);

  path_length_m_ += std::abs(d_m);
  turned_rad_ += std::abs(dyaw);
  pending_m_ += counted_m;
  pending_abs_m_ += std::abs(counted_m);
  pending_rad_ += counted_rad;
  pending_abs_rad_ += std::abs(counted_rad);
  if (pending_abs_m_ > kCovarianceStep_m || pending_abs_rad_ > kCovarianceStep_rad) {
    propagate_covariance();
  }
}

void PoseFilter::propagate_covariance() {
  if (pending_abs_m_ == 0.0 && pending_abs_rad_ == 0.0) {
    return;
  }
  const Vec2 moved = X_MR_.p_m - pending_start_m_;
  const double c = std::cos(X_MR_.yaw_rad);
  const double s = std::sin(X_MR_.yaw_rad);
  Covariance F = Covariance::Identity();
  F(0, 2) = -moved.y();
  F(1, 2) = moved.x();
  F(0, 3) = c * pending_m_;
  F(1, 3) = s * pending_m_;
  F(2, 4) = pending_rad_;
  F(2, 5) = pending_m_;
  P_ = F * P_ * F.transpose();
  const double along = squared(model_.along_sigma_m) * pending_abs_m_;
  const double across = squared(model_.across_sigma_m) * pending_abs_m_;
  P_(0, 0) += along * c * c + across * s * s;
  P_(1, 1) += along * s * s + across * c * c;
  P_(0, 1) += (along - across) * c * s;
  P_(1, 0) += (along - across) * c * s;
  // Turning noise as a random walk over the angle turned: sigma of `turn_sigma` rad after one radian.
  P_(2, 2) += squared(model_.heading_sigma_rad) * pending_abs_m_ + squared(model_.turn_sigma) * pending_abs_rad_;
  pending_m_ = pending_abs_m_ = pending_rad_ = pending_abs_rad_ = 0.0;
  pending_start_m_ = X_MR_.p_m;
}

double PoseFilter::correct(const Eigen::Matrix<double, 1, 6>& H, double innovation, double sigma) {
  double spread = (H * P_ * H.transpose())(0, 0);
  const double sigmas = std::abs(innovation) / std::sqrt(spread + squared(sigma));
  if (sigmas > kGateSigmas) {
    // The reading is certain and the belief is not: widen the pose until the reading is a one-sigma event.
    const double factor = squared(innovation) / std::max(spread, 1e-8);
    P_.topLeftCorner<3, 3>() *= std::clamp(factor, 1.0, 100.0);
    P_.topRightCorner<3, 3>().setZero();
    P_.bottomLeftCorner<3, 3>().setZero();
    spread = (H * P_ * H.transpose())(0, 0);
  }
  const State gain = P_ * H.transpose() / (spread + squared(sigma));
  const State change = gain * innovation;
  P_ -= gain * (H * P_);
  P_ = ((P_ + P_.transpose()) / 2.0).eval();
  X_MR_.p_m += change.head<2>();
  X_MR_.yaw_rad = wrap_angle(X_MR_.yaw_rad + change(2));
  scale_ += change(3);
  turn_scale_ += change(4);
  curvature_rad_per_m_ += change(5);
  pending_start_m_ = X_MR_.p_m;
  return sigmas;
}

double PoseFilter::correct_by_rim(const Vec2& tag_M_m, double read_radius_m, double rim_sigma_m,
                                  const Vec2& travelled_since_M_m) {
  propagate_covariance();
  const Vec2 from_tag = X_MR_.p_m - travelled_since_M_m - tag_M_m;
  const double distance = from_tag.norm();
  if (distance < 1e-6) {
    return 0.0;  // the gradient has no direction in the middle of the zone
  }
  Eigen::Matrix<double, 1, 6> H = Eigen::Matrix<double, 1, 6>::Zero();
  H(0, 0) = from_tag.x() / distance;
  H(0, 1) = from_tag.y() / distance;
  // Second-order width: across the line of sight the rim is an arc, and an uncertain lateral place bends the
  // expected distance by sigma^2 / (2 distance).
  const double lateral = H(0, 1) * H(0, 1) * P_(0, 0) + H(0, 0) * H(0, 0) * P_(1, 1) - 2.0 * H(0, 0) * H(0, 1) * P_(0, 1);
  const double bend = lateral / (2.0 * std::max(distance, read_radius_m / 2.0));
  return correct(H, read_radius_m - distance, std::hypot(rim_sigma_m, std::min(bend, read_radius_m / 2.0)));
}

double PoseFilter::correct_heading(double yaw_rad, double sigma_rad) {
  propagate_covariance();
  Eigen::Matrix<double, 1, 6> H = Eigen::Matrix<double, 1, 6>::Zero();
  H(0, 2) = 1.0;
  return correct(H, wrap_angle(yaw_rad - X_MR_.yaw_rad), sigma_rad);
}

double PoseFilter::across_sigma_m() {
  propagate_covariance();
  const double c = std::cos(X_MR_.yaw_rad);
  const double s = std::sin(X_MR_.yaw_rad);
  return std::sqrt(std::max(0.0, s * s * P_(0, 0) + c * c * P_(1, 1) - 2.0 * c * s * P_(0, 1)));
}

double PoseFilter::along_sigma_m() {
  propagate_covariance();
  const double c = std::cos(X_MR_.yaw_rad);
  const double s = std::sin(X_MR_.yaw_rad);
  return std::sqrt(std::max(0.0, c * c * P_(0, 0) + s * s * P_(1, 1) + 2.0 * c * s * P_(0, 1)));
}

double PoseFilter::yaw_sigma_rad() {
  propagate_covariance();
  return std::sqrt(std::max(0.0, P_(2, 2)));
}

}  // namespace sensotwin::robot
