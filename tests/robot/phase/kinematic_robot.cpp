// SPDX-License-Identifier: MIT
#include "tests/robot/phase/kinematic_robot.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace sensotwin::robot::testing {
namespace {

/// Mirror walls stand so far from a tag (algorithms study, A.3).
constexpr double kNearestWall_m = 2.0;
constexpr double kFurthestWall_m = 5.0;
/// A compass board says ten sentences a second.
constexpr int kCompassTicks = 7;
/// world/radio_description.hpp: RSSI at one metre and its slope per decade.
constexpr double kRssiAt1m_dbm = -35.0;
constexpr double kRssiSlope_db = -40.0;
constexpr double kLightSpeed_mps = 299792458.0;

double turned_positive(double rad) {
  const double wrapped = std::fmod(rad, 2.0 * kPi);
  return wrapped < 0.0 ? wrapped + 2.0 * kPi : wrapped;
}

}  // namespace

KinematicRobot::KinematicRobot(std::vector<KinematicTag> tags, const Pose2& X_WR,
                               const KinematicErrors& errors, const KinematicRadio& radio, std::uint64_t seed)
    : tags_(std::move(tags)),
      errors_(errors),
      radio_(radio),
      X_WR_(X_WR),
      motion_noise_(RandomStream{seed}.fork("kinematic robot/motion")),
      phase_noise_(RandomStream{seed}.fork("kinematic robot/phase")),
      coin_(RandomStream{seed}.fork("kinematic robot/pi")),
      loss_(RandomStream{seed}.fork("kinematic robot/loss")),
      compass_noise_(RandomStream{seed}.fork("kinematic robot/compass")) {
  RandomStream run = RandomStream{seed}.fork("kinematic robot/run");
  scale_ = run.normal(0.0, errors.scale);
  turn_scale_ = run.normal(0.0, errors.turn_scale);
  curvature_rad_per_m_ = run.normal(0.0, errors.curvature_rad_per_m);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    RandomStream own = RandomStream{seed}.fork("kinematic robot/tag " + std::to_string(i));
    TagSecrets secrets{.offset_rad = own.uniform(0.0, 2.0 * kPi), .images_m = {}};
    for (int image = 0; image < radio_.images; ++image) {
      const double bearing = own.uniform(0.0, 2.0 * kPi);
      const double wall_m = own.uniform(kNearestWall_m, kFurthestWall_m);
      secrets.images_m.emplace_back(2.0 * wall_m * Vec2{std::cos(bearing), std::sin(bearing)});
    }
    secrets_.push_back(std::move(secrets));
  }
}

void KinematicRobot::silence(Instant from, Instant to, bool noticed) {
  silent_from_ = from;
  silent_to_ = to;
  silence_noticed_ = noticed;
}

const PhaseSensed& KinematicRobot::step(const PhaseCommand& command) {
  WheelSpeeds wheels = command.wheels;
  wheels.left_mps = std::clamp(wheels.left_mps, -kTopSpeed_mps, kTopSpeed_mps);
  wheels.right_mps = std::clamp(wheels.right_mps, -kTopSpeed_mps, kTopSpeed_mps);
  const Pose2 X_WR_before = X_WR_;
  const Stride way = stride(wheels);
  sensed_ = PhaseSensed{};
  reads_.clear();
  X_WR_ = along(X_WR_before, way, 1.0);
  driven_m_ += std::abs(way.forward_m);
  count(wheels);
  read_tags(X_WR_before, way);
  now_ += kTick;
  ++ticks_;
  sensed_.stamp = now_;
  sensed_.reads = reads_;
  sensed_.reader_up = !(silence_noticed_ && now_ >= silent_from_ && now_ < silent_to_);
  sense_floor(X_WR_before.p_m);
  if (errors_.compass_rad && ticks_ % kCompassTicks == 0) {
    sensed_.compass_rad =
        wrap_angle(X_WR_.yaw_rad - kPi / 2 + compass_noise_.normal(0.0, *errors_.compass_rad));
  }
  return sensed_;
}

KinematicRobot::Stride KinematicRobot::stride(const WheelSpeeds& wheels) {
  const double dt_s = to_s(kTick);
  const double counted_m = (wheels.left_mps + wheels.right_mps) / 2.0 * dt_s;
  const double counted_rad = (wheels.right_mps - wheels.left_mps) / kWheelBase_m * dt_s;
  const double root_m = std::sqrt(std::abs(counted_m));
  const double forward_m = counted_m * (1.0 + scale_) + errors_.along_m * root_m * motion_noise_.normal();
  const double turn_rad = counted_rad * (1.0 + turn_scale_) + curvature_rad_per_m_ * counted_m +
                          errors_.heading_rad * root_m * motion_noise_.normal();
  return {forward_m, turn_rad};
}

