// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/random.hpp"
#include "twin/study/grid_room.hpp"

namespace sensotwin::twin {

/// SensoBot, section V: "we create an area containing 324 tags".
inline constexpr int kStudyRoomSide = 18;

/// What the paper sweeps: Bp per cent of the tags blocked, in Bd separate chunks.
struct ObstacleCell {
  int blocked_percent{5};
  int chunks{1};
};

/// A square room of 324 tags with obstacles drawn from `random`; the start corner (0, 0) stays free.
///
/// The paper says nothing of the chunks' shape. Here: nearly equal sizes; rectangles whose aspect ratio is
/// exp(u), u uniform in +-0.8, the last row perhaps not full; no two touch, not even at a corner (with
/// touching ones there would be fewer chunks than said). These are the chunks with which its equation (2)
/// comes out. \pre 0 <= blocked_percent <= 30 and 1 <= chunks <= 16
[[nodiscard]] GridRoom obstacle_room(const ObstacleCell& cell, robot::RandomStream random);

}  // namespace sensotwin::twin
