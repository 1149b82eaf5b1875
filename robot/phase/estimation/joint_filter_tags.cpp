// SPDX-License-Identifier: MIT
#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <utility>

#include "robot/phase/estimation/joint_filter.hpp"
#include "robot/phase/estimation/joint_filter_layout.hpp"

namespace sensotwin::robot {
namespace {

using namespace joint_filter_layout;

constexpr double kUnknownPhase2 = 1e4;  ///< variance of a phase of which nothing is known
/// Directions are kept within: 29 m away under a ceiling 2.9 m above the antennas.
constexpr double kRim = 0.995;

}  // namespace

void JointFilter::begin_echoes(int j) {
  P_.block(j, j, per_tag_, per_tag_).setZero();
  for (int i = 0; i < echoes_; ++i) {
    x_(j + kEcho + i) = 0.0;
    P_(j + kEcho + i, j + kEcho + i) = echo_variance(i);
  }
}

double JointFilter::echo_variance(int echo) const {
  // The way out and the way back bend alike; with one antenna for both they bend together.
  const double whole = squared(model_.noise.echo_rad);
  return model_.monostatic ? (echo == 0 ? 0.0 : whole) : whole / 2.0;
}

void JointFilter::age_echoes(double frequency_hz) {
  const double before_hz = std::exchange(echo_hz_, frequency_hz);
  const PhaseNoise::Apart apart{.way_m = std::exchange(way_since_read_m_, 0.0),
                                .hop_hz = before_hz > 0.0 ? frequency_hz - before_hz : 0.0};
  const double kept = model_.noise.echo_kept(apart);
  if (echoes_ == 0 || kept == 1.0) {
    return;
  }
  for (int t = 0; t < tags(); ++t) {
    const int j = base_ + per_tag_ * t + kEcho;
    x_.segment(j, echoes_) *= kept;
    P_.block(0, j, n_, echoes_) *= kept;
    P_.block(j, 0, echoes_, n_) *= kept;
    for (int i = 0; i < echoes_; ++i) {
      P_(j + i, j + i) += (1.0 - kept * kept) * echo_variance(i);
    }
  }
}

bool JointFilter::add(const NewTag& tag) {
  assert(!knows(tag.id));
  if (tags() >= kMostTags) {
    return false;
  }
  const int j = n_;
  const double c = std::cos(x_(2));
  const double s = std::sin(x_(2));
  const Vec2 away_M{c * tag.p_R_m.x() - s * tag.p_R_m.y(), s * tag.p_R_m.x() + c * tag.p_R_m.y()};
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  // p_M = p + R(yaw) p_R. What is known of the direction alone puts the tag the further the higher it hangs.
  P_.block(j, 0, 1, j) = P_.block(0, 0, 1, j) - away_M.y() * P_.block(2, 0, 1, j);
  P_.block(j + 1, 0, 1, j) = P_.block(1, 0, 1, j) + away_M.x() * P_.block(2, 0, 1, j);
  x_(j + 3) = 0.0;
  P_.block(j + 2, 0, 2, j).setZero();
  P_.block(j + kEcho, 0, echoes_, j).setZero();
  P_.block(0, j, j, per_tag_) = P_.block(j, 0, per_tag_, j).transpose();
  const double z2 = squared(tag.height_sigma_m);
  const Vec2 by_height = away_M / (tag.height_m - model_.antennas.front().at_R_m.z());
  Eigen::Matrix<double, 2, 3> G;
  G << 1.0, 0.0, -away_M.y(), 0.0, 1.0, away_M.x();
  auto own = P_.block(j, j, per_tag_, per_tag_);
  begin_echoes(j);
  own.topLeftCorner(2, 2) = G * P_.topLeftCorner<3, 3>() * G.transpose() +
                            turn * tag.covariance_R_m2 * turn.transpose() +
                            z2 * by_height * by_height.transpose();
  own.block(0, 2, 2, 1) = z2 * by_height;
  own.block(2, 0, 1, 2) = z2 * by_height.transpose();
  own(2, 2) = z2;
  own(3, 3) = kUnknownPhase2;
  n_ += per_tag_;
  ids_.push_back(tag.id);
  become_directions(tags() - 1, {x_(0) + away_M.x(), x_(1) + away_M.y(), tag.height_m});
  return true;
}

bool JointFilter::restore(int id, const Eigen::Vector3d& p_M_m, const Eigen::Matrix3d& covariance_m2) {
  assert(!knows(id));
  if (tags() >= kMostTags) {
    return false;
  }
  const int j = n_;
  x_(j + 3) = 0.0;
  P_.block(j, 0, per_tag_, j).setZero();
  P_.block(0, j, j, per_tag_).setZero();
  begin_echoes(j);
  P_.block<3, 3>(j, j) = covariance_m2;
  P_(j + 3, j + 3) = kUnknownPhase2;
  n_ += per_tag_;
  ids_.push_back(id);
  become_directions(tags() - 1, p_M_m);
  return true;
}

void JointFilter::remove(int id) {
  const int gone = slot(id);
  assert(gone >= 0);
  const int last = tags() - 1;
  const int j = base_ + per_tag_ * gone;
  const int k = base_ + per_tag_ * last;
  if (gone != last) {
    x_.segment(j, per_tag_) = x_.segment(k, per_tag_);
    // First the columns, then the rows with the moved block's own corner.
    P_.block(0, j, n_, per_tag_) = P_.block(0, k, n_, per_tag_);
    P_.block(j, 0, per_tag_, n_) = P_.block(k, 0, per_tag_, n_);
    ids_[static_cast<std::size_t>(gone)] = ids_.back();
    anchors_M_m_[static_cast<std::size_t>(gone)] = anchors_M_m_[static_cast<std::size_t>(last)];
  }
  ids_.pop_back();
  n_ -= per_tag_;
}

Eigen::Vector3d JointFilter::tag_M_m(int id) const {
  const int s = slot(id);
  const int j = base_ + per_tag_ * s;
  const Vec2 u = x_.segment<2>(j);
  const Vec2 flat = anchors_M_m_[static_cast<std::size_t>(s)] +
                    (x_(j + 2) - antenna_height_m_) / std::sqrt(1.0 - u.squaredNorm()) * u;
  return {flat.x(), flat.y(), x_(j + 2)};
}

Eigen::Matrix3d JointFilter::by_direction(int slot) const {
  const int j = base_ + per_tag_ * slot;
  const Vec2 u = x_.segment<2>(j);
  const double g = 1.0 / std::sqrt(1.0 - u.squaredNorm());
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  J.topLeftCorner<2, 2>() =
      (x_(j + 2) - antenna_height_m_) * (g * Eigen::Matrix2d::Identity() + g * g * g * u * u.transpose());
  J.topRightCorner<2, 1>() = g * u;
  J(2, 2) = 1.0;
  return J;
}

Eigen::Matrix3d JointFilter::tag_covariance(int id) const {
  const Eigen::Matrix3d J = by_direction(slot(id));
  return J * P_.block<3, 3>(state_of(id), state_of(id)) * J.transpose();
}

double JointFilter::anchor_way_m(int slot) const {
  const int j = base_ + per_tag_ * slot;
  return 2.0 * (x_(j + 2) - antenna_height_m_) / std::sqrt(1.0 - x_.segment<2>(j).squaredNorm());
}

Eigen::Matrix4d JointFilter::by_states(int slot) const {
  const int j = base_ + per_tag_ * slot;
  const Vec2 u = x_.segment<2>(j);
  const double g = 1.0 / std::sqrt(1.0 - u.squaredNorm());
  const double k = model_.phase_sign * model_.wave_number(0.0);
  Eigen::Matrix4d J = Eigen::Matrix4d::Identity();
  J.topLeftCorner<3, 3>() = by_direction(slot);
  J.block<1, 2>(3, 0) = -2.0 * k * (x_(j + 2) - antenna_height_m_) * g * g * g * u.transpose();
  J(3, 2) = -2.0 * k * g;
  return J;
}

void JointFilter::become_directions(int slot, const Eigen::Vector3d& p_M_m) {
  const int j = base_ + per_tag_ * slot;
  const Vec2 away = p_M_m.head<2>() - x_.head<2>();
  const double above_m = p_M_m.z() - antenna_height_m_;
  anchors_M_m_[static_cast<std::size_t>(slot)] = x_.head<2>();
  x_.segment<2>(j) = away / std::sqrt(away.squaredNorm() + above_m * above_m);
  x_(j + 2) = p_M_m.z();
  keep_in_disc(j);
  x_(j + 3) += model_.phase_sign * model_.wave_number(0.0) * anchor_way_m(slot);
  turn_states(j, by_states(slot).inverse());
}

void JointFilter::reanchor(int slot) {
  const Eigen::Vector3d p = tag_M_m(id_in_slot(slot));
  const int j = base_ + per_tag_ * slot;
  turn_states(j, by_states(slot));
  x_(j + 3) -= model_.phase_sign * model_.wave_number(0.0) * anchor_way_m(slot);
  become_directions(slot, p);
}

void JointFilter::turn_states(int j, const Eigen::Matrix4d& J) {
  for (int i = 0; i < n_; ++i) {
    const Eigen::Vector4d column = P_.block<4, 1>(j, i);
    P_.block<4, 1>(j, i) = J * column;
  }
  for (int i = 0; i < n_; ++i) {
    const Eigen::RowVector4d row = P_.block<1, 4>(i, j);
    P_.block<1, 4>(i, j) = row * J.transpose();
  }
}

void JointFilter::keep_in_disc(int j) {
  const double u = x_.segment<2>(j).norm();
  if (u > kRim) {
    x_.segment<2>(j) *= kRim / u;
  }
}

void JointFilter::forget_phase(int id) {
  const int j = state_of(id) + 3;
  P_.col(j).head(n_).setZero();
  P_.row(j).head(n_).setZero();
  P_(j, j) = kUnknownPhase2;
}

}  // namespace sensotwin::robot
