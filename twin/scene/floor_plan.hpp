// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "twin/scene/map_import.hpp"
#include "twin/scene/plane.hpp"
#include "twin/scene/scene.hpp"
#include "world/description.hpp"

namespace sensotwin::twin {

struct Box {
  Vec2 low_m{0.0, 0.0};
  Vec2 high_m{0.0, 0.0};
};

/// Where there is floor, and how far the next obstacle is: what carpeting, the choice of a start and the
/// checks ask.
class FloorPlan {
 public:
  /// \param outer_m  corners of the outer wall
  explicit FloorPlan(std::vector<Vec2> outer_m);
  explicit FloorPlan(OccupancyMap map);

  [[nodiscard]] bool has_floor_at(const Vec2& p_W) const;
  /// Around all floor.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

 private:
  std::vector<Vec2> outer_m_;
  std::optional<OccupancyMap> map_;
  Box bounds_;
};

/// Corners of a box or polygon in the world; legs' or a circle's middles.
[[nodiscard]] std::vector<Vec2> footprint_m(const world::Furniture& piece);
/// From a segment (or a point, both ends equal) to the piece's edge; 0 inside.
[[nodiscard]] double distance_m(const Segment& way, const world::Furniture& piece);

/// Fills carpet.tiles and the rest of the carpet from the plan. Reading order: row by row from the bottom.
[[nodiscard]] world::Carpet lay_carpet(const CarpetPlan& plan, const FloorPlan& floor);

/// A start for a scene that names none: the middle of a tile with 5 cm around the robot. Among the tiles that
/// straight moves between neighbours connect, the largest group is taken, and in it the tile nearest to the
/// group's middle. \returns nothing when there is no such tile
[[nodiscard]] std::optional<robot::Pose2> find_start(const Scene& scene);

}  // namespace sensotwin::twin
