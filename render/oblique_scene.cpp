// SPDX-License-Identifier: MIT
#include "render/oblique_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/plane_geometry.hpp"
#include "render/ticks.hpp"

namespace sensotwin::render {
namespace {

/// What is left of a wall that stands between the eye and the floor, and of walls inside the room.
constexpr double kCutWall_m = 0.12;
constexpr double kInnerWall_m = 0.90;
constexpr double kWallThickness_m = 0.07;

constexpr Rgba kWallFace = rgb(0xEDF1F5);
constexpr Rgba kWallTop = rgb(0x5B6672);
constexpr Rgba kWood = rgb(0xC99E63);

[[nodiscard]] Vec3 lifted(const Vec2& p, double z_m) {
  return {p.x(), p.y(), z_m};
}

/// A wire a finger's breadth nearer to the eye than its place, so that the face it lies on does not swallow
/// it.
void edge(Scene3d& scene, Mesh& mesh, const Vec3& a, const Vec3& b, double width_px, Rgba color) {
  const Vec3 nearer = 0.012 * (scene.eye_m - (a + b) / 2.0).normalized();
  mesh.wire(a + nearer, b + nearer, width_px * scene.line_m(), scene.eye_m, color);
}

void edges_around(Scene3d& scene, std::span<const Vec2> polygon, double z_m, double width_px, Rgba color) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    edge(scene, scene.solid, lifted(polygon[i], z_m), lifted(polygon[(i + 1) % polygon.size()], z_m),
         width_px, color);
  }
}

/// Where a prism keeps the lamp off the floor: its base, and the base moved along the light.
void shadow(Scene3d& scene, const Polygon& base, double height_m) {
  const Vec2 shift = Vec2{0.16, 0.10} * std::min(height_m, 1.2);
  std::vector<Vec2> points = base;
  for (const Vec2& p : base) {
    points.push_back(p + shift);
  }
  scene.ground.fill(convex_hull(std::move(points)), palette::kInk.with_alpha(46));
}

void add_block(Scene3d& scene, const Polygon& outline, double bottom_m, double top_m, bool corner_edges) {
  shadow(scene, outline, top_m);
  scene.solid.prism(outline, bottom_m, top_m, palette::kFurniture);
  edges_around(scene, outline, top_m, 1.6, palette::kFurnitureEdge);
  if (corner_edges) {
    for (const Vec2& p : outline) {
      edge(scene, scene.solid, lifted(p, bottom_m), lifted(p, top_m), 1.2, palette::kFurnitureEdge);
    }
  }
}

void add_furniture(Scene3d& scene, const FurnitureView& piece) {
  const Polygon outline = footprint(piece);
  if (outline.size() < 3) {
    return;
  }
  const double top_m = std::max(piece.height_m, 0.01);
  if (piece.kind == FurnitureKind::kLegs) {
    // A table top is about 3 cm thick.
    constexpr double kTop_m = 0.03;
    for (const CircleView& leg : piece.circles) {
      scene.solid.prism(circle_polygon(leg, 0.001), 0.0, top_m - kTop_m, kWood);
    }
    add_block(scene, outline, top_m - kTop_m, top_m, false);
    return;
  }
  const bool raised = piece.kind == FurnitureKind::kRaised;
  const double bottom_m = raised ? std::min(piece.clearance_m, top_m - 0.01) : 0.0;
  add_block(scene, outline, bottom_m, top_m, outline.size() <= 8);
}

/// Whether a wall from a to b would stand between the eye and what lies on the room's side of it.
[[nodiscard]] bool stands_in_front(const Scene3d& scene, const Vec2& a, const Vec2& b, bool room_is_left) {
  const Vec2 along = b - a;
  const Vec2 inward = room_is_left ? Vec2{-along.y(), along.x()} : Vec2{along.y(), -along.x()};
  return inward.dot(scene.eye_m.head<2>() - (a + b) / 2.0) < 0.0;
}

void add_wall_segment(Scene3d& scene, const Vec2& a, const Vec2& b, double height_m) {
  const Vec2 along = b - a;
  if (along.norm() <= 0.0) {
    return;
  }
  const Vec2 unit = along.normalized() * (kWallThickness_m / 2.0);
  const Vec2 aside{-unit.y(), unit.x()};
  const Polygon base{a - unit - aside, b + unit - aside, b + unit + aside, a - unit + aside};
  scene.solid.sides(base, 0.0, height_m, kWallFace);
  scene.solid.fill(base, kWallTop, height_m);
}

