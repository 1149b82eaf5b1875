// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// How the way between the tags' projections runs.
enum class TagPathKind : std::uint8_t {
  kPolyline,       ///< straight from projection to projection (Gueaieb & Miah)
  kSmooth,         ///< centripetal Catmull-Rom curve through the projections (algorithms study, A.5)
  kCircleThrough,  ///< the circle through three or more projections (least squares), tag after tag
  kCircleAbout,    ///< a circle of given radius about the first tag
};

/// The point of a path nearest to the robot, and the robot against it.
struct PathReference {
  double across_m{0.0};         ///< robot beside the path, left of travel positive
  double yaw_rad{0.0};          ///< of the path's tangent
  double curvature_per_m{0.0};  ///< left bend positive
  double to_go_m{0.0};          ///< along the path to the end of the leg; negative behind it
  double part{0.0};             ///< of the leg, 0 at its beginning, 1 at its end
};

/// A directed straight leg. \pre from_m != to_m
[[nodiscard]] PathReference on_line(const Vec2& from_m, const Vec2& to_m, const Vec2& p_m);

/// One leg of a centripetal Catmull-Rom curve (alpha = 1/2), from p1 to p2. Where the curve begins or ends,
/// the neighbour is mirrored: p0 = 2 p1 - p2 (algorithms study, A.5).
class SmoothLeg {
 public:
  /// \pre p1_m != p2_m
  SmoothLeg(const std::optional<Vec2>& p0_m, const Vec2& p1_m, const Vec2& p2_m,
            const std::optional<Vec2>& p3_m);
  [[nodiscard]] PathReference at(const Vec2& p_m) const;
  /// \param part  0 at p1, 1 at p2
  [[nodiscard]] Vec2 point_m(double part) const;
  /// Cubic Bezier control points of the same leg, for drawing.
  [[nodiscard]] std::span<const Vec2> coefficients() const { return c_; }

 private:
  /// point = c0 + c1 s + c2 s^2 + c3 s^3, s the part.
  std::array<Vec2, 4> c_;
};

struct Circle {
  Vec2 centre_m{0.0, 0.0};
  double radius_m{1.0};
};

/// Through three points exactly, through more by least squares (Kasa: of |p - c|^2 - r^2).
/// \returns none when they lie on a line
[[nodiscard]] std::optional<Circle> circle_through(std::span<const Vec2> points_m);

/// \param end_m  the leg ends where the circle is nearest to this  \param left  counter-clockwise
[[nodiscard]] PathReference on_circle(const Circle& circle, bool left, const Vec2& from_m, const Vec2& end_m,
                                      const Vec2& p_m);

}  // namespace sensotwin::robot
