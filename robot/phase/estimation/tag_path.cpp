// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/tag_path.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Points tried along a leg before the nearest is refined. Chosen: a 6 m leg in 20 cm.
constexpr int kTried = 32;
constexpr int kRefinements = 4;  ///< Newton steps; each doubles the digits

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double angle_of(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

}  // namespace

PathReference on_line(const Vec2& from_m, const Vec2& to_m, const Vec2& p_m) {
  const Vec2 way = to_m - from_m;
  const double length_m = way.norm();
  assert(length_m > 0.0);
  const Vec2 along = way / length_m;
  const double done_m = along.dot(p_m - from_m);
  return {.across_m = cross(along, p_m - from_m),
          .yaw_rad = angle_of(along),
          .curvature_per_m = 0.0,
          .to_go_m = length_m - done_m,
          .part = done_m / length_m};
}

SmoothLeg::SmoothLeg(const std::optional<Vec2>& p0_m, const Vec2& p1_m, const Vec2& p2_m,
                     const std::optional<Vec2>& p3_m) {
  const Vec2 p0 = p0_m.value_or(2.0 * p1_m - p2_m);
  const Vec2 p3 = p3_m.value_or(2.0 * p2_m - p1_m);
  // Knots a root of the chord apart (centripetal); tangents by finite differences over uneven knots, times
  // the middle knot interval.
  const double d0 = std::sqrt((p1_m - p0).norm());
  const double d1 = std::sqrt((p2_m - p1_m).norm());
  const double d2 = std::sqrt((p3 - p2_m).norm());
  assert(d1 > 0.0);
  const auto tangent = [d1](const Vec2& a, const Vec2& b, const Vec2& c, double da, double db) -> Vec2 {
    if (da == 0.0 || db == 0.0) {
      return (b - a) + (c - b);
    }
    return d1 * ((b - a) / da - (c - a) / (da + db) + (c - b) / db);
  };
  const Vec2 m1 = tangent(p0, p1_m, p2_m, d0, d1);
  const Vec2 m2 = tangent(p1_m, p2_m, p3, d1, d2);
  c_ = {p1_m, m1, 3.0 * (p2_m - p1_m) - 2.0 * m1 - m2, 2.0 * (p1_m - p2_m) + m1 + m2};
}

Vec2 SmoothLeg::point_m(double s) const {
  return c_[0] + s * (c_[1] + s * (c_[2] + s * c_[3]));
}

PathReference SmoothLeg::at(const Vec2& p_m) const {
  double s = 0.0;
  double nearest2 = (point_m(0.0) - p_m).squaredNorm();
  for (int i = 1; i <= kTried; ++i) {
    const double tried = static_cast<double>(i) / kTried;
    const double distance2 = (point_m(tried) - p_m).squaredNorm();
    if (distance2 < nearest2) {
      nearest2 = distance2;
      s = tried;
    }
  }
  const auto first = [this](double t) -> Vec2 { return c_[1] + t * (2.0 * c_[2] + 3.0 * t * c_[3]); };
  const auto second = [this](double t) -> Vec2 { return 2.0 * c_[2] + 6.0 * t * c_[3]; };
  for (int i = 0; i < kRefinements; ++i) {
    const Vec2 off = point_m(s) - p_m;
    const double slope = off.dot(first(s));
    const double bend = first(s).squaredNorm() + off.dot(second(s));
    // Before its beginning and behind its end the curve goes on a little, so that passing shows.
    s = std::clamp(s - slope / std::max(bend, 1e-9), -0.1, 1.1);
  }
  const Vec2 tangent = first(s);
  const double speed = tangent.norm();
  double to_go_m = 0.0;
  const double step = (1.0 - s) / kTried;
  for (int i = 0; i < kTried; ++i) {
    to_go_m += first(s + (i + 0.5) * step).norm() * step;
  }
  return {.across_m = cross(tangent / speed, p_m - point_m(s)),
          .yaw_rad = angle_of(tangent),
          .curvature_per_m = cross(tangent, second(s)) / (speed * speed * speed),
          .to_go_m = to_go_m,
          .part = s};
}

std::optional<Circle> circle_through(std::span<const Vec2> points_m) {
  if (points_m.size() < 3) {
    return std::nullopt;
  }
  // |p|^2 = 2 c.p + (r^2 - |c|^2), linear in (2 c, r^2 - |c|^2), about the first point for its digits.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Vec2& point : points_m) {
    const Vec2 p = point - points_m.front();
    const Eigen::Vector3d row{p.x(), p.y(), 1.0};
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (solver.rank() < 3) {
    return std::nullopt;
  }
  const Eigen::Vector3d solved = solver.solve(right);
  const Vec2 centre = solved.head<2>() / 2.0;
  const double radius2 = solved.z() + centre.squaredNorm();
  if (!(radius2 > 0.0)) {
    return std::nullopt;
  }
  return Circle{points_m.front() + centre, std::sqrt(radius2)};
}

PathReference on_circle(const Circle& circle, bool left, const Vec2& from_m, const Vec2& end_m,
                        const Vec2& p_m) {
  const double side = left ? 1.0 : -1.0;
  const Vec2 out = p_m - circle.centre_m;
  const auto turn_to = [&](const Vec2& a, const Vec2& b) {
    return side * wrap_angle(angle_of(b - circle.centre_m) - angle_of(a - circle.centre_m));
  };
  double leg_rad = turn_to(from_m, end_m);
  if (leg_rad <= 0.0) {
    leg_rad += 2.0 * kPi;
  }
  // Less than half a turn behind the end counts as past it.
  double to_go_rad = turn_to(p_m, end_m);
  if (to_go_rad < 0.0 && to_go_rad < leg_rad - 1.5 * kPi) {
    to_go_rad += 2.0 * kPi;
  }
  return {.across_m = side * (circle.radius_m - out.norm()),
          .yaw_rad = wrap_angle(angle_of(out) + side * kPi / 2.0),
          .curvature_per_m = side / circle.radius_m,
          .to_go_m = to_go_rad * circle.radius_m,
          .part = 1.0 - to_go_rad / leg_rad};
}

}  // namespace sensotwin::robot