void KinematicRobot::count(const WheelSpeeds& wheels) {
  left_counts_ += wheels.left_mps * to_s(kTick) / kMetresPerCount;
  right_counts_ += wheels.right_mps * to_s(kTick) / kMetresPerCount;
  sensed_.counts_left = static_cast<int>(std::llround(std::floor(left_counts_)) - counted_left_);
  sensed_.counts_right = static_cast<int>(std::llround(std::floor(right_counts_)) - counted_right_);
  counted_left_ += sensed_.counts_left;
  counted_right_ += sensed_.counts_right;
}

Pose2 KinematicRobot::along(const Pose2& X_WR, const Stride& stride, double part) {
  // The chord of a tick's arc differs from the arc by less than 1e-7 m at full speed and turn rate.
  const double turn_rad = part * stride.turn_rad;
  const double middle_rad = X_WR.yaw_rad + turn_rad / 2.0;
  return {X_WR.p_m + part * stride.forward_m * Vec2{std::cos(middle_rad), std::sin(middle_rad)},
          wrap_angle(X_WR.yaw_rad + turn_rad)};
}

void KinematicRobot::read_tags(const Pose2& X_WR_before, const Stride& way) {
  const double period_s = radio_.simultaneous ? 1.0 / radio_.rate_hz : radio_.slot_s;
  for (;;) {
    const Instant at = Instant{} + from_s(static_cast<double>(rounds_) * period_s);
    if (at >= now_ + kTick) {
      return;
    }
    const Pose2 X_WR = along(X_WR_before, way, to_s(at - now_) / to_s(kTick));
    if (radio_.simultaneous) {
      read_port(X_WR, at, 1);
      read_port(X_WR, at, 2);
    } else {
      const auto slots = static_cast<std::int64_t>(radio_.port_order.size());
      read_port(X_WR, at, radio_.port_order[static_cast<std::size_t>(rounds_ % slots)]);
    }
    ++rounds_;
  }
}

double KinematicRobot::slant_m(const KinematicTag& tag, const Vec2& p_W_m, const Vec2& source_m) const {
  return std::hypot((source_m - p_W_m).norm(), tag.height_m - radio_.antenna_height_m);
}

std::complex<double> KinematicRobot::path(std::size_t tag, const Vec2& p_W_m) const {
  const double k = 2.0 * kPi / radio_.wavelength_m;
  std::complex<double> sum = std::polar(1.0, k * slant_m(tags_[tag], p_W_m, tags_[tag].at_m));
  for (const Vec2& image : secrets_[tag].images_m) {
    sum += std::polar(radio_.image_amplitude, k * slant_m(tags_[tag], p_W_m, tags_[tag].at_m + image));
  }
  return sum;
}

void KinematicRobot::read_port(const Pose2& X_WR, Instant at, std::uint16_t port) {
  if (at >= silent_from_ && at < silent_to_) {
    return;
  }
  const bool left = (port == 1) != radio_.cables_swapped;
  const Vec2 antenna_W_m = X_WR * Vec2{0.0, (left ? 0.5 : -0.5) * radio_.spacing_m};
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    const double slant = slant_m(tags_[i], antenna_W_m, tags_[i].at_m);
    if (!tags_[i].present || (radio_.range_m && slant > *radio_.range_m) || loss_.chance(radio_.loss)) {
      continue;
    }
    const std::complex<double> there = path(i, antenna_W_m);
    const std::complex<double> round = there * (radio_.monostatic ? there : path(i, X_WR.p_m));
    const double flip_rad = radio_.pi_ambiguous && coin_.chance(0.5) ? kPi : 0.0;
    const double phase_rad = std::arg(round) + secrets_[i].offset_rad + flip_rad +
                             phase_noise_.normal(0.0, radio_.noise_rad_per_m * slant);
    reads_.push_back({.at = at,
                      .epc = tags_[i].epc,
                      .antenna = port,
                      .channel = 1,
                      .frequency_hz = kLightSpeed_mps / radio_.wavelength_m,
                      .phase_rad = turned_positive(radio_.phase_sign * phase_rad),
                      .rssi_dbm = kRssiAt1m_dbm + kRssiSlope_db * std::log10(slant)});
    ++reads_made_;
  }
}

void KinematicRobot::sense_floor(const Vec2& before_W_m) {
  // The nearest point of the tick's way counts, so that a small zone is not stepped over.
  const Vec2 way = X_WR_.p_m - before_W_m;
  std::optional<std::size_t> over;
  for (std::size_t i = 0; i < tags_.size() && !over; ++i) {
    const Vec2 to_tag = tags_[i].at_m - before_W_m;
    const double part =
        way.squaredNorm() > 0.0 ? std::clamp(to_tag.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
    if (tags_[i].floor_tag && (to_tag - part * way).norm() <= radio_.floor_radius_m) {
      over = i;
    }
  }
  if (over_floor_tag_ && over != over_floor_tag_) {
    sensed_.floor_tag_left = true;
  }
  if (over && over != over_floor_tag_) {
    sensed_.floor_tag = tags_[*over].epc;
  }
  over_floor_tag_ = over;
}

}  // namespace sensotwin::robot::testing
