// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/drawing.hpp"
#include "render/plane_geometry.hpp"
#include "render/projection.hpp"

namespace sensotwin::render {

/// How a flat ribbon is dashed: `on` and `off` in metres; off = 0 draws it whole.
struct Dash {
  double on_m{0.0};
  double off_m{0.0};
};

/// Turns shapes into triangles, in the order they are to be seen. Widths and lengths are metres of W.
class Mesh {
 public:
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c, Rgba color);
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Rgba color);
  /// A simple polygon lying flat at height z.
  void fill(std::span<const Vec2> polygon, Rgba color, double z_m = 0.0);
  void disc(const CircleView& circle, Rgba color, double z_m = 0.0);
  void ring(const CircleView& circle, double width_m, Rgba color, double z_m = 0.0);
  /// A flat line with round joints and ends.
  void stroke(std::span<const Vec2> points, bool closed, double width_m, Rgba color, double z_m = 0.0,
              Dash dash = {});
  /// The sides of a prism over a polygon, each face lit by its direction.
  void sides(std::span<const Vec2> polygon, double bottom_m, double top_m, Rgba color);
  /// The same with its lid.
  void prism(std::span<const Vec2> polygon, double bottom_m, double top_m, Rgba color);
  /// A straight line in space, `width_m` wide, turned to the eye.
  void wire(const Vec3& a, const Vec3& b, double width_m, const Vec3& eye_m, Rgba color);

  [[nodiscard]] std::vector<Vertex> take() { return std::move(vertices_); }
  [[nodiscard]] bool empty() const { return vertices_.empty(); }

 private:
  void segment(const Vec2& a, const Vec2& b, double width_m, Rgba color, double z_m);
  void joint(const Vec2& p, double width_m, Rgba color, double z_m);
  std::vector<Vertex> vertices_;
};

/// Brightness of a face with this outward normal (unit length): a soft light from everywhere and a lamp high
/// up behind the viewer's left shoulder; 1 for a face that looks straight up.
[[nodiscard]] double light_on(const Vec3& normal);

}  // namespace sensotwin::render
