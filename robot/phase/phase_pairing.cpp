// SPDX-License-Identifier: MIT
#include "robot/phase/phase_pairing.hpp"

#include <algorithm>
#include <cmath>

#include "robot/phase/phase_angle.hpp"

namespace sensotwin::robot {

void PhasePairing::follow(const Epc& tag) {
  tag_ = tag;
  sides_ = {};
  last_read_.reset();
}

std::optional<PhasePair> PhasePairing::add(const UhfRead& read) {
  const bool left = read.antenna == config_.left_port;
  if (read.epc != tag_ || (!left && read.antenna != config_.right_port)) {
    return std::nullopt;
  }
  last_read_ = read.at;
  const std::size_t own = left ? 0 : 1;
  Side& side = sides_[own];
  Side& other = sides_[1 - own];
  side.newest = Reading{read.at, read.channel, at_antenna_rad(read)};
  side.fresh = true;
  std::optional<PhasePair> pair;
  switch (config_.pairing) {
    case Pairing::kSameInstant:
      pair = of_newest(config_.same_instant);
      break;
    case Pairing::kLatest:
      pair = of_newest(config_.longest_gap);
      break;
    case Pairing::kInterpolated:
      pair = interpolated(own);
      break;
  }
  other.before_other = other.newest;
  return pair;
}

double PhasePairing::at_antenna_rad(const UhfRead& read) const {
  const double delay_s = read.antenna == config_.left_port ? config_.left_delay_s : config_.right_delay_s;
  return config_.phase_sign * read.phase_rad - 2.0 * kPi * std::fmod(read.frequency_hz * delay_s, 1.0);
}

bool PhasePairing::together(const Reading& a, const Reading& b, Duration within) const {
  return a.channel == b.channel && std::max(a.at - b.at, b.at - a.at) <= within;
}

double PhasePairing::difference(double left_rad, double right_rad) const {
  return config_.pi_ambiguous ? phase_difference_modulo_pi(left_rad, right_rad)
                              : phase_difference(left_rad, right_rad);
}

std::optional<PhasePair> PhasePairing::of_newest(Duration within) {
  Side& left = sides_[0];
  Side& right = sides_[1];
  if (!left.fresh || !right.fresh || !together(*left.newest, *right.newest, within)) {
    return std::nullopt;
  }
  left.fresh = false;
  right.fresh = false;
  return PhasePair{std::max(left.newest->at, right.newest->at),
                   difference(left.newest->phase_rad, right.newest->phase_rad)};
}

std::optional<PhasePair> PhasePairing::interpolated(std::size_t side) {
  const std::optional<Reading>& first = sides_[side].before_other;
  const Reading& last = *sides_[side].newest;
  Side& between = sides_[1 - side];
  if (!first || !between.fresh || !together(*first, last, config_.longest_gap) ||
      between.newest->channel != last.channel || first->at >= last.at) {
    return std::nullopt;
  }
  between.fresh = false;
  const Reading& middle = *between.newest;
  const double part = to_s(middle.at - first->at) / to_s(last.at - first->at);
  const double phase_rad = first->phase_rad + part * difference(last.phase_rad, first->phase_rad);
  return PhasePair{middle.at, side == 0 ? difference(phase_rad, middle.phase_rad)
                                        : difference(middle.phase_rad, phase_rad)};
}

}  // namespace sensotwin::robot
