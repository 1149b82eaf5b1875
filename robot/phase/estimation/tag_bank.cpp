// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/tag_bank.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Radii of the rings of components in |u|; the last is 14 m away under a ceiling 2.9 m above the antennas.
constexpr std::array<double, 9> kRings{0.0, 0.2, 0.4, 0.6, 0.76, 0.87, 0.93, 0.96, 0.979};
/// A component's one sigma in u, in spacings. Chosen: neighbours overlap.
constexpr double kOverlap = 0.6;
constexpr double kSpacing = 0.2;  ///< in u. Chosen: a centimetre's way then changes phases by 0.05 rad
/// Lighter ones by this factor (its logarithm) are dropped. Chosen: a millionth.
constexpr double kDropLog = 14.0;
/// A read that fits nothing (an outlier) is taken to be this likely.
constexpr double kOutlierShare = 0.01;
constexpr double kGate2 = 25.0;  ///< five sigma squared (algorithms study, A.4)
/// As share of half a period: a phase predicted worse than this cannot be told from its neighbours.
constexpr double kAmbiguousShare = 0.4;
/// Linear enough: one sigma of the place against the slant distance. Chosen: the second-order part of the
/// direction is then below a hundredth.
constexpr double kNarrow = 0.05;
constexpr double kMisfitMemory = 0.05;  ///< mean over about 20 reads (A.4)
constexpr int kReadsPerJoin = 8;
constexpr std::size_t kJoinable = 160;  ///< pairs are compared below this many

double log_normal(double innovation, double variance) {
  return -0.5 * (innovation * innovation / variance + std::log(2.0 * kPi * variance));
}

}  // namespace

TagBank::TagBank(const PhaseReaderModel& model, const WheelModel& wheels)
    : model_(model), wheels_(wheels), states_(2 + static_cast<int>(model.antennas.size())) {
  assert(!model.antennas.empty() && model.antennas.size() <= PhaseReaderModel::kMostAntennas);
  components_.resize(kMostComponents);
}

void TagBank::begin(const Pose2& X_OR, double height_m, const Eigen::Vector3d& offsets_rad,
                    const Eigen::Vector3d& offset_variances, bool both_wirings) {
  count_ = 0;
  height_m_ = height_m;
  robot_O_m_ = X_OR.p_m;
  pending_m_ = pending_rad_ = driven_m_ = 0.0;
  misfit_ = 1.0;
  reads_ = 0;
  both_wirings_ = both_wirings && model_.antennas.size() == 2;
  strew(X_OR, false, offsets_rad, offset_variances);
  if (both_wirings_) {
    strew(X_OR, true, offsets_rad, offset_variances);
  }
}

void TagBank::strew(const Pose2& X_OR, bool exchanged, const Eigen::Vector3d& offsets_rad,
                    const Eigen::Vector3d& offset_variances) {
  const double above_m = height_m_ - model_.antennas.front().at_R_m.z();
  for (std::size_t ring = 0; ring < kRings.size(); ++ring) {
    const double u = kRings[ring];
    const double slant_m = above_m / std::sqrt(1.0 - u * u);
    const double inner = ring == 0 ? 0.0 : kRings[ring - 1];
    const double outer = ring + 1 < kRings.size() ? kRings[ring + 1] : 2.0 * u - inner;
    const double width_m =
        above_m *
        (outer / std::sqrt(1.0 - std::min(outer * outer, 0.97)) - inner / std::sqrt(1.0 - inner * inner)) /
        2.0;
    const int bearings = std::max(1, static_cast<int>(std::ceil(2.0 * kPi * u / kSpacing)));
    for (int i = 0; i < bearings && count_ < kMostComponents; ++i) {
      const double bearing = X_OR.yaw_rad + 2.0 * kPi * i / bearings;
      const Vec2 away{std::cos(bearing), std::sin(bearing)};
      const Vec2 side{-away.y(), away.x()};
      const double sigma_away = kOverlap * (u == 0.0 ? slant_m * kSpacing : width_m);
      const double sigma_side = kOverlap * slant_m * kSpacing;
      Component& c = components_[count_++];
      c.x = State::Zero(states_);
      c.P = Covariance::Zero(states_, states_);
      c.x.head<2>() = X_OR.p_m + slant_m * u * away;
      c.P.topLeftCorner<2, 2>() = sigma_away * sigma_away * away * away.transpose() +
                                  sigma_side * sigma_side * side * side.transpose();
      c.P(2, 2) = 1e4;  // radians squared: nothing is known of a tag's own phase
      for (int j = 3; j < states_; ++j) {
        c.x(j) = offsets_rad(j - 3);
        c.P(j, j) = offset_variances(j - 3);
      }
      c.log_weight = 0.0;
      c.last_fit = 1.0;
      c.exchanged = exchanged;
    }
  }
}

