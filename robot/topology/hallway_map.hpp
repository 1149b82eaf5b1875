// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/topology/compass_point.hpp"

/// The map of Tsukiyama's robot: which particular places of a building lie next to which, by compass points,
/// and the tags that a robot meets when it comes to a place. No metres are needed (Tsukiyama, section 3,
/// Figure 5(b)).
namespace sensotwin::robot {

/// What a tag says: its number on the plan, or its unique number.
using TagNumber = std::uint64_t;
/// Place in HallwayMap::nodes().
using NodeIndex = std::size_t;

enum class Hallway : std::uint8_t {
  kNone,     ///< '-': no hallway in this direction
  kUnknown,  ///< '?': a hallway, and nobody knows where it leads
  kLeadsTo,  ///< the place at its other end is known
};

/// One side of a place: the hallway that leaves it there.
struct Side {
  Hallway hallway{Hallway::kNone};
  NodeIndex to{0};                   ///< of kLeadsTo
  std::optional<double> length_m{};  ///< of kLeadsTo: from middle to middle
  std::vector<TagNumber> tags{};     ///< met when coming to the place from this side
  /// Direction in which the hallway leaves, counter-clockwise from the plan's north; nothing: its compass
  /// point's. Buildings have hallways that are not square to each other.
  std::optional<double> bearing_rad{};
  /// From the tags to the middle of the place; nothing: as everywhere in the building.
  std::optional<double> tag_m{};
};

/// A particular place: intersection, junction, bend or end.
struct HallwayNode {
  std::string name;
  std::array<Side, 4> sides{};  ///< by CompassPoint
  std::optional<Vec2> at_m{};   ///< on the plan, where somebody drew it: x east, y north

  [[nodiscard]] const Side& side(CompassPoint point) const { return sides[static_cast<std::size_t>(point)]; }
  [[nodiscard]] Side& side(CompassPoint point) { return sides[static_cast<std::size_t>(point)]; }
  /// In which the hallway on that side leaves, counter-clockwise from the plan's north.
  [[nodiscard]] double bearing_rad(CompassPoint point) const {
    return side(point).bearing_rad.value_or(yaw_rad_of(point));
  }
  /// Sides with a hallway, known or not.
  [[nodiscard]] int hallways() const;
};

/// Where a robot is that has just read a tag.
struct Arrival {
  NodeIndex node{0};
  CompassPoint from{CompassPoint::kNorth};  ///< the side on which it comes in; it heads for the opposite one
};

/// What is wrong with a map, in words for whoever drew it.
struct HallwayMapProblem {
  std::string node;
  std::optional<CompassPoint> side;  ///< none: the node as a whole
  std::string what;
};

/// So far from its compass point a hallway may leave: halfway to the next one.
inline constexpr double kOffPoint_rad = 0.25 * kPi;

/// Places and the hallways between them. Every change keeps both ends of a hallway in step.
class HallwayMap {
 public:
  [[nodiscard]] const std::vector<HallwayNode>& nodes() const { return nodes_; }
  [[nodiscard]] const HallwayNode& node(NodeIndex index) const { return nodes_[index]; }
  [[nodiscard]] std::optional<NodeIndex> find(std::string_view name) const;
  /// "the navigation system searches all the node data of the graph for the tag number" (section 3).
  [[nodiscard]] std::optional<Arrival> place_of(TagNumber tag) const;
  /// Whether all hallways whose two ends are known have a length.
  [[nodiscard]] bool lengths_known() const;

  /// \pre no node of that name
  NodeIndex add(std::string name, const std::optional<Vec2>& at_m = std::nullopt);
  /// A hallway from `a`, left on that side, to `b`, entered on the opposite side. What was on either side
  /// before is replaced, tags stay. \pre a != b, both sides lead nowhere else
  void connect(NodeIndex a, CompassPoint side, NodeIndex b, std::optional<double> length_m = std::nullopt);
  /// \pre the side does not lead to a known place
  void set_hallway(NodeIndex node, CompassPoint side, Hallway hallway);
  /// The tag is met on coming to `node` from that side. \pre place_of(tag) is empty
  void add_tag(NodeIndex node, CompassPoint side, TagNumber tag);

  /// For readers of files, which take what is written before they judge it: check() says what is wrong with
  /// it.
  static HallwayMap from_nodes(std::vector<HallwayNode> nodes);
  /// Names that are empty or there twice, hallways that do not lead back on the opposite side or with another
  /// length, lengths that are not positive, hallways that leave more than kOffPoint_rad from their compass
  /// point or are not straight, tags in two places, places that no hallway leads to. Empty: a sound map.
  [[nodiscard]] std::vector<HallwayMapProblem> check() const;

 private:
  std::vector<HallwayNode> nodes_;
};

}  // namespace sensotwin::robot
