// SPDX-License-Identifier: MIT
#pragma once

#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// A map of the kind that Tsukiyama's Figure 5 shows, with the facts that section 3 tells of it: a robot that
/// reads tag 9 comes into c from the east, d lies north of c and is a junction, and on the way there it reads
/// tag 11.
///
///     d --- e --- ?
///     |     |
/// a - c --- f
///     |
///     b
inline HallwayMap paper_map() {
  HallwayMap map;
  const NodeIndex a = map.add("a");
  const NodeIndex b = map.add("b");
  const NodeIndex c = map.add("c");
  const NodeIndex d = map.add("d");
  const NodeIndex e = map.add("e");
  const NodeIndex f = map.add("f");
  map.connect(c, CompassPoint::kWest, a);
  map.connect(c, CompassPoint::kSouth, b);
  map.connect(c, CompassPoint::kNorth, d);
  map.connect(c, CompassPoint::kEast, f);
  map.connect(d, CompassPoint::kEast, e);
  map.connect(e, CompassPoint::kSouth, f);
  map.set_hallway(e, CompassPoint::kEast, Hallway::kUnknown);
  map.add_tag(a, CompassPoint::kEast, 1);
  map.add_tag(b, CompassPoint::kNorth, 2);
  map.add_tag(c, CompassPoint::kNorth, 6);
  map.add_tag(c, CompassPoint::kSouth, 7);
  map.add_tag(c, CompassPoint::kWest, 8);
  map.add_tag(c, CompassPoint::kEast, 9);
  map.add_tag(d, CompassPoint::kSouth, 11);
  map.add_tag(d, CompassPoint::kEast, 12);
  map.add_tag(e, CompassPoint::kWest, 13);
  map.add_tag(e, CompassPoint::kSouth, 14);
  map.add_tag(e, CompassPoint::kEast, 15);
  map.add_tag(f, CompassPoint::kNorth, 16);
  map.add_tag(f, CompassPoint::kWest, 17);
  return map;
}

}  // namespace sensotwin::robot
