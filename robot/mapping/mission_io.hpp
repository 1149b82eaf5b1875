// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/base/bytes.hpp"
#include "robot/base/time.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// End of a write that the mission asked for: verified by reading back, or not done.
struct TileWriteEnded {
  TagUid tag{0};
  bool verified{false};
};

/// What the mission knows of the present control step: the drivers' words, no more.
struct Sensed {
  Instant stamp;
  /// Wheel rotation since the last step, in encoder counts, the wrap solved.
  int counts_left{0};
  int counts_right{0};
  bool bump_left{false};
  bool bump_right{false};
  bool cliff{false};
  bool wheel_drop{false};
  bool virtual_wall{false};
  /// Light bumper, left to right, 0..4095.
  std::array<std::uint16_t, 6> light_bump{};
  /// A new compass reading: counter-clockwise angle of the robot's nose from magnetic north.
  std::optional<double> compass_rad;
  /// The floor antenna's reader noticed in this step that a tag left the field, that one came, which one it
  /// is.
  bool tag_left{false};
  bool tag_entered{false};
  std::optional<TagUid> tag_identified;
  std::optional<TileWriteEnded> write_ended;
};

/// Coordinates to be written to the tag in the floor antenna's field, if it is still that tag.
struct TileWrite {
  TagUid tag{0};
  Tile tile;
};

/// Holds until the next step.
struct Command {
  WheelSpeeds wheels;
  /// Set for one step: begin this write.
  std::optional<TileWrite> write;
};

}  // namespace sensotwin::robot
