// SPDX-License-Identifier: MIT
#include "robot/program/mode_keeper.hpp"

namespace sensotwin::robot {

void ModeKeeper::step(Roomba& base, const RoombaState& state) {
  const bool docked =
      state.charging != oi::ChargingState::kNotCharging ||
      (state.extended && (state.extended->on_home_base || state.extended->on_internal_charger));
  if (base.status() != RoombaStatus::kStreamLost) {
    silent_steps_ = 0;
  } else if (++silent_steps_ >= kSilentSteps) {
    silent_steps_ = 0;
    base.rearm();
    return;
  }
  const bool lifted = state.wheel_drop_left || state.wheel_drop_right;
  const bool waiting = base.status() == RoombaStatus::kModeLost || base.status() == RoombaStatus::kStarting;
  if (docked && waiting && !undocking_) {
    undocking_ = true;
    base.rearm(oi::Mode::kFull);
  } else if (base.status() == RoombaStatus::kModeLost && !lifted) {
    base.rearm();
  } else if (undocking_ && !docked) {
    undocking_ = false;
    base.rearm(mode_);
  }
}

}  // namespace sensotwin::robot
