// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// The four ways out of a junction. North is chosen on the floor plan, "the North direction on the floor plan
/// for the reference bearing" (Tsukiyama, section 3); it need not be the compass's. Clockwise, so that a step
/// is a right turn.
enum class CompassPoint : std::uint8_t { kNorth, kEast, kSouth, kWest };

inline constexpr std::array<CompassPoint, 4> kCompassPoints{CompassPoint::kNorth, CompassPoint::kEast,
                                                            CompassPoint::kSouth, CompassPoint::kWest};

[[nodiscard]] constexpr CompassPoint turned_right(CompassPoint point, int quarter_turns) {
  return static_cast<CompassPoint>((static_cast<int>(point) + quarter_turns) & 3);
}
[[nodiscard]] constexpr CompassPoint opposite(CompassPoint point) {
  return turned_right(point, 2);
}
/// Quarter turns to the right that lead from one heading to another, the shorter way: -1, 0, 1 or 2.
[[nodiscard]] constexpr int quarter_turns_right(CompassPoint from, CompassPoint to) {
  const int right = (static_cast<int>(to) - static_cast<int>(from)) & 3;
  return right == 3 ? -1 : right;
}

/// Counter-clockwise from the plan's north, in (-pi, pi].
[[nodiscard]] inline double yaw_rad_of(CompassPoint point) {
  return wrap_angle(-0.5 * kPi * static_cast<double>(point));
}
/// The nearest one. \param yaw_rad  counter-clockwise from the plan's north
[[nodiscard]] inline CompassPoint nearest_point(double yaw_rad) {
  return turned_right(CompassPoint::kNorth,
                      static_cast<int>(std::lround(-wrap_angle(yaw_rad) / (0.5 * kPi))));
}

/// 'N', 'E', 'S' or 'W'.
[[nodiscard]] constexpr char letter_of(CompassPoint point) {
  return "NESW"[static_cast<std::size_t>(point)];
}
/// "north" ...: for sentences.
[[nodiscard]] constexpr std::string_view name_of(CompassPoint point) {
  constexpr std::array<std::string_view, 4> kNames{"north", "east", "south", "west"};
  return kNames[static_cast<std::size_t>(point)];
}
/// From "N", "E", "S" or "W", and nothing else.
[[nodiscard]] constexpr std::optional<CompassPoint> compass_point_from(std::string_view text) {
  for (const CompassPoint point : kCompassPoints) {
    if (text.size() == 1 && text[0] == letter_of(point)) {
      return point;
    }
  }
  return std::nullopt;
}

}  // namespace sensotwin::robot
