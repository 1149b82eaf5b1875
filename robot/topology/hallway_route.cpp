// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_route.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <queue>

namespace sensotwin::robot {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Dijkstra from one place to all others.
struct Tree {
  std::vector<double> cost;
  std::vector<std::optional<RouteStep>> last;  ///< that leads there
  bool by_length{false};
};

Tree grow(const HallwayMap& map, NodeIndex start, const BlockedHallways& blocked) {
  Tree tree{std::vector<double>(map.nodes().size(), kFar),
            std::vector<std::optional<RouteStep>>(map.nodes().size()), map.lengths_known()};
  using Entry = std::pair<double, NodeIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  tree.cost[start] = 0.0;
  open.emplace(0.0, start);
  while (!open.empty()) {
    const auto [cost, node] = open.top();
    open.pop();
    if (cost > tree.cost[node]) {
      continue;
    }
    for (const CompassPoint exit : kCompassPoints) {
      const Side& side = map.node(node).side(exit);
      if (side.hallway != Hallway::kLeadsTo || blocked.contains(node, exit)) {
        continue;
      }
      const double there = cost + (tree.by_length ? *side.length_m : 1.0);
      if (there < tree.cost[side.to]) {
        tree.cost[side.to] = there;
        tree.last[side.to] = RouteStep{node, exit, side.to};
        open.emplace(there, side.to);
      }
    }
  }
  return tree;
}

HallwayRoute route_to(const Tree& tree, NodeIndex goal) {
  HallwayRoute route{{}, tree.cost[goal], tree.by_length};
  for (NodeIndex at = goal; tree.last[at]; at = tree.last[at]->from) {
    route.steps.push_back(*tree.last[at]);
  }
  std::reverse(route.steps.begin(), route.steps.end());
  return route;
}

bool leads_nobody_knows_where(const HallwayMap& map, NodeIndex node, CompassPoint exit,
                              const BlockedHallways& blocked) {
  return map.node(node).side(exit).hallway == Hallway::kUnknown && !blocked.contains(node, exit);
}

bool has_unknown(const HallwayMap& map, NodeIndex node, const BlockedHallways& blocked) {
  return std::any_of(kCompassPoints.begin(), kCompassPoints.end(),
                     [&](CompassPoint exit) { return leads_nobody_knows_where(map, node, exit, blocked); });
}

}  // namespace

void BlockedHallways::block(const HallwayMap& map, NodeIndex node, CompassPoint side) {
  ends_.emplace(node, side);
  const Side& end = map.node(node).side(side);
  if (end.hallway == Hallway::kLeadsTo) {
    ends_.emplace(end.to, opposite(side));
  }
}

Result<HallwayRoute, RouteError> plan_route(const HallwayMap& map, NodeIndex start, NodeIndex goal,
                                            const BlockedHallways& blocked) {
  const Tree tree = grow(map, start, blocked);
  if (tree.cost[goal] < kFar) {
    return route_to(tree, goal);
  }
  for (NodeIndex node = 0; node < map.nodes().size(); ++node) {
    if (tree.cost[node] < kFar && has_unknown(map, node, blocked)) {
      return Unexpected{RouteError::kOnlyByUnknown};
    }
  }
  return Unexpected{RouteError::kNoWay};
}

std::optional<Frontier> nearest_unknown(const HallwayMap& map, NodeIndex start, CompassPoint heading,
                                        const BlockedHallways& blocked) {
  const Tree tree = grow(map, start, blocked);
  std::optional<NodeIndex> nearest;
  for (NodeIndex node = 0; node < map.nodes().size(); ++node) {
    if (tree.cost[node] < kFar && has_unknown(map, node, blocked) &&
        (!nearest || tree.cost[node] < tree.cost[*nearest])) {
      nearest = node;
    }
  }
  if (!nearest) {
    return std::nullopt;
  }
  Frontier frontier{route_to(tree, *nearest), *nearest, heading};
  if (!frontier.route.steps.empty()) {
    heading = frontier.route.steps.back().exit;
  }
  int fewest = 3;
  for (const int turn : {0, 1, -1, 2}) {
    const CompassPoint exit = turned_right(heading, turn);
    if (std::abs(turn) < fewest && leads_nobody_knows_where(map, *nearest, exit, blocked)) {
      fewest = std::abs(turn);
      frontier.exit = exit;
    }
  }
  return frontier;
}

}  // namespace sensotwin::robot
