// SPDX-License-Identifier: MIT
#include "render/scene_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sensotwin::render {
namespace {

constexpr Rgba kHatch = rgb(0x9A5B3A);
constexpr Rgba kUnreachableMark = rgb(0x7C73B0);
constexpr Rgba kCliff = rgb(0x5B4A68);

constexpr double kHalf = 0.5;
// Kept off the edges: furniture covers most of a blocked tile, and clipped crosses around it look like dirt.
const std::array blocked_marks{TileMark{{-0.2, -0.2}, {0.2, 0.2}, kHatch, 0.04},
                               TileMark{{-0.2, 0.2}, {0.2, -0.2}, kHatch, 0.04}};
const std::array unreachable_marks{TileMark{{-kHalf, 0.0}, {0.0, kHalf}, kUnreachableMark, 0.04},
                                   TileMark{{-kHalf, -kHalf}, {kHalf, kHalf}, kUnreachableMark, 0.04},
                                   TileMark{{0.0, -kHalf}, {kHalf, 0.0}, kUnreachableMark, 0.04}};
const std::array missed_marks{TileMark{{-0.28, -0.28}, {0.28, 0.28}, palette::kVermilion, 0.11},
                              TileMark{{-0.28, 0.28}, {0.28, -0.28}, palette::kVermilion, 0.11}};
const std::array wrong_marks{TileMark{{0.0, 0.32}, {0.0, -0.08}, palette::kPurple, 0.12},
                             TileMark{{0.0, -0.29}, {0.0, -0.31}, palette::kPurple, 0.13}};

void furniture(Mesh& mesh, const FurnitureView& piece, double px_per_m, double line_px) {
  const double line_m = line_px / px_per_m;
  const Polygon outline = footprint(piece);
  if (piece.kind == FurnitureKind::kSolid) {
    mesh.fill(outline, palette::kFurniture);
    mesh.stroke(outline, true, 2.0 * line_m, palette::kFurnitureEdge);
    for (const CircleView& circle : piece.circles) {
      mesh.ring(circle, 1.5 * line_m, palette::kFurnitureEdge);
    }
    return;
  }
  // See-through, because the robot and its path go on below.
  mesh.fill(outline, palette::kFurniture.with_alpha(110));
  mesh.stroke(outline, true, 2.0 * line_m, palette::kFurnitureEdge, 0.0, {8.0 * line_m, 6.0 * line_m});
  if (piece.kind == FurnitureKind::kLegs) {
    for (const CircleView& leg : piece.circles) {
      // A leg of 5 cm is 6 pixels in a README picture: never draw it thinner than can be seen.
      mesh.disc({leg.center_m, std::max(leg.radius_m, 4.0 * line_m)}, palette::kFurnitureEdge);
    }
  }
}

/// What colour lies where: tiles by their place in the carpet's grid.
class Floor {
 public:
  explicit Floor(const SceneView& view) {
    if (view.tiles.empty()) {
      return;
    }
    origin_m_ = view.tiles.front().center_m;
    size_m_ = view.tiles.front().size_m;
    for (const TileView& tile : view.tiles) {
      colors_.insert_or_assign(cell(tile.center_m), tile_color(tile.state));
    }
  }
  [[nodiscard]] Rgba color_at(const Vec2& p_m) const {
    const auto found = colors_.find(cell(p_m));
    return found == colors_.end() ? palette::kFloor : found->second;
  }

