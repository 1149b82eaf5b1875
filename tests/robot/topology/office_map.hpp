// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// An office floor: three streets of four places, a few hallways left out; every place reachable.
///
///   a0 - a1 - a2 - a3
///   |         |     |
///   b0 - b1 - b2 - b3
///         |         |
///   c0 - c1 - c2   c3
inline HallwayMap office() {
  HallwayMap map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      map.add(std::string(1, static_cast<char>('a' + row)) + std::to_string(column),
              Vec2{7.0 * column, -6.0 * row});
    }
  }
  const auto east = [&](NodeIndex from) { map.connect(from, CompassPoint::kEast, from + 1, 7.0); };
  const auto south = [&](NodeIndex from) { map.connect(from, CompassPoint::kSouth, from + 4, 6.0); };
  for (const NodeIndex from : {0, 1, 2, 4, 5, 6, 8, 9}) {
    east(from);
  }
  for (const NodeIndex from : {0, 2, 3, 5, 7}) {
    south(from);
  }
  TagNumber tag = 100;
  for (NodeIndex node = 0; node < map.nodes().size(); ++node) {
    for (const CompassPoint point : kCompassPoints) {
      if (map.node(node).side(point).hallway == Hallway::kLeadsTo) {
        map.add_tag(node, point, tag++);
      }
    }
  }
  return map;
}

}  // namespace sensotwin::robot
