// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/phase/estimation/tag_path.hpp"

namespace sensotwin::robot {

/// A path through tags whose places are known, leg by leg: what the bound is computed along. Frame: that of
/// the places.
class PathShape {
 public:
  struct Kind {
    TagPathKind path{TagPathKind::kPolyline};
    bool circle_left{true};
    double circle_radius_m{2.0};
    double circle_laps{1.0};
  };
  /// \param route  indices of places  \pre not empty; no leg but the first has length zero; a circle through
  /// tags has three that lie on one
  PathShape(const Kind& kind, std::vector<Vec2> places_m, std::vector<std::size_t> route,
            const Vec2& start_m);

  /// Of the first, the way from the start.
  [[nodiscard]] std::size_t legs() const;
  /// Corners or close points of a leg, its end last, its beginning left out.
  [[nodiscard]] std::vector<Vec2> points_m(std::size_t leg) const;

  /// How the error beside a leg changes with the places of its tags.
  struct Pull {
    std::size_t place{0};
    Vec2 by_place{0.0, 0.0};
  };
  struct Beside {
    Vec2 by_robot{0.0, 0.0};
    std::vector<Pull> by_places;
  };
  /// Gradient of the signed distance from the path at a point near it. \pre 0 < leg < legs()
  [[nodiscard]] Beside beside(std::size_t leg, const Vec2& p_m) const;

 private:
  [[nodiscard]] std::vector<std::size_t> places_of(std::size_t leg) const;
  [[nodiscard]] double across_m(std::size_t leg, const Vec2& p_m, const std::vector<Vec2>& places_m) const;
  [[nodiscard]] SmoothLeg smooth_leg(std::size_t leg, const std::vector<Vec2>& places_m) const;
  [[nodiscard]] Circle circle(const std::vector<Vec2>& places_m) const;
  [[nodiscard]] std::vector<Vec2> arc_m(const Vec2& from_m, double turn_rad) const;

  Kind kind_;
  std::vector<Vec2> places_m_;
  std::vector<std::size_t> route_;
  Vec2 start_m_;
};

}  // namespace sensotwin::robot