 private:
  [[nodiscard]] std::pair<long, long> cell(const Vec2& p_m) const {
    const Vec2 sides = (p_m - origin_m_) / size_m_;
    return {std::lround(sides.x()), std::lround(sides.y())};
  }
  Vec2 origin_m_{0.0, 0.0};
  double size_m_{1.0};
  std::map<std::pair<long, long>, Rgba> colors_;
};

void landmark(Mesh& mesh, const Vec2& at, double line_m) {
  const Polygon diamond = square(at, 15.0 * line_m, robot::kPi / 4.0);
  mesh.fill(diamond, palette::kGreen);
  mesh.stroke(diamond, true, 2.0 * line_m, palette::kPaper);
}

void home_base(Mesh& mesh, const Pose2& X_WH, double line_m) {
  // iRobot's home base is about 0.22 m wide; drawn as a low house-shaped plate behind its contacts.
  const Polygon plate{X_WH * Vec2{0.0, -0.11}, X_WH * Vec2{0.06, -0.05}, X_WH * Vec2{0.06, 0.05},
                      X_WH * Vec2{0.0, 0.11},  X_WH * Vec2{-0.07, 0.11}, X_WH * Vec2{-0.07, -0.11}};
  mesh.fill(plate, palette::kGreen);
  mesh.stroke(plate, true, 1.5 * line_m, palette::kPaper);
}

void start_mark(Mesh& mesh, const Pose2& X, double line_m) {
  const CircleView mark{X.p_m, 11.0 * line_m};
  mesh.disc({X.p_m, mark.radius_m + 2.0 * line_m}, palette::kPaper);
  mesh.ring(mark, 3.5 * line_m, palette::kBlue);
  mesh.disc({X.p_m, 4.5 * line_m}, palette::kBlue);
}

/// From the antennas to below the tag that is headed for.
void rays(Mesh& mesh, const SceneView& view, double line_m) {
  if (!view.robot || !view.target_tag || *view.target_tag >= view.ceiling_tags.size()) {
    return;
  }
  for (const AntennaView& antenna : view.robot->antennas) {
    const std::array ends{view.robot->X_WR * antenna.at_m, view.ceiling_tags[*view.target_tag].at_m};
    mesh.stroke(ends, false, 1.6 * line_m, palette::kVermilion);
  }
}

void robot_disc(Mesh& mesh, const RobotView& robot, double line_m) {
  const Vec2& p = robot.X_WR.p_m;
  mesh.disc({p, robot.radius_m + 2.0 * line_m}, palette::kPaper);
  mesh.disc({p, robot.radius_m}, palette::kRobot);
  mesh.ring({p, robot.radius_m * 0.80}, 1.5 * line_m, palette::kSoftInk);
  const double r = robot.radius_m;
  const Polygon arrow{robot.X_WR * Vec2{0.72 * r, 0.0}, robot.X_WR * Vec2{-0.36 * r, 0.48 * r},
                      robot.X_WR * Vec2{-0.14 * r, 0.0}, robot.X_WR * Vec2{-0.36 * r, -0.48 * r}};
  mesh.fill(arrow, palette::kOrange);
}

}  // namespace

std::span<const TileMark> marks_of(TileState state) {
  switch (state) {
    case TileState::kBlocked:
      return blocked_marks;
    case TileState::kUnreachable:
      return unreachable_marks;
    case TileState::kMissed:
      return missed_marks;
    case TileState::kWrong:
      return wrong_marks;
    default:
      return {};
  }
}

Rgba fill_of(TileState state, TileStyle style) {
  if (style == TileStyle::kRecovered) {
    if (state == TileState::kGrey || state == TileState::kBlack) {
      return palette::kBlue.with_alpha(105);
    }
    return tile_color(state).with_alpha(state == TileState::kUnvisited ? 0 : 200);
  }
  return tile_color(state);
}

const WallView* room_of(const SceneView& view) {
  const WallView* room = nullptr;
  double largest = 0.0;
  for (const WallView& wall : view.walls) {
    const double area = wall.closed ? std::abs(signed_area(wall.points_m)) : 0.0;
    if (area > largest) {
      largest = area;
      room = &wall;
    }
  }
  return room;
}

bool traced(const SceneView& view) {
  // Chosen: people draw walls of metres, maps have cells of 2 to 10 cm.
  constexpr double kDrawn_m = 0.25;
  double length_m = 0.0;
  std::size_t sides = 0;
  for (const WallView& wall : view.walls) {
    const std::size_t n = wall.points_m.size();
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
      length_m += (wall.points_m[(i + 1) % n] - wall.points_m[i]).norm();
      ++sides;
    }
  }
  return sides > 0 && length_m < kDrawn_m * static_cast<double>(sides);
}

bool encloses_matter(const WallView& wall, const WallView& room) {
  return &wall != &room && wall.closed && wall.points_m.size() >= 3 &&
         (signed_area(wall.points_m) > 0.0) != (signed_area(room.points_m) > 0.0) &&
         inside(room.points_m, wall.points_m.front());
}

