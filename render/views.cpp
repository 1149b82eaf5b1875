// SPDX-License-Identifier: MIT
#include "render/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "render/plane_geometry.hpp"

namespace sensotwin::render {
namespace {

// Chosen because no house is larger, and float vertices still resolve a millimetre there.
constexpr double kFarthest_m = 10'000.0;

class FaultFinder {
 public:
  void number(double value, std::string_view what, std::size_t index) {
    if (!fault_ && (!std::isfinite(value) || std::abs(value) > kFarthest_m)) {
      fault_ =
          RenderError{RenderError::Kind::kBadView,
                      fmt::format("cannot draw {} {}: {} is not a number within 10 km", what, index, value)};
    }
  }
  void size(double value, std::string_view what, std::size_t index) {
    number(value, what, index);
    if (!fault_ && value < 0.0) {
      fault_ = RenderError{RenderError::Kind::kBadView,
                           fmt::format("cannot draw {} {}: its size {} is negative", what, index, value)};
    }
  }
  void point(const Vec2& p, std::string_view what, std::size_t index) {
    number(p.x(), what, index);
    number(p.y(), what, index);
  }
  void pose(const Pose2& X, std::string_view what, std::size_t index) {
    point(X.p_m, what, index);
    number(X.yaw_rad, what, index);
  }
  void points(std::span<const Vec2> all, std::string_view what, std::size_t index) {
    for (const Vec2& p : all) {
      point(p, what, index);
    }
  }
  /// Time may be larger than any length, but must be finite.
  void time(double t_s, std::size_t index) {
    if (!fault_ && !std::isfinite(t_s)) {
      fault_ = RenderError{RenderError::Kind::kBadView,
                           fmt::format("cannot draw trajectory point {}: its time is {}", index, t_s)};
    }
  }
  [[nodiscard]] std::optional<RenderError> fault() const { return fault_; }

