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

/// The outermost ring of components in |u|: 11 m away under a ceiling 2.9 m above the antennas.
constexpr double kOuterRing = 0.967;
/// A component's one sigma in u, in spacings. Chosen: neighbours overlap.
constexpr double kOverlap = 0.6;
constexpr double kWidestSpacing = 0.2;  ///< in u. Chosen: a centimetre's way then changes phases by 0.05 rad
/// Spacings narrower where the ports' phases tell u up to several values: one sigma of a component then is
/// this share of half their period.
constexpr double kPeriodShare = 0.27;
/// Directions are kept within: 13 m away under a ceiling 2.9 m above the antennas. Chosen: beyond, a tag is
/// not steered to.
constexpr double kRim = 0.976;
constexpr double kFinestSpacing = 0.1;  ///< chosen: what kMostComponents hold, both wirings
constexpr double kOutside = 0.96;       ///< a mean direction further out says no more than: far
/// Lighter ones by this factor (its logarithm) are dropped. Chosen: a millionth.
constexpr double kDropLog = 14.0;
/// A read that fits nothing (an outlier) is taken to be this likely.
constexpr double kOutlierShare = 0.05;
constexpr double kGate2 = 25.0;  ///< five sigma squared (algorithms study, A.4)
/// As share of half a period: a phase predicted worse than this cannot be told from its neighbours.
constexpr double kAmbiguousShare = 0.4;
/// Linear enough: one sigma of the place against the slant distance. Chosen: the second-order part of the
/// direction is then below a hundredth.
constexpr double kNarrow = 0.1;
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
  double base_m = 0.0;
  for (const AntennaMount& a : model.antennas) {
    base_m = std::max(base_m, (a.at_R_m - model.antennas.front().at_R_m).norm());
  }
  const double by_u = (model.monostatic ? 2.0 : 1.0) * model.wave_number(0.0) * base_m;
  narrow_u_ = kPeriodShare * model.half_period_rad() / std::max(by_u, 1e-9);
  spacing_ = std::clamp(narrow_u_ / kOverlap, kFinestSpacing, kWidestSpacing);
}

void TagBank::begin(const Pose2& X_OR, double height_m, const Eigen::Vector3d& offsets_rad,
                    const Eigen::Vector3d& offset_variances, bool both_wirings) {
  count_ = 0;
  height_m_ = height_m;
  above_m_ = height_m - model_.antennas.front().at_R_m.z();
  anchor_O_m_ = X_OR.p_m;
  robot_O_m_ = X_OR.p_m;
  pending_m_ = pending_rad_ = driven_m_ = 0.0;
  misfit_ = 1.0;
  reads_ = 0;
  both_wirings_ = both_wirings && model_.antennas.size() >= 2;
  strew(X_OR, false, offsets_rad, offset_variances);
  if (both_wirings_) {
    strew(X_OR, true, offsets_rad, offset_variances);
  }
}