double time_end_s(const SceneView& view) {
  if (view.time_end_s) {
    return *view.time_end_s;
  }
  return view.trajectory.empty() ? 0.0 : view.trajectory.back().t_s;
}

namespace layers {

void floor(Mesh& mesh, const SceneView& view) {
  if (const WallView* room = room_of(view)) {
    mesh.fill(room->points_m, palette::kFloor);
  }
}

void matter(Mesh& mesh, const SceneView& view) {
  const WallView* room = room_of(view);
  for (const WallView& wall : view.walls) {
    if (room != nullptr && encloses_matter(wall, *room)) {
      mesh.fill(wall.points_m, palette::kMasonry);
    }
  }
}

void tiles(Mesh& mesh, const SceneView& view, double px_per_m, double line_px, TileStyle style) {
  const double line_m = line_px / px_per_m;
  for (const TileView& tile : view.tiles) {
    // A gap of a line between tiles keeps the grid visible whatever the colours.
    const double side = std::max(tile.size_m - line_m, 0.6 * tile.size_m);
    const Polygon corners = square(tile.center_m, side, tile.yaw_rad);
    mesh.fill(corners, fill_of(tile.state, style));
    if (tile.state == TileState::kUnvisited) {
      mesh.stroke(corners, true, line_m, palette::kHairline);
    }
    const Pose2 X_WT{tile.center_m, tile.yaw_rad};
    for (const TileMark& mark : marks_of(tile.state)) {
      const std::array ends{X_WT * Vec2(side * mark.from), X_WT * Vec2(side * mark.to)};
      const bool hatch = mark.width < 0.05;
      mesh.stroke(ends, false, std::max(mark.width * side, hatch ? line_m : 2.0 * line_m), mark.color);
    }
    if (tile.state == TileState::kMissed || tile.state == TileState::kWrong) {
      const Rgba edge = tile.state == TileState::kMissed ? palette::kVermilion : palette::kPurple;
      mesh.stroke(square(tile.center_m, side - 2.0 * line_m, tile.yaw_rad), true, 2.0 * line_m, edge);
    }
  }
}

void ground_marks(Mesh& mesh, const SceneView& view, double px_per_m, double line_px) {
  const double line_m = line_px / px_per_m;
  for (const auto& cliff : view.cliffs_m) {
    mesh.fill(cliff, kCliff);
    mesh.stroke(cliff, true, 3.0 * line_m, palette::kOrange, 0.0, {9.0 * line_m, 9.0 * line_m});
  }
  for (const VirtualWallView& fan : view.virtual_walls) {
    const double reach = fan.range_m * std::tan(std::min(fan.half_angle_rad, 1.4));
    const Polygon beam{fan.X_WV.p_m, fan.X_WV * Vec2{fan.range_m, -reach},
                       fan.X_WV * Vec2{fan.range_m, reach}};
    mesh.fill(beam, palette::kPink.with_alpha(90));
    mesh.disc({fan.X_WV.p_m, 6.0 * line_m}, palette::kPink);
  }
  const Floor below(view);
  for (const TagView& tag : view.tags) {
    if (tag.dead) {
      mesh.disc({tag.at_m, 7.0 * line_m}, palette::kPaper);
      mesh.ring({tag.at_m, 4.5 * line_m}, 2.5 * line_m, palette::kVermilion);
    } else {
      const bool dark = luminance(below.color_at(tag.at_m)) < 0.3;
      mesh.disc({tag.at_m, 2.6 * line_m}, dark ? palette::kHairline : palette::kSoftInk);
    }
  }
}

void ideal_path(Mesh& mesh, const SceneView& view, double px_per_m, double line_px) {
  const double line_m = line_px / px_per_m;
  mesh.stroke(view.ideal_path_m, view.ideal_closed, 2.2 * line_m, palette::kInk, 0.0,
              {11.0 * line_m, 11.0 * line_m});
}

void estimates(Mesh& mesh, const SceneView& view, double px_per_m, double line_px) {
  for (const EstimateView& estimate : view.estimates) {
    const Polygon rim = ellipse_outline(estimate.at_m, estimate.ellipse);
    mesh.fill(std::span(rim).first(rim.size() - 1), palette::kCeilingTag.with_alpha(38));
    mesh.stroke(rim, false, 2.4 * line_px / px_per_m, palette::kCeilingTag);
  }
}

void trajectory(Mesh& mesh, const SceneView& view, double px_per_m, double line_px, double z_m) {
  const double line_m = line_px / px_per_m;
  // Half a pixel: closer points cannot be told apart.
  const std::vector<TimedPoint> path = thinned(view.trajectory, 0.5 / px_per_m);
  const double end_s = time_end_s(view);
  const auto color_at = [end_s](double t_s) { return time_color(end_s > 0.0 ? t_s / end_s : 0.0); };
  if (path.size() == 1) {
    mesh.disc({path[0].p_m, 3.0 * line_m}, color_at(path[0].t_s), z_m);
  }
  // A dark casing below all of it keeps pale colours visible on white tiles and blue ones on dark tiles.
  std::vector<Vec2> whole;
  whole.reserve(path.size());
  for (const TimedPoint& point : path) {
    whole.push_back(point.p_m);
  }
  mesh.stroke(whole, false, 6.0 * line_m, palette::kInk, z_m);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const std::array ends{path[i].p_m, path[i + 1].p_m};
    mesh.stroke(ends, false, 3.6 * line_m, color_at(path[i + 1].t_s), z_m);
  }
}

}  // namespace layers

