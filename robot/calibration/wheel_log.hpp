// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/mapping/tile.hpp"

namespace sensotwin::robot {

/// What the wheels turned in one control step, in encoder counts.
struct CountedStep {
  std::int16_t left{0};
  std::int16_t right{0};
};

/// The antenna crossed the rim of a tag's read zone.
struct RimCrossing {
  std::size_t step{0};  ///< of WheelLog::steps: after this one it was noticed
  Tile tile;            ///< whose tag it is
  bool entered{true};
  Pose2 X_MR;  ///< where the robot then believed itself: where a fit begins to look
};

/// A closed way over known tags.
struct Lap {
  std::size_t first{0};  ///< of WheelLog::crossings: leaving the first tag
  std::size_t last{0};   ///< coming back to it
  bool clockwise{false};
};

/// All that a drive over known tags leaves to be fitted.
struct WheelLog {
  std::vector<CountedStep> steps;
  std::vector<RimCrossing> crossings;
  std::vector<Lap> laps;
};

}  // namespace sensotwin::robot
