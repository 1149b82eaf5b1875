// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/line_follower.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Slower than this a braking robot does not get: it comes to its point instead of creeping up to it.
constexpr double kCreep_mps = 0.02;
constexpr double kCreep_radps = 0.1;

}  // namespace

WheelSpeeds wheels_for(const FollowerConfig& config, double speed_mps, double turn_radps) {
  const double room_mps = std::max(config.top_wheel_mps - std::abs(speed_mps), 0.0);
  const double difference = std::clamp(turn_radps * config.wheel_base_m / 2.0, -room_mps, room_mps);
  return {speed_mps - difference, speed_mps + difference};
}

WheelSpeeds follow(const FollowerConfig& config, const PathReference& reference, double yaw_rad,
                   double speed_mps) {
  const double psi = wrap_angle(yaw_rad - reference.yaw_rad);
  const double want = psi + std::atan(reference.across_m / config.look_ahead_m);
  // On the way to a far-off path the two do not add up to more than turning round.
  const double error = std::clamp(want, -kPi, kPi);
  return wheels_for(config, speed_mps, speed_mps * reference.curvature_per_m - config.gain_per_s * error);
}

WheelSpeeds turn_in_place(const FollowerConfig& config, double error_rad) {
  const double rate = std::clamp(std::sqrt(2.0 * config.turn_braking_radps2 * std::abs(error_rad)) / 1.5,
                                 kCreep_radps, config.turn_radps);
  return wheels_for(config, 0.0, std::copysign(rate, error_rad));
}

double stopping_speed_mps(const FollowerConfig& config, double distance_m) {
  return std::clamp(std::sqrt(2.0 * config.braking_mps2 * std::max(distance_m, 0.0)), kCreep_mps,
                    config.speed_mps);
}

}  // namespace sensotwin::robot