 private:
  std::optional<RenderError> fault_;
};

void check_things(const SceneView& view, FaultFinder& find) {
  for (std::size_t i = 0; i < view.walls.size(); ++i) {
    find.points(view.walls[i].points_m, "wall", i);
  }
  for (std::size_t i = 0; i < view.furniture.size(); ++i) {
    const FurnitureView& piece = view.furniture[i];
    find.points(piece.outline_m, "furniture", i);
    for (const CircleView& circle : piece.circles) {
      find.point(circle.center_m, "furniture", i);
      find.size(circle.radius_m, "furniture", i);
    }
    find.size(piece.height_m, "furniture", i);
    find.size(piece.clearance_m, "furniture", i);
  }
  for (std::size_t i = 0; i < view.tiles.size(); ++i) {
    find.point(view.tiles[i].center_m, "tile", i);
    find.size(view.tiles[i].size_m, "tile", i);
    find.number(view.tiles[i].yaw_rad, "tile", i);
  }
  for (std::size_t i = 0; i < view.cliffs_m.size(); ++i) {
    find.points(view.cliffs_m[i], "cliff", i);
  }
  for (std::size_t i = 0; i < view.virtual_walls.size(); ++i) {
    find.pose(view.virtual_walls[i].X_WV, "virtual wall", i);
    find.size(view.virtual_walls[i].range_m, "virtual wall", i);
    find.size(view.virtual_walls[i].half_angle_rad, "virtual wall", i);
  }
}

void check_marks(const SceneView& view, FaultFinder& find) {
  for (std::size_t i = 0; i < view.tags.size(); ++i) {
    find.point(view.tags[i].at_m, "tag", i);
  }
  for (std::size_t i = 0; i < view.landmarks.size(); ++i) {
    find.point(view.landmarks[i].at_m, "landmark", i);
  }
  for (std::size_t i = 0; i < view.ceiling_tags.size(); ++i) {
    find.point(view.ceiling_tags[i].at_m, "ceiling tag", i);
    find.size(view.ceiling_tags[i].height_m, "ceiling tag", i);
  }
  find.points(view.ideal_path_m, "ideal path", 0);
  for (std::size_t i = 0; i < view.estimates.size(); ++i) {
    find.point(view.estimates[i].at_m, "estimate", i);
    find.size(view.estimates[i].ellipse.major_m, "estimate", i);
    find.size(view.estimates[i].ellipse.minor_m, "estimate", i);
    find.number(view.estimates[i].ellipse.yaw_rad, "estimate", i);
  }
  for (std::size_t i = 0; i < view.trajectory.size(); ++i) {
    find.point(view.trajectory[i].p_m, "trajectory point", i);
    find.time(view.trajectory[i].t_s, i);
  }
  if (view.home_base) {
    find.pose(*view.home_base, "home base", 0);
  }
  if (view.start) {
    find.pose(*view.start, "start", 0);
  }
  if (view.robot) {
    find.pose(view.robot->X_WR, "robot", 0);
    find.size(view.robot->radius_m, "robot", 0);
    find.size(view.robot->height_m, "robot", 0);
    for (std::size_t i = 0; i < view.robot->antennas.size(); ++i) {
      find.point(view.robot->antennas[i].at_m, "antenna", i);
      find.size(view.robot->antennas[i].height_m, "antenna", i);
    }
  }
  if (view.time_end_s) {
    find.time(*view.time_end_s, 0);
  }
  find.size(view.ceiling_m, "ceiling", 0);
  find.number(view.north_yaw_rad, "north", 0);
}

}  // namespace

std::optional<RenderError> first_fault(const SceneView& view) {
  FaultFinder find;
  check_things(view, find);
  check_marks(view, find);
  return find.fault();
}

std::vector<Vec2> outline_of(const SceneView& view) {
  std::vector<Vec2> points;
  const auto add = [&points](const Vec2& p) { points.push_back(p); };
  const auto add_around = [&points](const Vec2& p, double r_m) {
    points.insert(points.end(),
                  {p + Vec2{r_m, r_m}, p + Vec2{r_m, -r_m}, p - Vec2{r_m, r_m}, p - Vec2{r_m, -r_m}});
  };
  for (const WallView& wall : view.walls) {
    std::for_each(wall.points_m.begin(), wall.points_m.end(), add);
  }
  for (const FurnitureView& piece : view.furniture) {
    std::for_each(piece.outline_m.begin(), piece.outline_m.end(), add);
    for (const CircleView& circle : piece.circles) {
      add_around(circle.center_m, circle.radius_m);
    }
  }
  for (const TileView& tile : view.tiles) {
    add_around(tile.center_m, tile.size_m / 2.0);
  }
  for (const TimedPoint& point : view.trajectory) {
    add(point.p_m);
  }
  for (const auto& cliff : view.cliffs_m) {
    std::for_each(cliff.begin(), cliff.end(), add);
  }
  for (const CeilingTagView& tag : view.ceiling_tags) {
    add(tag.at_m);
  }
  std::for_each(view.ideal_path_m.begin(), view.ideal_path_m.end(), add);
  if (view.robot) {
    add_around(view.robot->X_WR.p_m, view.robot->radius_m);
  }
  if (view.home_base) {
    // iRobot's home base reaches about 10 cm from its contacts.
    add_around(view.home_base->p_m, 0.1);
  }
  return convex_hull(std::move(points));
}

Extent extent_of(const SceneView& view) {
  const std::vector<Vec2> outline = outline_of(view);
  if (outline.empty()) {
    return {{-0.5, -0.5}, {0.5, 0.5}};
  }
  Extent extent{outline.front(), outline.front()};
  for (const Vec2& p : outline) {
    extent.min_m = extent.min_m.cwiseMin(p);
    extent.max_m = extent.max_m.cwiseMax(p);
  }
  // At least 10 cm each way, so that a single point still has a scale.
  const Vec2 grow = (Vec2{0.1, 0.1} - extent.size_m()).cwiseMax(0.0) / 2.0;
  return {extent.min_m - grow, extent.max_m + grow};
}

}  // namespace sensotwin::render