std::vector<Vertex> top_view_triangles(const SceneView& view, double px_per_m, double line_px,
                                       TileStyle style) {
  const double line_m = line_px / px_per_m;
  Mesh mesh;
  layers::floor(mesh, view);
  const auto all_furniture = [&] {
    for (const FurnitureView& piece : view.furniture) {
      furniture(mesh, piece, px_per_m, line_px);
    }
  };
  if (style == TileStyle::kRecovered) {
    all_furniture();
    layers::tiles(mesh, view, px_per_m, line_px, style);
    layers::ground_marks(mesh, view, px_per_m, line_px);
    layers::matter(mesh, view);
  } else {
    layers::tiles(mesh, view, px_per_m, line_px, style);
    layers::ground_marks(mesh, view, px_per_m, line_px);
    layers::matter(mesh, view);
    all_furniture();
  }
  layers::estimates(mesh, view, px_per_m, line_px);
  layers::trajectory(mesh, view, px_per_m, line_px, 0.0);
  layers::ideal_path(mesh, view, px_per_m, line_px);
  const double wall_px =
      traced(view) ? 3.0 : 6.0;  // wide lines would run the steps and specks of a map together
  for (const WallView& wall : view.walls) {
    mesh.stroke(wall.points_m, wall.closed, wall_px * line_m, palette::kWall);
  }
  for (const CeilingTagView& tag : view.ceiling_tags) {
    // Where its plumb line meets the floor.
    const Polygon diamond = square(tag.at_m, 12.0 * line_m, robot::kPi / 4.0);
    mesh.fill(diamond, palette::kCeilingTag);
    mesh.stroke(diamond, true, 2.0 * line_m, palette::kPaper);
  }
  for (const LandmarkView& mark : view.landmarks) {
    landmark(mesh, mark.at_m, line_m);
  }
  if (view.home_base) {
    home_base(mesh, *view.home_base, line_m);
  }
  if (view.start) {
    start_mark(mesh, *view.start, line_m);
  }
  if (view.robot) {
    rays(mesh, view, line_m);
    robot_disc(mesh, *view.robot, line_m);
    for (const AntennaView& antenna : view.robot->antennas) {
      const Vec2 at = view.robot->X_WR * antenna.at_m;
      // A patch antenna on a Roomba is about 7 cm wide; never smaller than can be seen.
      const Polygon patch = square(at, std::max(0.07, 5.0 * line_m), view.robot->X_WR.yaw_rad);
      mesh.fill(patch, palette::kSky);
      mesh.stroke(patch, true, 1.2 * line_m, palette::kInk);
    }
  }
  return mesh.take();
}

}  // namespace sensotwin::render
