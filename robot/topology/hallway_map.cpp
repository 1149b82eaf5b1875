// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Bearings are written to the degree.
constexpr double kStraight_rad = rad_from_deg(1.0);

std::string words(CompassPoint side) {
  return std::string{name_of(side)};
}

void check_names(const std::vector<HallwayNode>& nodes, std::vector<HallwayMapProblem>& problems) {
  std::set<std::string_view> seen;
  for (const HallwayNode& node : nodes) {
    if (node.name.empty()) {
      problems.push_back({node.name, std::nullopt, "has no name"});
    } else if (!seen.insert(node.name).second) {
      problems.push_back({node.name, std::nullopt, "is there twice"});
    }
    if (node.hallways() == 0 && nodes.size() > 1) {
      problems.push_back({node.name, std::nullopt, "no hallway leads here"});
    }
  }
}

void check_hallway(const std::vector<HallwayNode>& nodes, NodeIndex from, CompassPoint point,
                   std::vector<HallwayMapProblem>& problems) {
  const HallwayNode& node = nodes[from];
  const Side& side = node.side(point);
  const auto complain = [&](std::string what) { problems.push_back({node.name, point, std::move(what)}); };
  if (side.hallway == Hallway::kNone && !side.tags.empty()) {
    complain("has tags, and no hallway by which to come to them");
  }
  if (side.hallway != Hallway::kLeadsTo) {
    return;
  }
  if (side.to >= nodes.size()) {
    complain("leads to a place that is not there");
    return;
  }
  if (std::abs(wrap_angle(node.bearing_rad(point) - yaw_rad_of(point))) > kOffPoint_rad + kStraight_rad) {
    complain("leaves more than 45 degrees off its compass point");
  }
  const HallwayNode& other = nodes[side.to];
  if (side.to == from) {
    complain("leads back to itself: put a place at the bend");
    return;
  }
  if (side.length_m && !(std::isfinite(*side.length_m) && *side.length_m > 0.0)) {
    complain("has a length that is not above 0");
  }
  const Side& back = other.side(opposite(point));
  if (back.hallway != Hallway::kLeadsTo || back.to != from) {
    complain("leads to '" + other.name + "', whose " + words(opposite(point)) + " side does not lead back");
  } else if (back.length_m != side.length_m) {
    complain("has another length than '" + other.name + "' gives it");
  } else if (std::abs(wrap_angle(other.bearing_rad(opposite(point)) - node.bearing_rad(point) - kPi)) >
             kStraight_rad) {
    complain("leads straight to '" + other.name + "', whose bearing is not the opposite one");
  }
}

void check_tags(const std::vector<HallwayNode>& nodes, std::vector<HallwayMapProblem>& problems) {
  std::map<TagNumber, std::string> seen;
  for (const HallwayNode& node : nodes) {
    for (const CompassPoint point : kCompassPoints) {
      for (const TagNumber tag : node.side(point).tags) {
        const auto [first, fresh] = seen.emplace(tag, "'" + node.name + "' " + words(point));
        if (!fresh) {
          problems.push_back({node.name, point,
                              "has tag " + std::to_string(tag) + ", which is at " + first->second + " too"});
        }
      }
    }
  }
}

}  // namespace

int HallwayNode::hallways() const {
  return static_cast<int>(std::count_if(sides.begin(), sides.end(),
                                        [](const Side& side) { return side.hallway != Hallway::kNone; }));
}

std::optional<NodeIndex> HallwayMap::find(std::string_view name) const {
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](const HallwayNode& node) { return node.name == name; });
  return found == nodes_.end() ? std::nullopt
                               : std::optional{static_cast<NodeIndex>(std::distance(nodes_.begin(), found))};
}

std::optional<Arrival> HallwayMap::place_of(TagNumber tag) const {
  for (NodeIndex i = 0; i < nodes_.size(); ++i) {
    for (const CompassPoint point : kCompassPoints) {
      const std::vector<TagNumber>& tags = nodes_[i].side(point).tags;
      if (std::find(tags.begin(), tags.end(), tag) != tags.end()) {
        return Arrival{i, point};
      }
    }
  }
  return std::nullopt;
}

bool HallwayMap::lengths_known() const {
  for (const HallwayNode& node : nodes_) {
    for (const Side& side : node.sides) {
      if (side.hallway == Hallway::kLeadsTo && !side.length_m) {
        return false;
      }
    }
  }
  return true;
}

NodeIndex HallwayMap::add(std::string name, const std::optional<Vec2>& at_m) {
  assert(!find(name));
  HallwayNode node;
  node.name = std::move(name);
  node.at_m = at_m;
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

void HallwayMap::connect(NodeIndex a, CompassPoint side, NodeIndex b, std::optional<double> length_m) {
  assert(a != b && a < nodes_.size() && b < nodes_.size());
  const auto lead = [&](NodeIndex from, CompassPoint point, NodeIndex to) {
    Side& end = nodes_[from].side(point);
    assert(end.hallway != Hallway::kLeadsTo || end.to == to);
    end.hallway = Hallway::kLeadsTo;
    end.to = to;
    end.length_m = length_m;
  };
  lead(a, side, b);
  lead(b, opposite(side), a);
}

void HallwayMap::set_hallway(NodeIndex node, CompassPoint side, Hallway hallway) {
  Side& end = nodes_[node].side(side);
  assert(end.hallway != Hallway::kLeadsTo && hallway != Hallway::kLeadsTo);
  end.hallway = hallway;
}

void HallwayMap::add_tag(NodeIndex node, CompassPoint side, TagNumber tag) {
  assert(!place_of(tag));
  nodes_[node].side(side).tags.push_back(tag);
}

HallwayMap HallwayMap::from_nodes(std::vector<HallwayNode> nodes) {
  HallwayMap map;
  map.nodes_ = std::move(nodes);
  return map;
}

std::vector<HallwayMapProblem> HallwayMap::check() const {
  std::vector<HallwayMapProblem> problems;
  check_names(nodes_, problems);
  for (NodeIndex i = 0; i < nodes_.size(); ++i) {
    for (const CompassPoint point : kCompassPoints) {
      check_hallway(nodes_, i, point, problems);
    }
  }
  check_tags(nodes_, problems);
  return problems;
}

}  // namespace sensotwin::robot
