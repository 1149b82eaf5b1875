// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/drivers/uhf_read.hpp"

namespace sensotwin::robot {

/// What a phase mission knows of the present control step: the drivers' words, no more.
struct PhaseSensed {
  Instant stamp;
  /// Wheel rotation since the last step, in encoder counts, the wrap solved.
  int counts_left{0};
  int counts_right{0};
  bool bump_left{false};
  bool bump_right{false};
  /// A new compass reading: counter-clockwise angle of the robot's nose from magnetic north.
  std::optional<double> compass_rad;
  /// What the UHF reader reported since the last step, in order of time. Valid for this step only.
  std::span<const UhfRead> reads;
  /// False while the UHF reader is not heard (unplugged, restarting).
  bool reader_up{true};
  /// The short-range floor antenna came upon a floor tag in this step, which names the ceiling tag above it;
  /// and it left one.
  std::optional<Epc> floor_tag;
  bool floor_tag_left{false};
};

/// Holds until the next step.
struct PhaseCommand {
  WheelSpeeds wheels;
};

}  // namespace sensotwin::robot
