// SPDX-License-Identifier: MIT
#include "world/sonar_ring.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::world {
namespace {

/// Between rays that feel for walls. Chosen: at most half a degree off the nearest point of a wall, 0.04 mm a
/// metre.
constexpr double kRay_rad = robot::rad_from_deg(1.0);
/// What ends this far behind what is in the way stands on it: an end of the very wall that a ray met.
constexpr double kSame_m = 1e-6;

Vec2 direction_of(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

/// The nearest thing that a ray meets.
struct Hit {
  double range_m;
  double incidence_rad{0.0};  ///< from the normal; 0 of a disc
};

Hit first_hit(const Outline& around, const Vec2& from_m, const Vec2& direction, double limit_m) {
  Hit hit{limit_m};
  for (const Segment& wall : around.segments) {
    const double range_m = ray_m(from_m, direction, wall, hit.range_m);
    if (range_m < hit.range_m) {
      const Vec2 along = (wall.b_m - wall.a_m).normalized();
      hit = {range_m, std::asin(std::min(1.0, std::abs(along.dot(direction))))};
    }
  }
  for (const Disc& disc : around.discs) {
    const double range_m = ray_m(from_m, direction, disc, hit.range_m);
    if (range_m < hit.range_m) {
      hit = {range_m, 0.0};
    }
  }
  return hit;
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// What may lie in a cone: all but walls that end on the same far side of one of its edges. Of a ragged
/// building an eighth is left, and the echoes are the same.
Outline in_cone_of(const Outline& around, const Vec2& from_m, double bearing_rad, double half_angle_rad) {
  const Vec2 left = direction_of(bearing_rad + half_angle_rad);
  const Vec2 right = direction_of(bearing_rad - half_angle_rad);
  // Rays along an edge belong to the cone, whatever their rounding.
  constexpr double kEdge_m2 = 1e-6;
  Outline cone;
  cone.discs = around.discs;
  for (const Segment& wall : around.segments) {
    const Vec2 a = wall.a_m - from_m;
    const Vec2 b = wall.b_m - from_m;
    const bool beyond_left = cross(left, a) > kEdge_m2 && cross(left, b) > kEdge_m2;
    const bool beyond_right = cross(right, a) < -kEdge_m2 && cross(right, b) < -kEdge_m2;
    if (!beyond_left && !beyond_right) {
      cone.segments.push_back(wall);
    }
  }
  return cone;
}

bool same(const Segment& a, const Segment& b) {
  return a.a_m == b.a_m && a.b_m == b.b_m;
}

}  // namespace

SonarRing::SonarRing(const SonarDescription& sonar, const robot::RandomStream& random)
    : sonar_(sonar), noise_(random) {}

Outline SonarRing::within_reach(const ObstacleIndex& fixed, std::span<const Outline> pushed,
                                const Vec2& at_m) const {
  const double far_m = sonar_.max_range_m + sonar_.mount_radius_m;
  Outline around;
  const auto segment = [&](const Segment& wall) {
    // A long wall is told once for each bucket it crosses.
    if (distance_m(at_m, wall) < far_m &&
        std::none_of(around.segments.begin(), around.segments.end(),
                     [&](const Segment& known) { return same(known, wall); })) {
      around.segments.push_back(wall);
    }
  };
  const auto disc = [&](const Disc& leg) {
    if ((at_m - leg.middle_m).norm() - leg.radius_m < far_m) {
      around.discs.push_back(leg);
    }
  };
  const Vec2 box_m{far_m, far_m};
  fixed.near(at_m - box_m, at_m + box_m, segment, disc);
  for (const Outline& outline : pushed) {
    std::for_each(outline.segments.begin(), outline.segments.end(), segment);
    std::for_each(outline.discs.begin(), outline.discs.end(), disc);
  }
  return around;
}

std::optional<double> SonarRing::echo_m(const Outline& around, const Vec2& from_m, double bearing_rad) const {
  double nearest_m = sonar_.max_range_m;
  const auto rays = static_cast<int>(std::ceil(2.0 * sonar_.half_angle_rad / kRay_rad));
  for (int i = 0; i <= rays; ++i) {
    const double off_rad = sonar_.half_angle_rad * (2.0 * i / rays - 1.0);
    const Hit hit = first_hit(around, from_m, direction_of(bearing_rad + off_rad), nearest_m);
    if (hit.incidence_rad <= sonar_.specular_limit_rad) {
      nearest_m = std::min(nearest_m, hit.range_m);
    }
  }
  // What is thinner than the gap between two rays, and what scatters.
  const auto try_point = [&](const Vec2& point_m, double radius_m, double heard_to_m) {
    const Vec2 to_m = point_m - from_m;
    const double range_m = to_m.norm() - radius_m;
    if (range_m >= std::min(nearest_m, heard_to_m)) {
      return;
    }
    const double off_rad = robot::wrap_angle(std::atan2(to_m.y(), to_m.x()) - bearing_rad);
    const bool in_cone = std::abs(off_rad) <= sonar_.half_angle_rad;
    if (in_cone &&
        first_hit(around, from_m, to_m.normalized(), range_m - kSame_m).range_m >= range_m - kSame_m) {
      nearest_m = std::max(0.0, range_m);
    }
  };
  for (const Disc& leg : around.discs) {
    try_point(leg.middle_m, leg.radius_m, sonar_.max_range_m);
  }
  for (const Segment& wall : around.segments) {
    try_point(wall.a_m, 0.0, sonar_.corner_range_m);
    try_point(wall.b_m, 0.0, sonar_.corner_range_m);
  }
  return nearest_m < sonar_.max_range_m ? std::optional{std::max(nearest_m, sonar_.min_range_m)}
                                        : std::nullopt;
}

std::vector<std::optional<double>> SonarRing::echoes_m(const ObstacleIndex& fixed,
                                                       std::span<const Outline> pushed,
                                                       const Pose2& X_WR) const {
  const Outline around = within_reach(fixed, pushed, X_WR.p_m);
  std::vector<std::optional<double>> echoes;
  echoes.reserve(sonar_.bearings_rad.size());
  for (const double bearing_rad : sonar_.bearings_rad) {
    const Vec2 from_m = X_WR * (sonar_.mount_radius_m * direction_of(bearing_rad)).eval();
    const double yaw_rad = X_WR.yaw_rad + bearing_rad;
    echoes.push_back(echo_m(in_cone_of(around, from_m, yaw_rad, sonar_.half_angle_rad), from_m, yaw_rad));
  }
  return echoes;
}

std::vector<std::optional<double>> SonarRing::read_m(const ObstacleIndex& fixed,
                                                     std::span<const Outline> pushed, const Pose2& X_WR) {
  const std::vector<std::optional<double>> echoes = echoes_m(fixed, pushed, X_WR);
  std::vector<std::optional<double>> read = echoes;
  for (std::size_t i = 0; i < read.size(); ++i) {
    // The same numbers are drawn whatever is heard: one sonar's silence does not change another's noise.
    const bool overhears = noise_.chance(sonar_.crosstalk);
    const bool drops = noise_.chance(sonar_.dropout);
    const double noise_m = noise_.normal(0.0, sonar_.noise_sigma_m);
    if (overhears) {
      for (const std::size_t j : {i == 0 ? i : i - 1, i + 1 == read.size() ? i : i + 1}) {
        if (echoes[j] && (!read[i] || *echoes[j] < *read[i])) {
          read[i] = echoes[j];
        }
      }
    }
    if (drops) {
      read[i].reset();
    }
    if (read[i]) {
      read[i] = std::clamp(*read[i] + noise_m, sonar_.min_range_m, sonar_.max_range_m);
    }
  }
  return read;
}

}  // namespace sensotwin::world
