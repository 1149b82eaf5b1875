// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/joint_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "robot/phase/estimation/joint_filter_layout.hpp"

namespace sensotwin::robot {
namespace {

using namespace joint_filter_layout;

/// As share of half a period: a phase predicted worse than this cannot be told from its neighbours.
constexpr double kAmbiguousShare = 0.4;
/// A tag's direction is told from a place at most this far from the robot. Chosen: a third of the ceiling's
/// height.
constexpr double kAnchored_m = 1.0;
constexpr double kLightSpeed_mps = 299792458.0;

}  // namespace

JointFilter::JointFilter(const PhaseReaderModel& model, const WheelModel& wheels, const CompassTrust& compass)
    : model_(model),
      wheels_(wheels),
      compass_(compass),
      ports_(static_cast<int>(model.antennas.size()) - 1),
      base_(kPorts + ports_ + static_cast<int>(model.antennas.size())),
      echoes_(model.noise.echo_rad > 0.0 ? ports_ + 2 : 0),
      per_tag_(kEcho + echoes_),
      n_(base_),
      x_(Eigen::VectorXd::Zero(base_ + per_tag_ * kMostTags)),
      P_(Eigen::MatrixXd::Zero(base_ + per_tag_ * kMostTags, base_ + per_tag_ * kMostTags)),
      gain_(Eigen::VectorXd::Zero(base_ + per_tag_ * kMostTags)),
      antenna_height_m_(model.antennas.front().at_R_m.z()) {
  assert(ports_ >= 0);
  ids_.reserve(kMostTags);
  P_(kScale, kScale) = squared(wheels.scale_sigma);
  P_(kTurnScale, kTurnScale) = squared(wheels.turn_scale_sigma);
  P_(kCurvature, kCurvature) = squared(wheels.curvature_sigma_rad_per_m);
  for (int i = 0; i < ports_; ++i) {
    const AntennaMount& antenna = model.antennas[static_cast<std::size_t>(i + 1)];
    x_(kPorts + i) = antenna.phase_offset_rad - model.antennas.front().phase_offset_rad;
    P_(kPorts + i, kPorts + i) = squared(antenna.phase_offset_sigma_rad);
  }
  for (int i = 0; i <= ports_; ++i) {
    antenna_arm_m_ += model.antennas[static_cast<std::size_t>(i)].at_R_m.head<2>().norm() / (ports_ + 1);
    P_(kPorts + ports_ + i, kPorts + ports_ + i) = squared(kLightSpeed_mps * model.cable_delay_sigma_s);
  }
}

int JointFilter::slot(int id) const {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (ids_[i] == id) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

WheelStep JointFilter::corrected(const WheelStep& step) const {
  const double forward_m = step.forward_m * (1.0 + x_(kScale));
  return {forward_m, step.turn_rad * (1.0 + x_(kTurnScale)) + x_(kCurvature) * forward_m};
}

void JointFilter::drive(const WheelStep& step) {
  if (step.forward_m == 0.0 && step.turn_rad == 0.0) {
    return;
  }
  const WheelStep way = corrected(step);
  const double middle = x_(2) + way.turn_rad / 2.0;
  const double c = std::cos(middle);
  const double s = std::sin(middle);
  const double d = way.forward_m;
  // Columns: yaw, scale, turn scale, curvature.
  const Eigen::Vector4d turned{1.0, x_(kCurvature) * step.forward_m, step.turn_rad, d};
  Eigen::Vector4d by_x{-d * s, c * step.forward_m, 0.0, 0.0};
  Eigen::Vector4d by_y{d * c, s * step.forward_m, 0.0, 0.0};
  by_x.tail<3>() -= 0.5 * d * s * turned.tail<3>();
  by_y.tail<3>() += 0.5 * d * c * turned.tail<3>();

  x_(0) += d * c;
  x_(1) += d * s;
  x_(2) = wrap_angle(x_(2) + way.turn_rad);
  // P <- F P F': only the pose depends on anything but itself. By columns, then by rows.
  const auto sum_of = [](const auto& m, const Eigen::Vector4d& by) {
    return (m.col(2) * by(0) + m.col(kScale) * by(1) + m.col(kTurnScale) * by(2) + m.col(kCurvature) * by(3))
        .eval();
  };
  auto P = P_.topLeftCorner(n_, n_);
  gain_.head(n_).noalias() = P.col(2) * by_x(0) + P.col(kScale) * by_x(1) + P.col(kTurnScale) * by_x(2) +
                             P.col(kCurvature) * by_x(3);
  P.col(0) += gain_.head(n_);
  gain_.head(n_).noalias() = P.col(2) * by_y(0) + P.col(kScale) * by_y(1) + P.col(kTurnScale) * by_y(2) +
                             P.col(kCurvature) * by_y(3);
  P.col(1) += gain_.head(n_);
  gain_.head(n_).noalias() =
      P.col(kScale) * turned(1) + P.col(kTurnScale) * turned(2) + P.col(kCurvature) * turned(3);
  P.col(2) += gain_.head(n_);
  // The pose's rows of what is not pose are its columns; the corner needs the rows' turn as well.
  const Eigen::Matrix<double, 7, 7> corner = P.topLeftCorner<7, 7>();
  const Eigen::Matrix<double, 7, 7> across = corner.transpose();
  Eigen::Matrix3d pose = corner.topLeftCorner<3, 3>();
  pose.row(0) += sum_of(across, by_x).head<3>().transpose();
  pose.row(1) += sum_of(across, by_y).head<3>().transpose();
  Eigen::Vector4d only = turned;
  only(0) = 0.0;
  pose.row(2) += sum_of(across, only).head<3>().transpose();
  P.topRightCorner(3, n_ - 3) = P.bottomLeftCorner(n_ - 3, 3).transpose();
  P.topLeftCorner<3, 3>() = 0.5 * (pose + pose.transpose());

  const double way_m = std::abs(d);
  const double turn_rad = std::abs(way.turn_rad);
  way_since_read_m_ += way_m + antenna_arm_m_ * turn_rad;
  const double along2 = squared(wheels_.along_sigma_m) * way_m;
  const double across2 = squared(wheels_.across_sigma_m) * way_m;
  P_(0, 0) += along2 * c * c + across2 * s * s;
  P_(1, 1) += along2 * s * s + across2 * c * c;
  P_(0, 1) += (along2 - across2) * c * s;
  P_(1, 0) = P_(0, 1);
  P_(2, 2) += squared(wheels_.heading_sigma_rad) * way_m + squared(wheels_.turn_sigma_rad) * turn_rad;
  P_(kBias, kBias) +=
      squared(compass_.bias_walk_rad) * way_m + squared(compass_.turn_bias_walk_rad) * turn_rad;
}

void JointFilter::touch() {
  P_(0, 0) += squared(wheels_.touch_sigma_m);
  P_(1, 1) += squared(wheels_.touch_sigma_m);
  P_(2, 2) += squared(wheels_.touch_sigma_rad);
}

double JointFilter::project(const SparseRow& H) {
  gain_.head(n_).setZero();
  for (int i = 0; i < H.size; ++i) {
    const auto j = static_cast<std::size_t>(i);
    gain_.head(n_) += H.by[j] * P_.col(H.at[j]).head(n_);
  }
  double variance = 0.0;
  for (int i = 0; i < H.size; ++i) {
    const auto j = static_cast<std::size_t>(i);
    variance += H.by[j] * gain_(H.at[j]);
  }
  return variance;
}

void JointFilter::correct(double innovation, double variance) {
  x_.head(n_) += gain_.head(n_) * (innovation / variance);
  x_(2) = wrap_angle(x_(2));
  for (int j = base_; j < n_; j += per_tag_) {
    keep_in_disc(j);
  }
  for (int j = 0; j < n_; ++j) {
    P_.col(j).head(n_) -= gain_.head(n_) * (gain_(j) / variance);
  }
}

void JointFilter::set_offset(int j, double innovation, double from_state, double noise) {
  // offset = phase - rest: known exactly as far as the rest is.
  const double own = P_(j, j);
  const double rest_variance = from_state - 2.0 * gain_(j) + own;
  gain_.head(n_) -= P_.col(j).head(n_);
  x_(j) += innovation;
  P_.col(j).head(n_) = -gain_.head(n_);
  P_.row(j).head(n_) = -gain_.head(n_).transpose();
  P_(j, j) = rest_variance + noise;
}

void JointFilter::correct_by_compass(double reading_rad) {
  SparseRow H;
  H.add(2, 1.0);
  H.add(kBias, 1.0);
  const double innovation = wrap_angle(reading_rad - x_(2) - x_(kBias));
  const double from_state = project(H);
  const double noise = squared(compass_.noise_sigma_rad);
  if (!compass_known_) {
    set_offset(kBias, innovation, from_state, noise);
    compass_known_ = true;
    return;
  }
  correct(innovation, from_state + noise);
}

PhasePrediction JointFilter::predict(int id, const UhfRead& read, const Pose2& X_now_then) const {
  const int port = read.antenna - 1;
  const int j = state_of(id);
  const AntennaMount& mount = model_.antennas[static_cast<std::size_t>(port)];
  const WayLength way =
      way_length(way_ends(model_, static_cast<std::size_t>(port), X_now_then), pose(), tag_M_m(id));
  const Eigen::Matrix4d by_states = this->by_states(slot(id));
  const double k = model_.phase_sign * model_.wave_number(read.frequency_hz);
  const double hop = k - model_.phase_sign * model_.wave_number(0.0);
  const int cable = kPorts + ports_ + port;
  PhasePrediction p;
  p.slant_m = way.slant_m;
  const double centre = k - hop;
  Eigen::Vector3d by_tag = k * by_states.topLeftCorner<3, 3>().transpose() * way.by_tag;
  by_tag += by_states.bottomLeftCorner<1, 3>().transpose();
  p.phase_rad = k * way.length_m - centre * anchor_way_m(slot(id)) +
                hop * (kLightSpeed_mps * mount.cable_delay_s + x_(cable)) + x_(j + 3);
  for (int i = 0; i < 3; ++i) {
    p.H.add(i, k * way.by_pose(i));
    p.H.add(j + i, by_tag(i));
  }
  p.H.add(j + 3, 1.0);
  p.H.add(cable, hop);
  if (echoes_ > 0) {
    p.H.add(j + kEcho + 1 + port, 1.0);
    p.phase_rad += x_(j + kEcho + 1 + port);
    if (!model_.monostatic) {
      p.H.add(j + kEcho, 1.0);
      p.phase_rad += x_(j + kEcho);
    }
  }
  if (port > 0) {
    p.H.add(kPorts + port - 1, 1.0);
    p.phase_rad += x_(kPorts + port - 1);
  }
  return p;
}

JointFilter::Outcome JointFilter::read(int id, const UhfRead& read, const Pose2& X_now_then,
                                       double noise_scale2, double gate_sigmas) {
  age_echoes(read.frequency_hz);
  const int s = slot(id);
  if ((x_.head<2>() - anchors_M_m_[static_cast<std::size_t>(s)]).squaredNorm() > squared(kAnchored_m)) {
    reanchor(s);
  }
  const PhasePrediction p = predict(id, read, X_now_then);
  Outcome out;
  out.innovation_rad = model_.wrap(read.phase_rad - p.phase_rad);
  out.noise = noise_scale2 * model_.noise.variance(p.slant_m, read.rssi_dbm);
  const double from_state = project(p.H);
  out.variance = from_state + out.noise;
  if (from_state > squared(kAmbiguousShare * model_.half_period_rad())) {
    const int offset = state_of(id) + 3;
    const int port = read.antenna > 1 ? kPorts + read.antenna - 2 : offset;
    set_offset(P_(port, port) > 0.5 * from_state ? port : offset, out.innovation_rad, from_state, out.noise);
    out.fate = Fate::kOffsetSet;
  } else if (squared(out.innovation_rad) > squared(gate_sigmas) * out.variance) {
    out.fate = Fate::kRejected;
  } else {
    correct(out.innovation_rad, out.variance);
  }
  return out;
}

void JointFilter::inform(int id, const UhfRead& read) {
  age_echoes(read.frequency_hz);
  const PhasePrediction p = predict(id, read, Pose2{});
  const double from_state = project(p.H);
  correct(0.0, from_state + model_.noise.variance(p.slant_m, read.rssi_dbm));
}

void JointFilter::fix_over(int id, const Vec2& offset_M_m, const Vec2& along_M, double along_sigma_m,
                           double across_sigma_m) {
  const Vec2 across_M{-along_M.y(), along_M.x()};
  for (const bool along : {true, false}) {
    const Vec2& n = along ? along_M : across_M;
    const int j = state_of(id);
    SparseRow H;
    H.add(0, n.x());
    H.add(1, n.y());
    const Eigen::Vector3d by_tag = by_direction(slot(id)).transpose() * Eigen::Vector3d{n.x(), n.y(), 0.0};
    for (int i = 0; i < 3; ++i) {
      H.add(j + i, -by_tag(i));
    }
    const Vec2 now = x_.head<2>() - tag_M_m(id).head<2>();
    const double from_state = project(H);
    correct(n.dot(offset_M_m - now), from_state + squared(along ? along_sigma_m : across_sigma_m));
  }
}

Eigen::Vector3d JointFilter::port_offsets_rad() const {
  Eigen::Vector3d offsets = Eigen::Vector3d::Zero();
  offsets.head(ports_) = x_.segment(kPorts, ports_);
  return offsets;
}

Eigen::Vector3d JointFilter::port_offset_variances() const {
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
  variances.head(ports_) = P_.diagonal().segment(kPorts, ports_);
  return variances;
}

double JointFilter::sigma_m(const Vec2& by_robot, std::span<const TagPull> pulls) const {
  std::array<std::pair<int, double>, 2 + 3 * kMostTags> row{{{0, by_robot.x()}, {1, by_robot.y()}}};
  std::size_t size = 2;
  for (const TagPull& pull : pulls) {
    if (knows(pull.id)) {
      const Eigen::Vector3d by_states =
          by_direction(slot(pull.id)).transpose() * Eigen::Vector3d{pull.by_tag.x(), pull.by_tag.y(), 0.0};
      for (int i = 0; i < 3 && size < row.size(); ++i) {
        row[size++] = {state_of(pull.id) + i, by_states(i)};
      }
    }
  }
  double variance = 0.0;
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      variance += row[a].second * row[b].second * P_(row[a].first, row[b].first);
    }
  }
  return std::sqrt(std::max(variance, 0.0));
}

double JointFilter::across_sigma_m(const Vec2& n_M, int from, int to, double part) const {
  const std::array<TagPull, 2> pulls{{{from, -(1.0 - part) * n_M}, {to, -part * n_M}}};
  return sigma_m(n_M, pulls);
}

}  // namespace sensotwin::robot
