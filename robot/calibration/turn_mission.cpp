// SPDX-License-Identifier: MIT
#include "robot/calibration/turn_mission.hpp"

#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/base/rolled_wheels.hpp"

namespace sensotwin::robot {
namespace {

/// Slower at the end of a turn, so that it stops where it should. Chosen: the last quarter turn.
constexpr double kBrake_rad = kPi / 2.0;
constexpr double kBraked = 0.3;

}  // namespace

TurnMission::TurnMission(const OdometryModel& wheels, const TurnPlan& plan)
    : wheels_(wheels), plan_(plan), task_(run()) {}

WheelSpeeds TurnMission::step(const Sensed& sensed) {
  sensed_ = sensed;
  const RolledWheels rolled = rolled_m(wheels_, sensed.counts_left, sensed.counts_right);
  turned_rad_ += (rolled.right_m - rolled.left_m) / wheels_.wheel_base_m;
  if (!done() && (sensed.wheel_drop || sensed.cliff)) {
    fault_ = TurnFault::kLifted;
  } else if (!done() && (sensed.bump_left || sensed.bump_right)) {
    fault_ = TurnFault::kBumped;
  }
  if (done()) {
    return {};
  }
  if (!started_) {
    started_ = true;
    task_.start();
  } else {
    next_step_.resume();
  }
  return done() ? WheelSpeeds{} : command_;
}

Task<> TurnMission::run() {
  for (std::size_t which = 0; which < 2; ++which) {
    co_await turn(which);
    if (fault_ != TurnFault::kNone) {
      co_return;
    }
  }
  const double base_m = 0.5 * (wheel_base_m_[0] + wheel_base_m_[1]);
  const double back_rad = -wrap_angle(off_rad_) * base_m / wheels_.wheel_base_m;
  co_await turn_by(back_rad);
}

Task<> TurnMission::turn_by(double angle_rad) {
  const double sign = angle_rad > 0.0 ? 1.0 : -1.0;
  const double begin_rad = turned_rad_;
  double rest_rad = std::abs(angle_rad);
  while (rest_rad > 0.0) {
    const double rate_radps = plan_.turn_radps * (rest_rad < kBrake_rad ? kBraked : 1.0);
    const double wheel_mps = sign * rate_radps * wheels_.wheel_base_m / 2.0;
    command_ = {.left_mps = -wheel_mps, .right_mps = wheel_mps};
    co_await next_step_;
    rest_rad = std::abs(angle_rad) - sign * (turned_rad_ - begin_rad);
  }
  command_ = {};
}

Task<std::optional<double>> TurnMission::heading() {
  command_ = {};
  const Instant begin = sensed_.stamp + plan_.settle;
  const Instant end = begin + plan_.average;
  double sines = 0.0;
  double cosines = 0.0;
  while (sensed_.stamp < end) {
    if (sensed_.stamp >= begin && sensed_.compass_rad) {
      sines += std::sin(*sensed_.compass_rad);
      cosines += std::cos(*sensed_.compass_rad);
    }
    co_await next_step_;
  }
  if (sines == 0.0 && cosines == 0.0) {
    co_return std::nullopt;
  }
  co_return std::atan2(sines, cosines);
}

Task<> TurnMission::turn(std::size_t which) {
  const double sign = which == 0 ? 1.0 : -1.0;
  const std::optional<double> before = co_await heading();
  const double begin_rad = turned_rad_;
  const double goal_rad = plan_.turns * 2.0 * kPi;
  const double way_rad = sign * goal_rad;
  co_await turn_by(way_rad);
  const std::optional<double> after = co_await heading();
  if (!before || !after) {
    fault_ = TurnFault::kNoCompass;
    co_return;
  }
  const double encoders_rad = turned_rad_ - begin_rad;
  const double true_rad = sign * goal_rad + wrap_angle(*after - *before);
  off_rad_ += wrap_angle(*after - *before);
  wheel_base_m_[which] = wheels_.wheel_base_m * encoders_rad / true_rad;
}

}  // namespace sensotwin::robot
