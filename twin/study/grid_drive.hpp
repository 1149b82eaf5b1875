// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "robot/mapping/explorer.hpp"
#include "twin/study/grid_room.hpp"

namespace sensotwin::twin {

/// What the robot learns of its neighbours without driving there.
enum class Knowledge : std::uint8_t {
  kAdjacent,  ///< on arrival it knows which of the four passages are blocked (light bumpers, or a map)
  kBump       ///< it knows a passage only by having tried it
};

/// What one explorer did in one room, counted as the paper does and as it is driven.
struct DriveTally {
  int tags{0};          ///< V: tags that straight drives can reach
  int tags_visited{0};  ///< of these
  int moves{0};         ///< drives from tag to tag that arrived
  int quarter_turns{0};
  int bumps{0};         ///< drives that ended at an obstacle and on the tag they had left
  int paper_visits{0};  ///< S_T as Algorithm 1 counts it
  bool ended{false};    ///< the explorer said that it was done (false: stopped at the limit of moves)

  /// epsilon = S_T / V - 1 (SensoBot, equation 1), S_T counted as Algorithm 1 prints it.
  [[nodiscard]] double paper_epsilon() const { return static_cast<double>(paper_visits) / tags - 1.0; }
  /// The same with every tag counted that the robot drives over, the start included.
  [[nodiscard]] double physical_epsilon() const { return static_cast<double>(moves + 1) / tags - 1.0; }
};

struct DriveOptions {
  Knowledge knowledge{Knowledge::kAdjacent};
  robot::Direction heading{robot::Direction::kEast};
  /// Go on until the explorer is done. Otherwise the drive ends with the last tag, as in the paper's
  /// simulation
  /// ("before each single tag has been visited at least once").
  bool to_the_end{false};
  /// Let detour moves fail (the grid model has no floor between tags to find a way on); false ends the drive
  /// at the first of them.
  bool answer_detours{false};
};

/// Drives `explorer` through `room` in the grid model: a straight move arrives when the passage is open and
/// ends where it began when not; a detour arrives when the tag is reachable at all. \param order  when not
/// null, receives the tags in the order of their first visits
[[nodiscard]] DriveTally drive(robot::Explorer& explorer, const GridRoom& room,
                               const DriveOptions& options = {}, std::vector<robot::Tile>* order = nullptr);

}  // namespace sensotwin::twin
