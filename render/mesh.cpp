// SPDX-License-Identifier: MIT
#include "render/mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sensotwin::render {
namespace {

// Chord error of round shapes. Chosen: a tenth of a pixel at 200 pixels per metre.
constexpr double kSagitta_m = 0.0005;

[[nodiscard]] Vertex vertex(const Vec3& p, Rgba color) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), color};
}

[[nodiscard]] Vec3 at(const Vec2& p, double z_m) {
  return {p.x(), p.y(), z_m};
}

/// Whether a line bends at b so much (8 degrees) that a notch would show on its outer side.
[[nodiscard]] bool turns(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 in = b - a;
  const Vec2 out = c - b;
  return in.dot(out) < 0.99 * in.norm() * out.norm() || in.isZero() || out.isZero();
}

}  // namespace

double light_on(const Vec3& normal) {
  const Vec3 lamp = Vec3{-0.45, -0.30, 0.84}.normalized();
  // Shares of soft light and lamp, chosen so that the darkest side keeps its colour; divided by what faces up
  // get.
  const auto lit = [&lamp](const Vec3& n) { return 0.66 + 0.34 * std::max(0.0, n.dot(lamp)); };
  return lit(normal) / lit(Vec3::UnitZ());
}

void Mesh::triangle(const Vec3& a, const Vec3& b, const Vec3& c, Rgba color) {
  vertices_.push_back(vertex(a, color));
  vertices_.push_back(vertex(b, color));
  vertices_.push_back(vertex(c, color));
}

void Mesh::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Rgba color) {
  triangle(a, b, c, color);
  triangle(a, c, d, color);
}

void Mesh::fill(std::span<const Vec2> polygon, Rgba color, double z_m) {
  for (const auto& [a, b, c] : triangulate(polygon)) {
    triangle(at(polygon[a], z_m), at(polygon[b], z_m), at(polygon[c], z_m), color);
  }
}

void Mesh::disc(const CircleView& circle, Rgba color, double z_m) {
  const Polygon rim = circle_polygon(circle, kSagitta_m);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    triangle(at(circle.center_m, z_m), at(rim[i], z_m), at(rim[(i + 1) % rim.size()], z_m), color);
  }
}

void Mesh::ring(const CircleView& circle, double width_m, Rgba color, double z_m) {
  const Polygon outer = circle_polygon({circle.center_m, circle.radius_m + width_m / 2.0}, kSagitta_m);
  const double shrink = std::max(0.0, circle.radius_m - width_m / 2.0) / (circle.radius_m + width_m / 2.0);
  const auto in = [&](const Vec2& p) -> Vec2 { return circle.center_m + shrink * (p - circle.center_m); };
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Vec2& a = outer[i];
    const Vec2& b = outer[(i + 1) % outer.size()];
    quad(at(a, z_m), at(b, z_m), at(in(b), z_m), at(in(a), z_m), color);
  }
}

void Mesh::segment(const Vec2& a, const Vec2& b, double width_m, Rgba color, double z_m) {
  const Vec2 along = b - a;
  const double length = along.norm();
  if (length <= 0.0) {
    return;
  }
  const Vec2 aside = Vec2{-along.y(), along.x()} * (width_m / 2.0 / length);
  quad(at(a - aside, z_m), at(b - aside, z_m), at(b + aside, z_m), at(a + aside, z_m), color);
}

void Mesh::stroke(std::span<const Vec2> points, bool closed, double width_m, Rgba color, double z_m,
                  Dash dash) {
  const std::size_t n = points.size();
  const std::size_t segments = n < 2 ? 0 : (closed ? n : n - 1);
  double into_m = 0.0;  // how far into the dash pattern the next segment begins
  for (std::size_t i = 0; i < segments; ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % n];
    const double length = (b - a).norm();
    if (dash.off_m <= 0.0 || length <= 0.0) {
      segment(a, b, width_m, color, z_m);
      continue;
    }
    const double period = dash.on_m + dash.off_m;
    for (double s = -into_m; s < length; s += period) {
      const double from = std::max(0.0, s);
      const double to = std::min(length, s + dash.on_m);
      if (to > from) {
        segment(a + (b - a) * (from / length), a + (b - a) * (to / length), width_m, color, z_m);
      }
    }
    into_m = std::fmod(into_m + length, period);
  }
  if (dash.off_m <= 0.0) {
    for (std::size_t i = 0; i < n; ++i) {
      const bool end = !closed && (i == 0 || i + 1 == n);
      if (end || turns(points[(i + n - 1) % n], points[i], points[(i + 1) % n])) {
        joint(points[i], width_m, color, z_m);
      }
    }
  }
}

/// Twelve corners: a tenth of a pixel from round on the widest line, which is 6 pixels.
void Mesh::joint(const Vec2& p, double width_m, Rgba color, double z_m) {
  static const Polygon rim = circle_polygon({{0.0, 0.0}, 1.0}, 0.035);
  const double r = width_m / 2.0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    triangle(at(p, z_m), at(p + r * rim[i], z_m), at(p + r * rim[(i + 1) % rim.size()], z_m), color);
  }
}

void Mesh::sides(std::span<const Vec2> polygon, double bottom_m, double top_m, Rgba color) {
  const double sense = signed_area(polygon) >= 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const Vec2 along = b - a;
    if (along.norm() <= 0.0) {
      continue;
    }
    const Vec3 normal = sense * Vec3{along.y(), -along.x(), 0.0}.normalized();
    quad(at(a, bottom_m), at(b, bottom_m), at(b, top_m), at(a, top_m), shaded(color, light_on(normal)));
  }
}

void Mesh::prism(std::span<const Vec2> polygon, double bottom_m, double top_m, Rgba color) {
  sides(polygon, bottom_m, top_m, color);
  fill(polygon, color, top_m);
}

void Mesh::wire(const Vec3& a, const Vec3& b, double width_m, const Vec3& eye_m, Rgba color) {
  const Vec3 along = b - a;
  const Vec3 aside = along.cross(eye_m - (a + b) / 2.0);
  if (aside.norm() <= 0.0) {
    return;
  }
  const Vec3 half = aside.normalized() * (width_m / 2.0);
  quad(a - half, b - half, b + half, a + half, color);
}

}  // namespace sensotwin::render
