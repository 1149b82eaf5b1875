// SPDX-License-Identifier: MIT
#pragma once

/// Where JointFilter's states lie. Private to its two source files.
namespace sensotwin::robot::joint_filter_layout {

inline constexpr int kScale = 3;
inline constexpr int kTurnScale = 4;
inline constexpr int kCurvature = 5;
inline constexpr int kBias = 6;
inline constexpr int kPorts = 7;  ///< offsets of ports 2..; then the cables' errors; then the tags
inline constexpr int kEcho = 4;   ///< in a tag's states, after direction, height and phase

[[nodiscard]] constexpr double squared(double x) {
  return x * x;
}

}  // namespace sensotwin::robot::joint_filter_layout
