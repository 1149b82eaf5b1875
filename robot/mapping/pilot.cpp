// SPDX-License-Identifier: MIT
#include "robot/mapping/pilot.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Line law w = -K (psi + atan(e / L)): the prototype's K, and an L of half a tile so that a 3 cm error is
/// gone within a tile (algorithms study, A.4).
constexpr double kTurnGain_1ps = 4.0;
constexpr double kLookahead_m = 0.20;
constexpr double kFollowTurnMax_radps = 1.5;
/// A turn ends here; the line law takes the rest.
constexpr double kTurnDone_rad = 0.009;
/// Slowest useful turn: the wheels' speed steps are 28.5 mm/s (Open Interface, opcode 137), 0.24 rad/s.
constexpr double kTurnMin_radps = 0.25;
/// Pulling free of what holds the shell: so fast, so long at a time, so often.
constexpr double kBreakFree_mps = 0.25;
constexpr Duration kBreakFreeFor = std::chrono::milliseconds{600};
constexpr int kBreakFreeTries = 12;
/// Facing this far off the way it should take, the robot first turns on the spot.
constexpr double kTurnFirst_rad = 0.5;

}  // namespace

void Pilot::command(double speed_mps, double turn_radps) {
  speed_mps_ = speed_mps;
  const double half = turn_radps * config_.odometry.wheel_base_m / 2.0;
  io_.command.wheels = {.left_mps = speed_mps - half, .right_mps = speed_mps + half};
}

double Pilot::ramped(double speed_mps) const {
  const double most = config_.acceleration_mps2 * to_s(kTick);
  return speed_mps_ + std::clamp(speed_mps - speed_mps_, -most, most);
}

double Pilot::stopping_speed_mps(double distance_m) const {
  return distance_m <= 0.0 ? 0.0 : std::sqrt(2.0 * config_.acceleration_mps2 * distance_m);
}

void Pilot::follow(const Line& line, double speed_mps, double left_m) {
  const Pose2& X_MR = navigator_.pose();
  const double across = line.across_m(X_MR.p_m) - left_m;
  const double off = wrap_angle(X_MR.yaw_rad - line.yaw_rad);
  const double sign = speed_mps < 0.0 ? -1.0 : 1.0;
  const double astray = off + sign * std::atan(across / kLookahead_m);
  const double scale = std::abs(astray) > kTurnFirst_rad ? 0.0 : 1.0;
  command(ramped(scale * speed_mps),
          std::clamp(-kTurnGain_1ps * astray, -kFollowTurnMax_radps, kFollowTurnMax_radps));
}

Task<> Pilot::brake() {
  if (bumped()) {
    command(0.0, 0.0);  // against something, every further push turns the body
  }
  while (std::abs(speed_mps_) > 1e-3) {
    command(ramped(0.0), 0.0);
    co_await io_.next;
  }
  command(0.0, 0.0);
  co_await io_.next;
}

Task<> Pilot::turn_to(double yaw_M_rad) {
  co_await brake();
  double turn_radps = 0.0;
  for (;;) {
    const double left_rad = wrap_angle(yaw_M_rad - navigator_.pose().yaw_rad);
    if (std::abs(left_rad) < kTurnDone_rad) {
      break;
    }
    // Half the deceleration the ramp could give: the wheels answer a step late.
    const double fastest = std::sqrt(config_.turn_acceleration_radps2 * std::abs(left_rad));
    const double wanted =
        std::copysign(std::clamp(fastest, kTurnMin_radps, config_.pace.turn_radps), left_rad);
    const double most = config_.turn_acceleration_radps2 * to_s(kTick);
    turn_radps += std::clamp(wanted - turn_radps, -most, most);
    command(0.0, turn_radps);
    co_await io_.next;
  }
  command(0.0, 0.0);
  co_await io_.next;
}

Task<> Pilot::wait_until(Instant when) {
  command(0.0, 0.0);
  while (io_.sensed.stamp < when) {
    co_await io_.next;
  }
}

Task<> Pilot::break_free() {
  // Still pressed after having backed away: the shell is wedged between two things. One wheel at a time pulls
  // and turns at once, which the two of them together do not.
  for (int i = 0; i < kBreakFreeTries && bumped(); ++i) {
    const double speed = (i / 2) % 2 == 0 ? -kBreakFree_mps : kBreakFree_mps;
    const Instant until = io_.sensed.stamp + kBreakFreeFor;
    while (io_.sensed.stamp < until && bumped()) {
      io_.command.wheels = i % 2 == 0 ? WheelSpeeds{speed, 0.0} : WheelSpeeds{0.0, speed};
      co_await io_.next;
    }
  }
  command(0.0, 0.0);
  co_await io_.next;
}

Task<> Pilot::back_along(Line line, double until_m, double left_m) {
  co_await brake();
  for (;;) {
    const double left_to_go = line.along_m(navigator_.pose().p_m) - until_m;
    if (left_to_go <= 0.0) {
      break;
    }
    follow(line, -std::min(config_.careful_speed_mps, stopping_speed_mps(left_to_go) + 0.02), left_m);
    co_await io_.next;
  }
  co_await brake();
  if (bumped()) {
    co_await break_free();
  }
}

}  // namespace sensotwin::robot