void TagBank::drive(const WheelStep& step, const Pose2& X_OR) {
  pending_m_ += std::abs(step.forward_m);
  pending_rad_ += std::abs(step.turn_rad);
  driven_m_ += std::abs(step.forward_m);
  for (std::size_t i = 0; i < model_.antennas.size(); ++i) {
    way_since_read_m_[i] +=
        std::abs(step.forward_m) + std::abs(step.turn_rad) * model_.antennas[i].at_R_m.head<2>().norm();
  }
  robot_O_m_ = X_OR.p_m;
}

void TagBank::spread() {
  if (pending_m_ == 0.0 && pending_rad_ == 0.0) {
    return;
  }
  // What stays the same through a run (scale, curvature) is no noise, but over the metre or two of a bank's
  // life it is as large as if it were.
  const double along2 =
      (wheels_.along_sigma_m * wheels_.along_sigma_m + wheels_.scale_sigma * wheels_.scale_sigma) *
      pending_m_;
  const double heading2 = (wheels_.heading_sigma_rad * wheels_.heading_sigma_rad +
                           wheels_.curvature_sigma_rad_per_m * wheels_.curvature_sigma_rad_per_m) *
                              pending_m_ +
                          wheels_.turn_sigma_rad * wheels_.turn_sigma_rad * pending_rad_;
  for (std::size_t i = 0; i < count_; ++i) {
    Component& c = components_[i];
    const Vec2 arm{-(c.x(1) - robot_O_m_.y()), c.x(0) - robot_O_m_.x()};
    c.P.topLeftCorner<2, 2>() += along2 * Eigen::Matrix2d::Identity() + heading2 * arm * arm.transpose();
  }
  pending_m_ = pending_rad_ = 0.0;
}

void TagBank::weigh(Component& c, const UhfRead& read, const Pose2& X_OR, double noise_scale2,
                    double echo) const {
  const std::size_t port = read.antenna - 1u;
  const std::size_t antenna = c.exchanged && port < 2 ? 1 - port : port;
  const WayLength way = way_length(way_ends(model_, antenna, Pose2{}), X_OR, {c.x(0), c.x(1), height_m_});
  const double k = model_.wave_number(read.frequency_hz);
  const double cable_m = 299792458.0 * model_.antennas[port].cable_delay_s;
  State H = State::Zero(states_);
  H.head<2>() = model_.phase_sign * k * way.by_tag.head<2>();
  H(2) = 1.0;
  double predicted =
      model_.phase_sign * (k * way.length_m + (k - model_.wave_number(0.0)) * cable_m) + c.x(2);
  if (port > 0) {
    H(2 + static_cast<int>(port)) = 1.0;
    predicted += c.x(2 + static_cast<int>(port));
  }
  const double noise = noise_scale2 * model_.noise.variance(way.slant_m, read.rssi_dbm) + echo;
  const double innovation = model_.wrap(read.phase_rad - predicted);
  const State PH = c.P * H;
  const double from_state = H.dot(PH);
  const double half = model_.half_period_rad();
  if (from_state > kAmbiguousShare * kAmbiguousShare * half * half) {
    // The prediction says nothing of the phase: the read tells the offset instead, exactly as far as the rest
    // is known.
    const int j = port > 0 && c.P(2 + static_cast<int>(port), 2 + static_cast<int>(port)) > 0.5 * from_state
                      ? 2 + static_cast<int>(port)
                      : 2;
    const State rest = PH - c.P.col(j);
    const double rest_variance = from_state - 2.0 * PH(j) + c.P(j, j);
    c.x(j) += innovation;
    c.P.col(j) = -rest;
    c.P.row(j) = -rest.transpose();
    c.P(j, j) = rest_variance + noise - echo + model_.noise.echo_rad * model_.noise.echo_rad;
    c.log_weight += -std::log(2.0 * half);
    return;
  }
  const double S = from_state + noise;
  const double likelihood =
      (1.0 - kOutlierShare) * std::exp(log_normal(innovation, S)) + kOutlierShare / (2.0 * half);
  c.log_weight += std::log(likelihood);
  c.last_fit = innovation * innovation / S;
  if (c.last_fit < kGate2) {
    c.x += PH * (innovation / S);
    c.P -= PH * PH.transpose() / S;
  }
}

