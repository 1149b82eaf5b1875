// SPDX-License-Identifier: MIT
#include "robot/mapping/pose_track.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// The covariance is carried forward after this much travel or turn: small against the centimetres that
/// matter.
constexpr double kCovarianceStep_m = 0.02;
constexpr double kCovarianceStep_rad = 0.05;
/// A heading is doubted up to this: what the compass leaves open, twice.
constexpr double kDoubtedYaw_rad = 0.17;

double squared(double x) {
  return x * x;
}

}  // namespace

void PoseTrack::reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad) {
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
  mark_M_m_ = X_MR_.p_m;
}

void PoseTrack::drive(double left_m, double right_m, std::optional<double> contact_yaw_R_rad) {
  const double counted_m = (left_m + right_m) / 2.0;
  const double counted_rad = (right_m - left_m) / model_.wheel_base_m;
  const double d_m = counted_m * (1.0 + scale_);
  const double dyaw = counted_rad * (1.0 + turn_scale_) + curvature_rad_per_m_ * d_m;
  const double yaw = X_MR_.yaw_rad + dyaw / 2.0;
  Vec2 way = d_m * Vec2{std::cos(yaw), std::sin(yaw)};
  if (contact_yaw_R_rad) {
    const Vec2 outward{std::cos(yaw + *contact_yaw_R_rad), std::sin(yaw + *contact_yaw_R_rad)};
    way -= std::max(0.0, way.dot(outward)) * outward;
  }
  X_MR_.p_m += way;
  X_MR_.yaw_rad = wrap_angle(X_MR_.yaw_rad + dyaw);
  pending_m_ += counted_m;
  pending_abs_m_ += std::abs(counted_m);
  pending_rad_ += counted_rad;
  pending_abs_rad_ += std::abs(counted_rad);
  if (contact_yaw_R_rad) {
    grow_by_touch(std::max(std::abs(left_m), std::abs(right_m)));
  } else if (pending_abs_m_ > kCovarianceStep_m || pending_abs_rad_ > kCovarianceStep_rad) {
    propagate_covariance();
  }
}

void PoseTrack::grow_by_touch(double rolled_m) {
  propagate_covariance();
  // One error that grows with the way rolled, not many small ones that cancel: a wall pushes one way.
  touched_since_mark_ = true;
  const double grown_m2 = squared(touched_m_ + rolled_m) - squared(touched_m_);
  touched_m_ += rolled_m;
  P_(0, 0) += squared(model_.touch_sigma_m_per_m) * grown_m2;
  P_(1, 1) += squared(model_.touch_sigma_m_per_m) * grown_m2;
  P_(2, 2) += squared(model_.touch_sigma_rad_per_m) * grown_m2;
}

void PoseTrack::propagate_covariance() {
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
  const double same = std::exp(-pending_abs_m_ / compass_.bias_length_m);
  F(6, 6) = same;
  bias_rad_ = wrap_angle(first_bias_rad_ + same * wrap_angle(bias_rad_ - first_bias_rad_));
  P_ = F * P_ * F.transpose();
  const double along = squared(model_.along_sigma_m) * pending_abs_m_;
  const double across = squared(model_.across_sigma_m) * pending_abs_m_;
  P_(0, 0) += along * c * c + across * s * s;
  P_(1, 1) += along * s * s + across * c * c;
  P_(0, 1) += (along - across) * c * s;
  P_(1, 0) += (along - across) * c * s;
  P_(2, 2) +=
      squared(model_.heading_sigma_rad) * pending_abs_m_ + squared(model_.turn_sigma_rad) * pending_abs_rad_;
  P_(6, 6) += squared(compass_.bias_sigma_rad) * (1.0 - same * same) +
              squared(compass_.turn_bias_sigma_rad) * pending_abs_rad_;
  pending_m_ = pending_abs_m_ = pending_rad_ = pending_abs_rad_ = 0.0;
  pending_start_m_ = X_MR_.p_m;
}

double PoseTrack::correct(const Row& H, double innovation, double sigma) {
  const double spread = (H * P_ * H.transpose())(0, 0) + squared(sigma);
  const State gain = P_ * H.transpose() / spread;
  const State change = gain * innovation;
  P_ -= gain * (H * P_);
  P_ = ((P_ + P_.transpose()) / 2.0).eval();
  X_MR_.p_m += change.head<2>();
  mark_M_m_ += change.head<2>();
  X_MR_.yaw_rad = wrap_angle(X_MR_.yaw_rad + change(2));
  scale_ += change(3);
  turn_scale_ += change(4);
  curvature_rad_per_m_ += change(5);
  bias_rad_ = wrap_angle(bias_rad_ + change(6));
  pending_start_m_ = X_MR_.p_m;
  return -0.5 * (squared(innovation) / spread + std::log(spread));
}

double PoseTrack::correct_position(const Vec2& direction_M, double value_m, double sigma_m) {
  propagate_covariance();
  touched_m_ = 0.0;
  Row H = Row::Zero();
  H(0, 0) = direction_M.x();
  H(0, 1) = direction_M.y();
  return correct(H, value_m - direction_M.dot(X_MR_.p_m), sigma_m);
}

double PoseTrack::correct_by_compass(double reading_rad) {
  propagate_covariance();
  if (!bias_known_) {
    bias_known_ = true;
    bias_rad_ = first_bias_rad_ = wrap_angle(reading_rad - X_MR_.yaw_rad);
    P_(6, 6) = squared(kPi);
  }
  Row H = Row::Zero();
  H(0, 2) = H(0, 6) = 1.0;
  return correct(H, wrap_angle(reading_rad - X_MR_.yaw_rad - bias_rad_), compass_.noise_sigma_rad);
}

void PoseTrack::doubt(double factor) {
  propagate_covariance();
  const double yaw_factor = std::clamp(kDoubtedYaw_rad / std::sqrt(std::max(P_(2, 2), 1e-9)), 1.0, factor);
  const Eigen::Vector3d wider{factor, factor, yaw_factor};
  assert(factor >= 1.0);
  P_.topLeftCorner<3, 3>() = (wider.asDiagonal() * P_.topLeftCorner<3, 3>() * wider.asDiagonal()).eval();
  P_(6, 6) = squared(compass_.bias_sigma_rad);
  P_.topRightCorner<3, kStates - 3>().setZero();
  P_.bottomLeftCorner<kStates - 3, 3>().setZero();
}

double PoseTrack::position_sigma_m(const Vec2& direction_M) {
  propagate_covariance();
  return std::sqrt(std::max(0.0, direction_M.dot(P_.topLeftCorner<2, 2>() * direction_M)));
}

double PoseTrack::yaw_sigma_rad() {
  propagate_covariance();
  return std::sqrt(std::max(0.0, P_(2, 2)));
}

}  // namespace sensotwin::robot
