// SPDX-License-Identifier: MIT
#pragma once

namespace sensotwin::robot {

/// What a plan of moves costs in time. Turns on the spot are not free: a plan with fewer tiles may take
/// longer.
struct MoveCost {
  double tile_s{2.0};          ///< from tag to tag, straight; 2.0 s: 0.508 m at 0.25 m/s
  double quarter_turn_s{1.5};  ///< 90 degrees on the spot, settling included; chosen
};

}  // namespace sensotwin::robot
