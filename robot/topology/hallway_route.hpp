// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "robot/base/result.hpp"
#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// Hallways that nobody gets through at the moment, by either end.
class BlockedHallways {
 public:
  /// The hallway that leaves `node` on that side, both ways.
  void block(const HallwayMap& map, NodeIndex node, CompassPoint side);
  [[nodiscard]] bool contains(NodeIndex node, CompassPoint side) const {
    return ends_.contains({node, side});
  }
  [[nodiscard]] bool empty() const { return ends_.empty(); }
  void clear() { ends_.clear(); }

 private:
  std::set<std::pair<NodeIndex, CompassPoint>> ends_;
};

/// The side on which to leave a place, and where that leads.
struct RouteStep {
  NodeIndex from{0};
  CompassPoint exit{CompassPoint::kNorth};
  NodeIndex to{0};
};

struct HallwayRoute {
  std::vector<RouteStep> steps;  ///< empty: it is there
  double cost{0.0};              ///< metres when by_length, else hallways
  bool by_length{false};         ///< all hallways of the map have a length
};

enum class RouteError : std::uint8_t {
  kNoWay,          ///< no hallway that is known and free leads there
  kOnlyByUnknown,  ///< as kNoWay, but a hallway whose end is unknown can be reached and might
};

/// The shortest way over hallways whose ends are known: by length when all lengths are known, else by their
/// number (the paper gives no weights; algorithms study, D). Of equal ways, always the same one. \pre the map
/// is sound
[[nodiscard]] Result<HallwayRoute, RouteError> plan_route(const HallwayMap& map, NodeIndex start,
                                                          NodeIndex goal,
                                                          const BlockedHallways& blocked = {});

/// The way to the nearest place with a side that leads nobody knows where, and that side: what explores next.
struct Frontier {
  HallwayRoute route;
  NodeIndex node{0};
  CompassPoint exit{CompassPoint::kNorth};
};
/// Of one place's unknown sides, the one that needs the fewest quarter turns on arriving, right before left.
/// \param heading  at `start`
/// \returns nothing when no unknown hallway can be reached: the map is whole
[[nodiscard]] std::optional<Frontier> nearest_unknown(const HallwayMap& map, NodeIndex start,
                                                      CompassPoint heading,
                                                      const BlockedHallways& blocked = {});

/// Quarter turns to the right, -1 to 2, that a robot makes which comes in from one side and goes out by
/// another.
[[nodiscard]] constexpr int turn_at(CompassPoint came_from, CompassPoint exit) {
  return quarter_turns_right(opposite(came_from), exit);
}

}  // namespace sensotwin::robot
