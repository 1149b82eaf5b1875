// SPDX-License-Identifier: MIT
#include "render/plane_geometry.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sensotwin::render {
namespace {

[[nodiscard]] double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

[[nodiscard]] bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
}

/// Whether corner `i` of the counter-clockwise ring can be cut off.
[[nodiscard]] bool is_ear(std::span<const Vec2> polygon, const std::vector<std::size_t>& ring,
                          std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2& a = polygon[ring[(i + n - 1) % n]];
  const Vec2& b = polygon[ring[i]];
  const Vec2& c = polygon[ring[(i + 1) % n]];
  if (cross(b - a, c - b) <= 0.0) {
    return false;
  }
  return std::none_of(ring.begin(), ring.end(), [&](std::size_t k) {
    const Vec2& p = polygon[k];
    return p != a && p != b && p != c && in_triangle(p, a, b, c);
  });
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice / 2.0;
}

bool inside(std::span<const Vec2> polygon, const Vec2& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      in = !in;
    }
  }
  return in;
}

Polygon convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    return points;
  }
  Polygon hull;
  const auto extend = [&hull](const Vec2& p, std::size_t keep) {
    while (hull.size() >= keep + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2& p : points) {
    extend(p, 0);
  }
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
    extend(*p, lower);
  }
  hull.pop_back();
  return hull;
}

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> polygon) {
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), std::size_t{0});
  if (signed_area(polygon) < 0.0) {
    std::reverse(ring.begin(), ring.end());
  }
  std::size_t i = 0;
  std::size_t since_cut = 0;
  while (ring.size() >= 3) {
    i %= ring.size();
    const std::size_t n = ring.size();
    // After a full round without an ear the polygon crosses itself: cut anyway, so that the loop ends.
    if (since_cut >= n || is_ear(polygon, ring, i)) {
      triangles.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      since_cut = 0;
    } else {
      ++i;
      ++since_cut;
    }
  }
  return triangles;
}

Polygon circle_polygon(const CircleView& circle, double sagitta) {
  // sagitta = r (1 - cos(pi / n)), about r (pi / n)^2 / 2.
  const double exact =
      circle.radius_m > 0.0 ? robot::kPi * std::sqrt(circle.radius_m / (2.0 * sagitta)) : 0.0;
  const int n = std::clamp(static_cast<int>(std::ceil(exact)), 8, 96);
  Polygon polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * robot::kPi * i / n;
    polygon.push_back(circle.center_m + circle.radius_m * Vec2{std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

Polygon square(const Vec2& center, double side, double yaw_rad) {
  const Pose2 X_WS{center, yaw_rad};
  const double h = side / 2.0;
  return {X_WS * Vec2{-h, -h}, X_WS * Vec2{h, -h}, X_WS * Vec2{h, h}, X_WS * Vec2{-h, h}};
}

Polygon footprint(const FurnitureView& piece) {
  if (!piece.outline_m.empty()) {
    return piece.outline_m;
  }
  std::vector<Vec2> rims;
  for (const CircleView& circle : piece.circles) {
    // A millimetre: finer than any picture of a room shows.
    const Polygon rim = circle_polygon(circle, 0.001);
    rims.insert(rims.end(), rim.begin(), rim.end());
  }
  return convex_hull(std::move(rims));
}

Ellipse ellipse_of(const Eigen::Matrix2d& covariance_m2, double probability) {
  const Eigen::Matrix2d symmetric = 0.5 * (covariance_m2 + covariance_m2.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solved(symmetric);
  // Quantile of chi-squared with two degrees of freedom: -2 ln(1 - p), 5.99 for 95 %.
  const double quantile = -2.0 * std::log(1.0 - probability);
  const auto half_axis = [&](double eigenvalue) { return std::sqrt(quantile * std::max(0.0, eigenvalue)); };
  const Vec2 along = solved.eigenvectors().col(1);
  return {half_axis(solved.eigenvalues()[1]), half_axis(solved.eigenvalues()[0]),
          std::atan2(along.y(), along.x())};
}

std::vector<Vec2> ellipse_outline(const Vec2& center_m, const Ellipse& ellipse) {
  // Chosen: on the largest ellipse a picture holds, 400 pixels, the chord stays within a pixel of the arc.
  constexpr int kCorners = 64;
  const Pose2 X_WE{center_m, ellipse.yaw_rad};
  std::vector<Vec2> outline;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * robot::kPi * i / kCorners;
    outline.push_back(X_WE * Vec2{ellipse.major_m * std::cos(angle), ellipse.minor_m * std::sin(angle)});
  }
  return outline;
}

std::vector<TimedPoint> thinned(std::span<const TimedPoint> path, double step) {
  std::vector<TimedPoint> kept;
  for (const TimedPoint& point : path) {
    if (kept.empty() || (point.p_m - kept.back().p_m).norm() >= step) {
      kept.push_back(point);
    }
  }
  if (!path.empty() && kept.back().t_s != path.back().t_s) {
    kept.push_back(path.back());
  }
  return kept;
}

}  // namespace sensotwin::render