/// The walls of a map as a model cut off at one height, with solid tops where it shows something solid.
void add_traced_walls(Scene3d& scene, const SceneView& view) {
  const double height_m = std::min(kTracedWall_m, view.ceiling_m);
  const WallView* room = room_of(view);
  for (const WallView& wall : view.walls) {
    const std::size_t n = wall.points_m.size();
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
      add_wall_segment(scene, wall.points_m[i], wall.points_m[(i + 1) % n], height_m);
    }
    if (room != nullptr && encloses_matter(wall, *room)) {
      scene.solid.fill(wall.points_m, palette::kMasonry, height_m);
    }
  }
}

void add_walls(Scene3d& scene, const SceneView& view) {
  if (traced(view)) {
    add_traced_walls(scene, view);
    return;
  }
  const WallView* room = room_of(view);
  for (const WallView& wall : view.walls) {
    const std::size_t n = wall.points_m.size();
    const std::size_t segments = n < 2 ? 0 : (wall.closed ? n : n - 1);
    const bool room_is_left = signed_area(wall.points_m) > 0.0;
    for (std::size_t i = 0; i < segments; ++i) {
      const Vec2& a = wall.points_m[i];
      const Vec2& b = wall.points_m[(i + 1) % n];
      if (&wall != room) {
        add_wall_segment(scene, a, b, std::min(kInnerWall_m, view.ceiling_m));
        continue;
      }
      const bool front = stands_in_front(scene, a, b, room_is_left);
      add_wall_segment(scene, a, b, front ? std::min(kCutWall_m, view.ceiling_m) : view.ceiling_m);
      if (!front) {
        edge(scene, scene.glass, lifted(a, view.ceiling_m), lifted(b, view.ceiling_m), 2.0, kWallTop);
      }
    }
  }
}

/// In a hall the robot would be a speck: one with antennas to show is drawn 20 lines in radius at least, with
/// all that is on it.
[[nodiscard]] double robot_scale(const Scene3d& scene, const RobotView& robot) {
  const bool grown = robot.radius_m > 0.0 && !robot.antennas.empty();
  return grown ? std::max(1.0, 20.0 * scene.line_m() / robot.radius_m) : 1.0;
}

/// Patches on the robot's lid, each on a mast as high as it is mounted.
void add_antennas(Scene3d& scene, const RobotView& robot, double scale) {
  for (const AntennaView& antenna : robot.antennas) {
    const Vec2 at = robot.X_WR * Vec2(scale * antenna.at_m);
    const double top_m = std::max(scale * antenna.height_m, scale * robot.height_m + 0.01);
    // A patch antenna on a Roomba is about 7 cm wide.
    const Polygon patch = square(at, 0.07 * scale, robot.X_WR.yaw_rad);
    scene.solid.prism(patch, top_m, top_m + 0.02 * scale, palette::kSky);
    edges_around(scene, patch, top_m + 0.02 * scale, 1.2, palette::kInk);
    scene.solid.prism(square(at, 0.02 * scale, robot.X_WR.yaw_rad), 0.0, top_m, palette::kInk);
  }
}

/// From the antennas to the tag that is headed for.
void add_rays(Scene3d& scene, const SceneView& view, double scale) {
  if (!view.robot || !view.target_tag || *view.target_tag >= view.ceiling_tags.size()) {
    return;
  }
  const CeilingTagView& tag = view.ceiling_tags[*view.target_tag];
  for (const AntennaView& antenna : view.robot->antennas) {
    const Vec3 from = lifted(view.robot->X_WR * Vec2(scale * antenna.at_m), scale * antenna.height_m + 0.02);
    edge(scene, scene.glass, from, lifted(tag.at_m, tag.height_m), 2.4, palette::kVermilion);
  }
}

void add_robot(Scene3d& scene, const RobotView& true_robot) {
  RobotView robot = true_robot;
  const double scale = robot_scale(scene, robot);
  robot.radius_m *= scale;
  robot.height_m *= scale;
  const Vec2& p = robot.X_WR.p_m;
  const CircleView body{p, robot.radius_m};
  const double top_m = robot.height_m;
  shadow(scene, circle_polygon(body, 0.001), top_m);
  scene.solid.prism(circle_polygon(body, 0.001), 0.0, top_m, rgb(0x4A545F));
  scene.solid.disc({p, 0.86 * robot.radius_m}, palette::kRobot, top_m + 0.004);
  const double r = robot.radius_m;
  const Polygon arrow{robot.X_WR * Vec2{0.72 * r, 0.0}, robot.X_WR * Vec2{-0.36 * r, 0.48 * r},
                      robot.X_WR * Vec2{-0.14 * r, 0.0}, robot.X_WR * Vec2{-0.36 * r, -0.48 * r}};
  scene.solid.fill(arrow, palette::kOrange, top_m + 0.008);
  add_antennas(scene, true_robot, scale);
}

