// SPDX-License-Identifier: MIT
#include "twin/trace/drawing_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace sensotwin::twin {
namespace {

using robot::CompassPoint;
using robot::HallwayMap;
using robot::HallwayMapProblem;
using robot::NodeIndex;
using robot::Vec2;

/// Chosen: the robot turns by compass points and corrects what the walls show; twice what the page lets snap.
constexpr double kOffAxisMax_rad = 15.0 * robot::kPi / 180.0;
/// Chosen: what the hallway tracker's search for a junction still covers.
constexpr double kLengthOff = 0.1;
constexpr double kLengthOff_m = 0.5;

struct Drawn {
  NodeIndex a;
  CompassPoint side;
  NodeIndex b;
  Vec2 a_m;
  Vec2 b_m;
};

/// Each hallway once, where both ends have a position.
std::vector<Drawn> drawn_hallways(const HallwayMap& map) {
  std::vector<Drawn> hallways;
  for (NodeIndex a = 0; a < map.nodes().size(); ++a) {
    for (const CompassPoint side : robot::kCompassPoints) {
      const robot::Side& end = map.node(a).side(side);
      if (end.hallway == robot::Hallway::kLeadsTo && a < end.to && map.node(a).at_m &&
          map.node(end.to).at_m) {
        hallways.push_back({a, side, end.to, *map.node(a).at_m, *map.node(end.to).at_m});
      }
    }
  }
  return hallways;
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether the insides of two hallways without a common place meet.
bool meet(const Drawn& one, const Drawn& other) {
  if (one.a == other.a || one.a == other.b || one.b == other.a || one.b == other.b) {
    return false;
  }
  const Vec2 way = one.b_m - one.a_m;
  const Vec2 across = other.b_m - other.a_m;
  const auto sides = [](const Vec2& line, const Vec2& p, const Vec2& q) {
    return cross(line, p) * cross(line, q);
  };
  return sides(way, other.a_m - one.a_m, other.b_m - one.a_m) < 0.0 &&
         sides(across, one.a_m - other.a_m, one.b_m - other.a_m) < 0.0;
}

/// Clockwise from north, from 0 to 360.
double compass_deg(double bearing_rad) {
  const double deg = -robot::deg_from_rad(robot::wrap_angle(bearing_rad));
  return deg < 0.0 ? deg + 360.0 : deg;
}

void advise_on_shape(const HallwayMap& map, const Drawn& hallway, std::vector<HallwayMapProblem>& advice) {
  const Vec2 way = hallway.b_m - hallway.a_m;
  const robot::HallwayNode& from = map.node(hallway.a);
  const std::string& to = map.node(hallway.b).name;
  const double bearing_rad = from.bearing_rad(hallway.side);
  const Vec2 along{-std::sin(bearing_rad), std::cos(bearing_rad)};
  const double off_rad = std::abs(std::atan2(cross(along, way), along.dot(way)));
  if (way.norm() > 1e-6 && off_rad > kOffAxisMax_rad) {
    const std::string from_what = from.side(hallway.side).bearing_rad
                                      ? fmt::format("the bearing of {:.0f} degrees", compass_deg(bearing_rad))
                                      : std::string{robot::name_of(hallway.side)};
    advice.push_back({from.name, hallway.side,
                      fmt::format("leads to '{}', which lies {:.0f} degrees off {} on the plan", to,
                                  robot::deg_from_rad(off_rad), from_what)});
  }
  const std::optional<double> length_m = from.side(hallway.side).length_m;
  const double wrong_m = std::abs(length_m.value_or(way.norm()) - way.norm());
  if (wrong_m > std::max(kLengthOff_m, kLengthOff * way.norm())) {
    advice.push_back({from.name, hallway.side,
                      fmt::format("is {:.1f} m long, and drawn {:.1f} m long", *length_m, way.norm())});
  }
}

void advise_on_crossings(const HallwayMap& map, const std::vector<Drawn>& hallways,
                         std::vector<HallwayMapProblem>& advice) {
  for (std::size_t i = 0; i < hallways.size(); ++i) {
    for (std::size_t k = i + 1; k < hallways.size(); ++k) {
      if (meet(hallways[i], hallways[k])) {
        advice.push_back({map.node(hallways[i].a).name, hallways[i].side,
                          fmt::format("crosses the hallway from '{}' to '{}': is there no place between?",
                                      map.node(hallways[k].a).name, map.node(hallways[k].b).name)});
      }
    }
  }
}

/// Of each place, whether known hallways lead there from the first.
std::vector<bool> joined_to_first(const HallwayMap& map) {
  std::vector<bool> joined(map.nodes().size(), false);
  std::vector<NodeIndex> open{0};
  while (!open.empty() && !joined.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    if (joined[at]) {
      continue;
    }
    joined[at] = true;
    for (const robot::Side& side : map.node(at).sides) {
      if (side.hallway == robot::Hallway::kLeadsTo) {
        open.push_back(side.to);
      }
    }
  }
  return joined;
}

void advise_on_places(const robot::HallwayFile& file, std::vector<HallwayMapProblem>& advice) {
  const auto& nodes = file.map.nodes();
  const std::vector<bool> joined = joined_to_first(file.map);
  for (NodeIndex i = 0; i < nodes.size(); ++i) {
    for (NodeIndex k = i + 1; k < nodes.size(); ++k) {
      if (nodes[i].at_m && nodes[k].at_m && (*nodes[i].at_m - *nodes[k].at_m).norm() < 0.5 * file.width_m) {
        advice.push_back({nodes[k].name, std::nullopt,
                          fmt::format("lies within half a hallway's width of '{}'", nodes[i].name)});
      }
    }
    if (!joined[i] && nodes[i].hallways() > 0) {
      advice.push_back(
          {nodes[i].name, std::nullopt, fmt::format("no known way leads here from '{}'", nodes[0].name)});
    }
  }
}

/// A tag that lies beyond the hallway's other end was measured from the wrong place, or mistyped.
void advise_on_tag_distances(const robot::HallwayFile& file, const Drawn& hallway,
                             std::vector<HallwayMapProblem>& advice) {
  const double drawn_m = (hallway.b_m - hallway.a_m).norm();
  const auto judge = [&](NodeIndex at, CompassPoint point) {
    const robot::Side& side = file.map.node(at).side(point);
    const double length_m = side.length_m.value_or(drawn_m);
    if (!side.tags.empty() && side.tag_m.value_or(file.tag_to_middle_m) >= length_m) {
      advice.push_back(
          {file.map.node(at).name, point,
           fmt::format("has tags {:.1f} m from the middle of the place, and the hallway is {:.1f} m long",
                       side.tag_m.value_or(file.tag_to_middle_m), length_m)});
    }
  };
  judge(hallway.a, hallway.side);
  judge(hallway.b, robot::opposite(hallway.side));
}

void advise_on_tags(const HallwayMap& map, std::vector<HallwayMapProblem>& advice) {
  int arrivals = 0;
  int without = 0;
  const robot::HallwayNode* first = nullptr;
  for (const robot::HallwayNode& node : map.nodes()) {
    for (const robot::Side& side : node.sides) {
      if (side.hallway != robot::Hallway::kNone) {
        ++arrivals;
        without += side.tags.empty() ? 1 : 0;
        first = first == nullptr && side.tags.empty() ? &node : first;
      }
    }
  }
  if (first != nullptr) {
    advice.push_back({first->name, std::nullopt,
                      fmt::format("{} of {} arrivals have no tag: there the robot goes by its sonars alone",
                                  without, arrivals)});
  }
}

}  // namespace

std::vector<HallwayMapProblem> advice_on(const robot::HallwayFile& hallways) {
  std::vector<HallwayMapProblem> advice;
  const std::vector<Drawn> drawn = drawn_hallways(hallways.map);
  for (const Drawn& hallway : drawn) {
    advise_on_shape(hallways.map, hallway, advice);
    advise_on_tag_distances(hallways, hallway, advice);
  }
  advise_on_crossings(hallways.map, drawn, advice);
  advise_on_places(hallways, advice);
  advise_on_tags(hallways.map, advice);
  return advice;
}

}  // namespace sensotwin::twin
