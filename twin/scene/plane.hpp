// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/base/geometry.hpp"

/// Plane geometry on corner lists; all in one frame, m.
namespace sensotwin::twin {

using robot::Vec2;

struct Segment {
  Vec2 a_m;
  Vec2 b_m;
};

/// The sides of a corner list, with the one back to the first when closed.
[[nodiscard]] std::vector<Segment> sides(const std::vector<Vec2>& corners, bool closed);
[[nodiscard]] double distance_m(const Vec2& point, const Segment& segment);
/// Nearest distance of two segments; 0 when they meet.
[[nodiscard]] double distance_m(const Segment& s, const Segment& t);
[[nodiscard]] bool meet(const Segment& s, const Segment& t);
/// Positive when the corners go counter-clockwise.
[[nodiscard]] double signed_area_m2(const std::vector<Vec2>& corners);
/// Even-odd rule; points on the border may fall on either side.
[[nodiscard]] bool inside(const Vec2& point, const std::vector<Vec2>& corners);
/// Either way round; no two equal corners, no corner straight.
[[nodiscard]] bool convex(const std::vector<Vec2>& corners);
/// Two sides of the closed list that are not neighbours meet, or a side has no length.
[[nodiscard]] bool crosses_itself(const std::vector<Vec2>& corners);

}  // namespace sensotwin::twin
