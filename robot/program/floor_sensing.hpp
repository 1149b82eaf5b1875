// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <variant>

#include "robot/drivers/roomba_state.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/mapping/mission_io.hpp"

namespace sensotwin::robot {

/// What the antenna under the robot said since the last control step.
inline void take_floor_tags(TagReader& reader, Sensed& sensed) {
  while (const auto event = reader.next_event()) {
    if (std::holds_alternative<TagEntered>(*event)) {
      sensed.tag_entered = true;
    } else if (const auto* identified = std::get_if<TagIdentified>(&*event)) {
      sensed.tag_identified = identified->uid;
    } else if (std::holds_alternative<TagLeft>(*event)) {
      // What was said of a tag that has already gone is taken back: the mission sees the field as it is now.
      sensed.tag_left = !sensed.tag_entered;
      sensed.tag_entered = false;
      sensed.tag_identified.reset();
    } else if (const auto* written = std::get_if<WriteOutcome>(&*event)) {
      sensed.write_ended = TileWriteEnded{written->uid, written->result.has_value()};
    }
  }
}

/// What the mainboard says of the floor and of what stands round the robot.
inline void take_surroundings(const RoombaState& state, Sensed& sensed) {
  sensed.cliff = std::any_of(state.cliff.begin(), state.cliff.end(), [](bool hole) { return hole; });
  sensed.wheel_drop = state.wheel_drop_left || state.wheel_drop_right;
  sensed.virtual_wall = state.virtual_wall;
  if (state.light_bumper) {
    sensed.light_bump = state.light_bumper->signal;
  }
}

}  // namespace sensotwin::robot
