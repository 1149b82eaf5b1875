// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The path that a phase mission is to drive, by the true places of its destinations: what a run is measured
/// against. Frame: W.
class IdealPath {
 public:
  /// \pre scene.mission.phase, scene.world.radio
  explicit IdealPath(const Scene& scene);

  /// Legs that are counted are 1 to legs() - 1: leg 0 is the way from wherever the robot was.
  [[nodiscard]] std::size_t legs() const { return legs_; }
  /// Signed error, left of travel positive: on a polyline against the endless line of the leg, on a curve
  /// against its nearest point. \returns nothing on legs that are not counted
  [[nodiscard]] std::optional<double> error_m(std::size_t leg, const Vec2& p_m) const;
  /// To the nearest point of the path.
  [[nodiscard]] double distance_m(const Vec2& p_m) const { return std::abs(nearest_m(p_m)); }
  /// Corners of a polyline; close points of a curve.
  [[nodiscard]] const std::vector<Vec2>& points_m() const { return points_m_; }
  [[nodiscard]] const Vec2& end_m() const { return points_m_.back(); }

 private:
  /// Signed.
  [[nodiscard]] double nearest_m(const Vec2& p_m) const;

  bool polyline_;
  std::size_t legs_;
  std::vector<Vec2> points_m_;
};

}  // namespace sensotwin::twin
