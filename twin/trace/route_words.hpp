// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/topology/hallway_map.hpp"
#include "robot/topology/hallway_route.hpp"

namespace sensotwin::twin {

/// Where a robot stands: at a place, or by a tag that it has just read.
struct RouteStart {
  robot::NodeIndex node{0};
  std::optional<robot::CompassPoint> came_from{};  ///< known of a tag
  std::string words;                               ///< "Tag 12: at c, having come in from the east."
};

/// From a place's name or a tag's number, in that order. Nothing: neither.
[[nodiscard]] std::optional<RouteStart> route_start(const robot::HallwayMap& map, const std::string& text);

/// A sentence for each hallway of the way: "Turn right and go east 8.4 m to e (tag 13)".
[[nodiscard]] std::vector<std::string> route_words(const robot::HallwayMap& map, const RouteStart& start,
                                                   const robot::HallwayRoute& route);

}  // namespace sensotwin::twin
