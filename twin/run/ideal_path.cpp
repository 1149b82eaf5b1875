// SPDX-License-Identifier: MIT
#include "twin/run/ideal_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/phase/estimation/tag_path.hpp"
#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {
namespace {

/// Points of a leg of a curve. Chosen: on a circle of 2 m by 8 tags the chord is 0.06 mm off the arc.
constexpr int kPointsOfLeg = 100;

std::vector<Vec2> places_of(const Scene& scene) {
  std::vector<Vec2> places;
  for (const std::size_t tag : destinations_of(scene)) {
    places.push_back(scene.world.radio->tags[tag].at_m);
  }
  return places;
}

std::vector<Vec2> smooth(const std::vector<Vec2>& corners) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const robot::SmoothLeg leg(i > 0 ? std::optional{corners[i - 1]} : std::nullopt, corners[i],
                               corners[i + 1],
                               i + 2 < corners.size() ? std::optional{corners[i + 2]} : std::nullopt);
    for (int k = 0; k < kPointsOfLeg; ++k) {
      points.push_back(leg.point_m(static_cast<double>(k) / kPointsOfLeg));
    }
  }
  points.push_back(corners.back());
  return points;
}

/// Once round, counter-clockwise or not, from `begin`.
std::vector<Vec2> circle(const robot::Circle& circle, const Vec2& begin, double turn_rad) {
  const Vec2 arm = begin - circle.centre_m;
  const double from = std::atan2(arm.y(), arm.x());
  const int count = 8 * kPointsOfLeg;
  std::vector<Vec2> points;
  for (int k = 0; k <= count; ++k) {
    const double angle = from + turn_rad * k / count;
    points.push_back(circle.centre_m + circle.radius_m * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::vector<Vec2> points_of(const Scene& scene, const std::vector<Vec2>& places) {
  const PhaseMission& mission = *scene.mission.phase;
  switch (mission.path) {
    case PhasePath::kPolyline:
      break;
    case PhasePath::kSmooth:
      return places.size() > 1 ? smooth(places) : places;
    case PhasePath::kCircle:
      if (const auto fitted = robot::circle_through(places)) {
        const double sense = cross(places[1] - places[0], places[2] - places[1]) > 0.0 ? 1.0 : -1.0;
        return circle(*fitted, places.front(), sense * 2.0 * robot::kPi);
      }
      break;
    case PhasePath::kCircleAbout:
      return circle({places.front(), mission.circle_radius_m},
                    places.front() + Vec2{mission.circle_radius_m, 0.0}, 2.0 * robot::kPi);
  }
  return places;
}

}  // namespace

IdealPath::IdealPath(const Scene& scene) : polyline_(scene.mission.phase->path == PhasePath::kPolyline) {
  const std::vector<Vec2> places = places_of(scene);
  points_m_ = points_of(scene, places);
  legs_ = scene.mission.phase->path == PhasePath::kCircleAbout ? 2 : places.size();
}

std::optional<double> IdealPath::error_m(std::size_t leg, const Vec2& p_m) const {
  if (leg == 0 || leg >= legs_) {
    return std::nullopt;
  }
  if (!polyline_) {
    return nearest_m(p_m);
  }
  const Vec2& from = points_m_[leg - 1];
  return cross((points_m_[leg] - from).normalized(), p_m - from);
}

double IdealPath::nearest_m(const Vec2& p_m) const {
  double nearest = std::numeric_limits<double>::infinity();
  double sign = 1.0;
  for (std::size_t i = 0; i + 1 < points_m_.size(); ++i) {
    const Vec2 along = points_m_[i + 1] - points_m_[i];
    const Vec2 off = p_m - points_m_[i];
    const double part = std::clamp(off.dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (off - part * along).norm();
    if (distance < nearest) {
      nearest = distance;
      sign = cross(along, off) < 0.0 ? -1.0 : 1.0;
    }
  }
  return points_m_.size() > 1 ? sign * nearest : (p_m - points_m_.front()).norm();
}

}  // namespace sensotwin::twin
