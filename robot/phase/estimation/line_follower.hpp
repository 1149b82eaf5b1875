// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/geometry.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/phase/estimation/tag_path.hpp"

namespace sensotwin::robot {

/// How the robot moves along its path.
struct FollowerConfig {
  double speed_mps{0.2};  ///< Gueaieb & Miah, section V
  /// Brakes to the corner and turns on the spot; else drives through at speed_mps.
  bool stop_at_corners{false};
  double braking_mps2{0.5};  ///< chosen: from 0.2 m/s in 4 cm; robot/mapping asks 0.8 of the same wheels
  double turn_radps{3.0};    ///< on the spot. Chosen: 0.35 m/s at the wheels
  double turn_braking_radps2{8.0};  ///< as robot/mapping asks of the same wheels
  /// Corners sharper than this are stopped at.
  double corner_rad{rad_from_deg(8.0)};
  double gain_per_s{8.0};     ///< K of the law (A.4, its sharper pair)
  double look_ahead_m{0.15};  ///< L of the law (same)
  /// At constant speed the next leg begins this far before the corner, times the tangent of a quarter of the
  /// corner's angle.
  double corner_lead_m{0.03};
  double wheel_base_m{0.235};
  double top_wheel_mps{0.5};  ///< Create 2 Open Interface 2016, opcode 145
};

/// The wheels for a speed and a turn rate, the turn rate cut to what the faster wheel can do.
[[nodiscard]] WheelSpeeds wheels_for(const FollowerConfig& config, double speed_mps, double turn_radps);

/// One step along a path: turn rate = speed curvature - K (psi + atan(e / L)), psi the heading against the
/// tangent, e the error to the left (algorithms study, A.4 and A.5).
[[nodiscard]] WheelSpeeds follow(const FollowerConfig& config, const PathReference& reference, double yaw_rad,
                                 double speed_mps);

/// One step of turning on the spot. \param error_rad  yet to turn
[[nodiscard]] WheelSpeeds turn_in_place(const FollowerConfig& config, double error_rad);

/// The speed from which the robot still stops within `distance_m`, at most the configured.
[[nodiscard]] double stopping_speed_mps(const FollowerConfig& config, double distance_m);

}  // namespace sensotwin::robot
