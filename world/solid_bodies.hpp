// SPDX-License-Identifier: MIT
#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

#include "world/description.hpp"
#include "world/obstacles.hpp"

/// What is solid, as bodies of Box2D. Of world/ alone: the header is not published. Box2D's frame is W moved
/// to an origin of its own, m.
namespace sensotwin::world {

/// A piece that can be pushed: its body, which its b2World owns, and its outline.
struct Pushable {
  std::uint32_t index;  ///< in WorldDescription::furniture
  b2Body* body;
  Outline outline_F;
  double reach_m;  ///< of its outline from its own origin
};

/// Box2D 2.4.1 fills its table of contact types at the first contact of the process, without a lock
/// (b2Contact::Create): two worlds whose first contacts fall together in two threads could find it half
/// filled and miss one. So the first contact happens here, behind the lock of a local static.
/// \returns true
[[nodiscard]] bool contact_types_known();

/// The middle of the walls' bounding box, `otherwise_m` within it.
[[nodiscard]] Vec2 middle_m(const std::vector<Wall>& walls, const Vec2& otherwise_m);

/// One body that never moves, of everything that is fixed.
[[nodiscard]] b2Body* make_ground(b2World& box, const Outline& fixed_W, const Vec2& origin_m);
/// A piece that stands on `ground` until it is pushed harder than friction holds it.
[[nodiscard]] Pushable make_pushable(b2Body& ground, std::uint32_t index, const Furniture& piece,
                                     double robot_height_m, const Vec2& origin_m);
/// The robot: a disc, its mass spread evenly, at its start.
[[nodiscard]] b2Body* make_shell(b2World& box, const RobotDescription& robot, const Vec2& origin_m);

}  // namespace sensotwin::world