void add_ceiling_tags(Scene3d& scene, const SceneView& view) {
  for (const CeilingTagView& tag : view.ceiling_tags) {
    const Vec3 top = lifted(tag.at_m, tag.height_m);
    constexpr int kDashes = 24;
    for (int i = 0; i < kDashes; i += 2) {
      edge(scene, scene.glass, lifted(tag.at_m, tag.height_m * i / kDashes),
           lifted(tag.at_m, tag.height_m * (i + 1) / kDashes), 1.6, palette::kCeilingTag.with_alpha(150));
    }
    scene.ground.ring({tag.at_m, 0.05}, 2.0 * scene.line_m(), palette::kCeilingTag);
    const Vec3 right = Vec3{0.0, 0.0, 1.0}.cross(scene.eye_m - top).normalized() * (9.0 * scene.line_m());
    const Vec3 up = (scene.eye_m - top).cross(right).normalized() * (9.0 * scene.line_m());
    scene.glass.quad(top + right, top + up, top - right, top - up, palette::kCeilingTag);
  }
}

/// Without a room the things would hang in the air: a floor a little larger than they are, with a grid of
/// round lengths.
void add_open_floor(Scene3d& scene, const SceneView& view) {
  const auto [low, high] = open_floor(view);
  scene.ground.fill(std::array{low, Vec2{high.x(), low.y()}, high, Vec2{low.x(), high.y()}}, palette::kFloor);
  const double step = round_length_below(140.0 * scene.line_m());
  const auto line = [&](const Vec2& from, const Vec2& to) {
    scene.ground.stroke(std::array{from, to}, false, 1.5 * scene.line_m(), palette::kHairline);
  };
  for (double x = std::ceil(low.x() / step) * step; x <= high.x(); x += step) {
    line({x, low.y()}, {x, high.y()});
  }
  for (double y = std::ceil(low.y() / step) * step; y <= high.y(); y += step) {
    line({low.x(), y}, {high.x(), y});
  }
}

}  // namespace

bool needs_open_floor(const SceneView& view) {
  return room_of(view) == nullptr && view.tiles.empty();
}

std::pair<Vec2, Vec2> open_floor(const SceneView& view) {
  const Extent extent = extent_of(view);
  const double rim_m = std::max(0.3, 0.06 * extent.size_m().maxCoeff());
  return {extent.min_m - Vec2{rim_m, rim_m}, extent.max_m + Vec2{rim_m, rim_m}};
}

Scene3d oblique_scene(const SceneView& view, const Vec3& eye_m, double px_per_m, double line_px,
                      TileStyle style) {
  Scene3d scene;
  scene.eye_m = eye_m;
  scene.px_per_m = px_per_m;
  scene.line_px = line_px;
  layers::floor(scene.ground, view);
  if (needs_open_floor(view)) {
    add_open_floor(scene, view);
  }
  layers::tiles(scene.ground, view, px_per_m, line_px, style);
  layers::ground_marks(scene.ground, view, px_per_m, line_px);
  for (const FurnitureView& piece : view.furniture) {
    add_furniture(scene, piece);
  }
  layers::estimates(scene.ground, view, px_per_m, line_px);
  layers::trajectory(scene.ground, view, px_per_m, line_px, 0.0);
  layers::ideal_path(scene.ground, view, px_per_m, line_px);
  if (view.start) {
    scene.ground.disc({view.start->p_m, 13.0 * scene.line_m()}, palette::kPaper);
    scene.ground.ring({view.start->p_m, 11.0 * scene.line_m()}, 3.5 * scene.line_m(), palette::kBlue);
  }
  if (view.home_base) {
    const Pose2& X_WH = *view.home_base;
    const Polygon plate{X_WH * Vec2{0.06, -0.08}, X_WH * Vec2{0.06, 0.08}, X_WH * Vec2{-0.07, 0.11},
                        X_WH * Vec2{-0.07, -0.11}};
    scene.solid.prism(plate, 0.0, 0.09, palette::kGreen);
  }
  for (const LandmarkView& mark : view.landmarks) {
    scene.solid.prism(square(mark.at_m, 0.09, 0.0), 0.0, 0.14, palette::kGreen);
  }
  add_walls(scene, view);
  add_ceiling_tags(scene, view);
  if (view.robot) {
    add_robot(scene, *view.robot);
    add_rays(scene, view, robot_scale(scene, *view.robot));
  }
  return scene;
}

}  // namespace sensotwin::render