void TagBank::read(const UhfRead& read, const Pose2& X_OR, double noise_scale2) {
  spread();
  const double echo = model_.noise.echo_as_noise(std::exchange(way_since_read_m_[read.antenna - 1u], 0.0));
  for (std::size_t i = 0; i < count_; ++i) {
    weigh(components_[i], read, X_OR, noise_scale2, echo);
  }
  const Tally best = tally(false);
  misfit_ += kMisfitMemory * (std::min(components_[best.index].last_fit, kGate2) - misfit_);
  prune();
  if (++reads_ % kReadsPerJoin == 0 && count_ < kJoinable) {
    join();
  }
}

TagBank::Tally TagBank::tally(bool exchanged) const {
  Tally t;
  for (std::size_t i = 0; i < count_; ++i) {
    if (components_[i].exchanged == exchanged && components_[i].log_weight > t.best) {
      t.best = components_[i].log_weight;
      t.index = i;
    }
  }
  for (std::size_t i = 0; i < count_; ++i) {
    if (components_[i].exchanged == exchanged) {
      t.sum += std::exp(components_[i].log_weight - t.best);
    }
  }
  return t;
}

void TagBank::prune() {
  const double given = tally(false).best;
  const double exchanged = both_wirings_ ? tally(true).best : given;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double best = components_[i].exchanged ? exchanged : given;
    if (components_[i].log_weight > best - kDropLog) {
      if (kept != i) {
        components_[kept] = components_[i];
      }
      ++kept;
    }
  }
  count_ = kept;
}

void TagBank::join() {
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = i + 1; j < count_;) {
      Component& a = components_[i];
      Component& b = components_[j];
      const Vec2 apart = b.x.head<2>() - a.x.head<2>();
      const Eigen::Matrix2d both = a.P.topLeftCorner<2, 2>() + b.P.topLeftCorner<2, 2>();
      if (a.exchanged != b.exchanged || apart.dot(both.inverse() * apart) > 1.0) {
        ++j;
        continue;
      }
      // They have come to the same end: the heavier stands for both.
      const double heavier = std::max(a.log_weight, b.log_weight);
      const double lighter = std::min(a.log_weight, b.log_weight);
      if (b.log_weight > a.log_weight) {
        a = b;
      }
      a.log_weight = heavier + std::log1p(std::exp(lighter - heavier));
      components_[j] = components_[--count_];
    }
  }
}

TagBank::Candidate TagBank::place() const {
  const Tally t = tally(false);
  Candidate sum;
  for (std::size_t i = 0; i < count_; ++i) {
    const Component& c = components_[i];
    if (!c.exchanged) {
      const double share = std::exp(c.log_weight - t.best) / t.sum;
      sum.p_O_m += share * c.x.head<2>();
      sum.covariance_m2 += share * (c.P.topLeftCorner<2, 2>() + c.x.head<2>() * c.x.head<2>().transpose());
    }
  }
  sum.covariance_m2 -= sum.p_O_m * sum.p_O_m.transpose();
  return sum;
}

bool TagBank::settled(const Pose2& X_OR) const {
  if (count_ == 0) {
    return false;
  }
  const Candidate c = place();
  const double above_m = height_m_ - model_.antennas.front().at_R_m.z();
  const double slant2 = (c.p_O_m - X_OR.p_m).squaredNorm() + above_m * above_m;
  static const double reach = getenv("REACH") ? atof(getenv("REACH")) : 100.0;
  static const double nar = getenv("NAR") ? atof(getenv("NAR")) : kNarrow;
  return slant2 < reach * reach && c.covariance_m2.trace() < nar * nar * slant2;
}

double TagBank::exchange_evidence() const {
  if (!both_wirings_ || count_ == 0) {
    return 0.0;
  }
  const Tally given = tally(false);
  const Tally exchanged = tally(true);
  return exchanged.best + std::log(exchanged.sum) - given.best - std::log(given.sum);
}

}  // namespace sensotwin::robot
