// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "render/views.hpp"

namespace sensotwin::render {

using Polygon = std::vector<Vec2>;

/// Positive when counter-clockwise (shoelace formula).
[[nodiscard]] double signed_area(std::span<const Vec2> polygon);
/// Even-odd rule; points on the edge may fall either way.
[[nodiscard]] bool inside(std::span<const Vec2> polygon, const Vec2& p);
/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
[[nodiscard]] Polygon convex_hull(std::vector<Vec2> points);
/// Ear clipping: index triples that cover a simple polygon of either sense. Fewer than three corners give
/// none; a polygon that crosses itself is covered as well as it can be.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> polygon);
/// Corners of a circle, enough of them that the chord stays within `sagitta` of the arc (8 to 96).
[[nodiscard]] Polygon circle_polygon(const CircleView& circle, double sagitta);
/// A square with middle, side and yaw.
[[nodiscard]] Polygon square(const Vec2& center, double side, double yaw_rad);
/// The outline that a piece of furniture shows from above: its outline, or the hull of its circles.
[[nodiscard]] Polygon footprint(const FurnitureView& piece);
/// The ellipse that holds `probability` of a plane normal distribution. A covariance with negative
/// eigenvalues (rounding) is flat, not an error. \pre finite, 0 < probability < 1
[[nodiscard]] Ellipse ellipse_of(const Eigen::Matrix2d& covariance_m2, double probability = 0.95);
/// Points around an ellipse, closed by the first.
[[nodiscard]] Polygon ellipse_outline(const Vec2& center_m, const Ellipse& ellipse);
/// Drops points nearer than `step` to the last kept one; the last point always stays. Keeps drawing 10^5
/// points cheap.
[[nodiscard]] std::vector<TimedPoint> thinned(std::span<const TimedPoint> path, double step);

}  // namespace sensotwin::render
