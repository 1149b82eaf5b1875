// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/path_shape.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Points of a leg of a curve. Chosen: on a circle of 2 m by 8 tags the chord is 0.06 mm off the arc.
constexpr int kPointsOfLeg = 100;
/// Of differences. Chosen: far above rounding, far below any bend.
constexpr double kStep_m = 1e-5;

double angle_of(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

}  // namespace

PathShape::PathShape(const Kind& kind, std::vector<Vec2> places_m, std::vector<std::size_t> route,
                     const Vec2& start_m)
    : kind_(kind), places_m_(std::move(places_m)), route_(std::move(route)), start_m_(start_m) {
  assert(!route_.empty());
}

std::size_t PathShape::legs() const {
  return kind_.path == TagPathKind::kCircleAbout ? 2 : route_.size();
}

SmoothLeg PathShape::smooth_leg(std::size_t leg, const std::vector<Vec2>& places_m) const {
  const auto at = [&](std::size_t i) { return places_m[route_[i]]; };
  return {leg >= 2 ? std::optional{at(leg - 2)} : std::nullopt, at(leg - 1), at(leg),
          leg + 1 < route_.size() ? std::optional{at(leg + 1)} : std::nullopt};
}

Circle PathShape::circle(const std::vector<Vec2>& places_m) const {
  if (kind_.path == TagPathKind::kCircleAbout) {
    return {places_m[route_.front()], kind_.circle_radius_m};
  }
  std::vector<Vec2> points;
  for (const std::size_t place : places_of(1)) {
    points.push_back(places_m[place]);
  }
  const std::optional<Circle> through = circle_through(points);
  assert(through);
  return *through;
}

std::vector<Vec2> PathShape::arc_m(const Vec2& from_m, double turn_rad) const {
  const Circle c = circle(places_m_);
  const double from = angle_of(from_m - c.centre_m);
  const int count = std::max(1, static_cast<int>(std::ceil(kPointsOfLeg * std::abs(turn_rad) / kPi)));
  std::vector<Vec2> points;
  for (int i = 1; i <= count; ++i) {
    const double angle = from + turn_rad * i / count;
    points.emplace_back(c.centre_m + c.radius_m * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

std::vector<Vec2> PathShape::points_m(std::size_t leg) const {
  const double side = kind_.circle_left ? 1.0 : -1.0;
  if (kind_.path == TagPathKind::kCircleAbout) {
    const Circle c = circle(places_m_);
    const Vec2 out = start_m_ - c.centre_m;
    const Vec2 nearest =
        c.centre_m + c.radius_m * (out.norm() > 0.0 ? Vec2{out.normalized()} : Vec2{1.0, 0.0});
    return leg == 0 ? std::vector<Vec2>{nearest} : arc_m(nearest, side * 2.0 * kPi * kind_.circle_laps);
  }
  const Vec2 end = places_m_[route_[leg]];
  if (leg == 0 || kind_.path == TagPathKind::kPolyline) {
    return {end};
  }
  if (kind_.path == TagPathKind::kCircleThrough) {
    const Vec2 from = places_m_[route_[leg - 1]];
    const Circle c = circle(places_m_);
    double turn = side * wrap_angle(angle_of(end - c.centre_m) - angle_of(from - c.centre_m));
    turn += turn <= 0.0 ? 2.0 * kPi : 0.0;
    return arc_m(from, side * turn);
  }
  const SmoothLeg curve = smooth_leg(leg, places_m_);
  std::vector<Vec2> points;
  for (int i = 1; i <= kPointsOfLeg; ++i) {
    points.push_back(curve.point_m(static_cast<double>(i) / kPointsOfLeg));
  }
  return points;
}

std::vector<std::size_t> PathShape::places_of(std::size_t leg) const {
  std::size_t first = leg - 1;
  std::size_t last = leg;
  if (kind_.path == TagPathKind::kSmooth) {
    first = leg >= 2 ? leg - 2 : 0;
    last = std::min(leg + 1, route_.size() - 1);
  } else if (kind_.path == TagPathKind::kCircleThrough) {
    first = 0;
    last = route_.size() - 1;
  } else if (kind_.path == TagPathKind::kCircleAbout) {
    first = last = 0;
  }
  std::vector<std::size_t> places(route_.begin() + static_cast<std::ptrdiff_t>(first),
                                  route_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

double PathShape::across_m(std::size_t leg, const Vec2& p_m, const std::vector<Vec2>& places_m) const {
  switch (kind_.path) {
    case TagPathKind::kPolyline:
      break;
    case TagPathKind::kSmooth:
      return smooth_leg(leg, places_m).at(p_m).across_m;
    case TagPathKind::kCircleThrough:
    case TagPathKind::kCircleAbout: {
      const Circle c = circle(places_m);
      return (kind_.circle_left ? 1.0 : -1.0) * (c.radius_m - (p_m - c.centre_m).norm());
    }
  }
  return on_line(places_m[route_[leg - 1]], places_m[route_[leg]], p_m).across_m;
}

PathShape::Beside PathShape::beside(std::size_t leg, const Vec2& p_m) const {
  Beside out;
  std::vector<Vec2> moved = places_m_;
  for (const int axis : {0, 1}) {
    const Vec2 step = axis == 0 ? Vec2{kStep_m, 0.0} : Vec2{0.0, kStep_m};
    out.by_robot(axis) =
        (across_m(leg, p_m + step, places_m_) - across_m(leg, p_m - step, places_m_)) / (2.0 * kStep_m);
  }
  for (const std::size_t place : places_of(leg)) {
    Pull pull{place, {0.0, 0.0}};
    for (const int axis : {0, 1}) {
      moved[place](axis) = places_m_[place](axis) + kStep_m;
      const double above = across_m(leg, p_m, moved);
      moved[place](axis) = places_m_[place](axis) - kStep_m;
      pull.by_place(axis) = (above - across_m(leg, p_m, moved)) / (2.0 * kStep_m);
      moved[place](axis) = places_m_[place](axis);
    }
    out.by_places.push_back(pull);
  }
  return out;
}

}  // namespace sensotwin::robot
