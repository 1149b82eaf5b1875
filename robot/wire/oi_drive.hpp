// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/wheel_speeds.hpp"
#include "robot/wire/oi_commands.hpp"

namespace sensotwin::robot::oi {

/// What a Drive command asks of the wheels: v (1 -+ (b/2) / R) left and right for a turning circle of radius
/// R and a wheel base b, with the special radii of page 13. In place, v is the speed of each wheel. Radius 0
/// is left open by the manual: straight. \param wheel_base_m      0.235 for the Create 2, 0.258 for the
/// Roomba 400 \param straight_is_0x8000_only  SCI: 0x7FFF is a radius of 32.767 m
[[nodiscard]] WheelSpeeds wheel_speeds(const Drive& drive, double wheel_base_m,
                                       bool straight_is_0x8000_only = false);

/// The Drive command nearest to `wheels`, for robots without Drive Direct. Radii above 2 m become straight or
/// 2 m, whichever turns nearer; radii below 2 mm are taken for a turn in place, speeds are clamped to 0.5
/// m/s.
[[nodiscard]] Drive drive_for(const WheelSpeeds& wheels, double wheel_base_m);

/// Drive Direct to the nearest mm/s, clamped to 0.5 m/s.
[[nodiscard]] DriveDirect drive_direct_for(const WheelSpeeds& wheels);
[[nodiscard]] WheelSpeeds wheel_speeds(const DriveDirect& drive);

}  // namespace sensotwin::robot::oi
