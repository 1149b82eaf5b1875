// SPDX-License-Identifier: MIT
#pragma once

#include "robot/drivers/roomba.hpp"

namespace sensotwin::robot {

/// Keeps a Roomba ready to drive. A hole or a lifted wheel makes it leave safe mode: it is armed again as
/// soon as nothing forbids it. Off a home base only full mode drives, kept as long as its contacts are
/// touched. One that fell silent is started again.
class ModeKeeper {
 public:
  /// \param mode  wanted away from a home base
  explicit ModeKeeper(oi::Mode mode) : mode_(mode) {}

  /// Once a step, after the base's own. \param state  of the last good frame
  void step(Roomba& base, const RoombaState& state);

 private:
  /// Without a frame for so many steps, the start-up is said again: the robot may have lost its power, or its
  /// port. Chosen: a second; a stall is over by then.
  static constexpr int kSilentSteps = 67;

  oi::Mode mode_;
  int silent_steps_{0};
  bool undocking_{false};
};

}  // namespace sensotwin::robot
