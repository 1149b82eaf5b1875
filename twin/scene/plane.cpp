// SPDX-License-Identifier: MIT
#include "twin/scene/plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sensotwin::twin {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool between(double low, double value, double high) {
  return std::min(low, high) <= value && value <= std::max(low, high);
}

bool on_line_within(const Segment& s, const Vec2& p) {
  return between(s.a_m.x(), p.x(), s.b_m.x()) && between(s.a_m.y(), p.y(), s.b_m.y());
}

}  // namespace

std::vector<Segment> sides(const std::vector<Vec2>& corners, bool closed) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    result.push_back({corners[i], corners[i + 1]});
  }
  if (closed && corners.size() > 2) {
    result.push_back({corners.back(), corners.front()});
  }
  return result;
}

double distance_m(const Vec2& point, const Segment& segment) {
  const Vec2 along = segment.b_m - segment.a_m;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point - segment.a_m).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - (segment.a_m + t * along)).norm();
}

double distance_m(const Segment& s, const Segment& t) {
  if (meet(s, t)) {
    return 0.0;
  }
  return std::min({distance_m(s.a_m, t), distance_m(s.b_m, t), distance_m(t.a_m, s), distance_m(t.b_m, s)});
}

bool meet(const Segment& s, const Segment& t) {
  const double s_a = cross(s.b_m - s.a_m, t.a_m - s.a_m);
  const double s_b = cross(s.b_m - s.a_m, t.b_m - s.a_m);
  const double t_a = cross(t.b_m - t.a_m, s.a_m - t.a_m);
  const double t_b = cross(t.b_m - t.a_m, s.b_m - t.a_m);
  if (((s_a > 0 && s_b < 0) || (s_a < 0 && s_b > 0)) && ((t_a > 0 && t_b < 0) || (t_a < 0 && t_b > 0))) {
    return true;
  }
  return (s_a == 0 && on_line_within(s, t.a_m)) || (s_b == 0 && on_line_within(s, t.b_m)) ||
         (t_a == 0 && on_line_within(t, s.a_m)) || (t_b == 0 && on_line_within(t, s.b_m));
}

double signed_area_m2(const std::vector<Vec2>& corners) {
  double twice = 0.0;
  for (const Segment& side : sides(corners, true)) {
    twice += cross(side.a_m, side.b_m);
  }
  return twice / 2.0;
}

bool inside(const Vec2& point, const std::vector<Vec2>& corners) {
  bool in = false;
  for (const Segment& side : sides(corners, true)) {
    const bool a_above = side.a_m.y() > point.y();
    const bool b_above = side.b_m.y() > point.y();
    if (a_above != b_above) {
      const double t = (point.y() - side.a_m.y()) / (side.b_m.y() - side.a_m.y());
      in ^= point.x() < side.a_m.x() + t * (side.b_m.x() - side.a_m.x());
    }
  }
  return in;
}

bool convex(const std::vector<Vec2>& corners) {
  const double turn = signed_area_m2(corners) > 0 ? 1.0 : -1.0;
  const std::size_t n = corners.size();
  double turned_rad = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = corners[(i + 1) % n] - corners[i];
    const Vec2 after = corners[(i + 2) % n] - corners[(i + 1) % n];
    const double bend = turn * cross(before, after);
    if (bend <= 0.0) {
      return false;
    }
    turned_rad += std::atan2(bend, before.dot(after));
  }
  // A pentagram bends one way at every corner too, but turns twice.
  return turned_rad < 3.0 * robot::kPi;
}

bool crosses_itself(const std::vector<Vec2>& corners) {
  const std::vector<Segment> all = sides(corners, true);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((all[i].b_m - all[i].a_m).norm() == 0.0) {
      return true;
    }
    for (std::size_t j = i + 2; j < all.size(); ++j) {
      const bool neighbours = i == 0 && j + 1 == all.size();
      if (!neighbours && meet(all[i], all[j])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace sensotwin::twin
