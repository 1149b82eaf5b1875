// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "robot/base/time.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// The paper's robot has seven rangefinders (Tsukiyama, section 4).
inline constexpr std::size_t kSonars = 7;
using SonarRanges = std::array<std::optional<double>, kSonars>;

/// What a hallway mission knows of the present control step: the drivers' words, no more.
struct HallwaySensed {
  Instant stamp;
  /// Wheel rotation since the last step, in encoder counts, the wrap solved.
  int counts_left{0};
  int counts_right{0};
  bool bump_left{false};
  bool bump_right{false};
  /// A new compass reading: counter-clockwise angle of the robot's nose from magnetic north.
  std::optional<double> compass_rad;
  /// A new round of the rangefinders, m from the transducers, left to right; nothing inside: no echo.
  std::optional<SonarRanges> ranges_m;
  /// The reader came upon a tag in this step.
  std::optional<TagNumber> tag;
};

/// Holds until the next step.
struct HallwayCommand {
  WheelSpeeds wheels;
};

}  // namespace sensotwin::robot