void TagBank::strew(const Pose2& X_OR, bool exchanged, const Eigen::Vector3d& offsets_rad,
                    const Eigen::Vector3d& offset_variances) {
  const int rings = static_cast<int>(std::ceil(kOuterRing / spacing_));
  for (int ring = 0; ring <= rings; ++ring) {
    const double u = kOuterRing * ring / rings;
    const double sigma_away = kOverlap * std::min(spacing_, 1.0 - u);
    const double sigma_side = kOverlap * spacing_;
    const int bearings = std::max(1, static_cast<int>(std::ceil(2.0 * kPi * u / spacing_)));
    for (int i = 0; i < bearings && count_ < kMostComponents; ++i) {
      const double bearing = X_OR.yaw_rad + 2.0 * kPi * i / bearings;
      const Vec2 away{std::cos(bearing), std::sin(bearing)};
      const Vec2 side{-away.y(), away.x()};
      Component& c = components_[count_++];
      c.x = State::Zero(states_);
      c.P = Covariance::Zero(states_, states_);
      c.x.head<2>() = u * away;
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

Vec2 TagBank::place_O_m(const Vec2& u) const {
  return anchor_O_m_ + above_m_ / std::sqrt(1.0 - u.squaredNorm()) * u;
}

Eigen::Matrix2d TagBank::by_direction(const Vec2& u) const {
  const double g = 1.0 / std::sqrt(1.0 - u.squaredNorm());
  return above_m_ * (g * Eigen::Matrix2d::Identity() + g * g * g * u * u.transpose());
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
    const Vec2 away = place_O_m(c.x.head<2>()) - robot_O_m_;
    const Vec2 arm{-away.y(), away.x()};
    const Eigen::Matrix2d to_u = by_direction(c.x.head<2>()).inverse();
    c.P.topLeftCorner<2, 2>() +=
        to_u * (along2 * Eigen::Matrix2d::Identity() + heading2 * arm * arm.transpose()) * to_u.transpose();
  }
  pending_m_ = pending_rad_ = 0.0;
}

void TagBank::weigh(Component& c, const UhfRead& read, const Pose2& X_OR, double noise_scale2,
                    double echo) const {
  const std::size_t port = read.antenna - 1u;
  const std::size_t antenna = c.exchanged && port < 2 ? 1 - port : port;
  const Vec2 p_O_m = place_O_m(c.x.head<2>());
  const WayLength way =
      way_length(way_ends(model_, antenna, Pose2{}), X_OR, {p_O_m.x(), p_O_m.y(), height_m_});
  const double k = model_.phase_sign * model_.wave_number(read.frequency_hz);
  const double centre = model_.phase_sign * model_.wave_number(0.0);
  const double cable_m = 299792458.0 * model_.antennas[port].cable_delay_s;
  // The component's phase is the one expected at the anchor.
  const double g = 1.0 / std::sqrt(1.0 - c.x.head<2>().squaredNorm());
  State H = State::Zero(states_);
  H.head<2>() = k * by_direction(c.x.head<2>()) * way.by_tag.head<2>() -
                2.0 * centre * above_m_ * g * g * g * c.x.head<2>();
  H(2) = 1.0;
  double predicted = k * way.length_m - 2.0 * centre * above_m_ * g + (k - centre) * cable_m + c.x(2);
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
    const double u = c.x.head<2>().norm();
    if (u > kRim) {
      c.x.head<2>() *= kRim / u;
    }
  }
}

void TagBank::read(const UhfRead& read, const Pose2& X_OR, double noise_scale2) {
  spread();
  const std::size_t port = read.antenna - 1u;
  const double before_hz = std::exchange(last_hz_[port], read.frequency_hz);
  const double echo =
      model_.noise.echo_as_noise({.way_m = std::exchange(way_since_read_m_[port], 0.0),
                                  .hop_hz = before_hz > 0.0 ? read.frequency_hz - before_hz : 0.0});
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
  // The mean is taken of directions, not of places: one component that thinks the tag at the end of the world
  // then turns the rest by no more than its weight.
  const Tally t = tally(false);
  Vec2 u{0.0, 0.0};
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < count_; ++i) {
    const Component& c = components_[i];
    if (!c.exchanged) {
      const double share = std::exp(c.log_weight - t.best) / t.sum;
      u += share * c.x.head<2>();
      spread += share * (c.P.topLeftCorner<2, 2>() + c.x.head<2>() * c.x.head<2>().transpose());
    }
  }
  spread -= u * u.transpose();
  const Eigen::Matrix2d J = by_direction(u);
  return {place_O_m(u), J * spread * J.transpose(), u, spread};
}

bool TagBank::settled(const Pose2& X_OR) const {
  if (count_ == 0) {
    return false;
  }
  const Candidate c = place();
  const double slant2 = (c.p_O_m - X_OR.p_m).squaredNorm() + above_m_ * above_m_;
  return c.direction.norm() < kOutside && c.direction_covariance.trace() < narrow_u_ * narrow_u_ &&
         c.covariance_m2.trace() < kNarrow * kNarrow * slant2;
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
