// SPDX-License-Identifier: MIT
#include "twin/run/scene_views.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace sensotwin::twin {
namespace {

std::string_view label_of(world::LandmarkKind kind) {
  switch (kind) {
    case world::LandmarkKind::kDoorOpeningSide:
    case world::LandmarkKind::kDoorFixedSide:
      return "door";
    case world::LandmarkKind::kFrontDoorOpeningSide:
    case world::LandmarkKind::kFrontDoorFixedSide:
      return "front door";
    case world::LandmarkKind::kWindowLeft:
    case world::LandmarkKind::kWindowRight:
      return "window";
    case world::LandmarkKind::kPowerOutlet:
      return "outlet";
    case world::LandmarkKind::kClosetLeft:
    case world::LandmarkKind::kClosetRight:
      break;
  }
  return "closet";
}

render::FurnitureView view_of(const world::Furniture& piece, const world::Pose2& X_WF,
                              double robot_height_m) {
  render::FurnitureView view;
  view.name = piece.name;
  view.height_m = piece.height_m;
  view.clearance_m = piece.clearance_m;
  const bool raised = piece.clearance_m > robot_height_m;
  view.kind = raised ? render::FurnitureKind::kRaised : render::FurnitureKind::kSolid;
  switch (piece.shape) {
    case world::FurnitureShape::kCircle:
      view.circles.push_back({X_WF.p_m, piece.radius_m});
      break;
    case world::FurnitureShape::kBox:
      for (const auto& [x, y] :
           std::array<std::pair<double, double>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
        view.outline_m.push_back(X_WF * world::Vec2{x * piece.size_m.x() / 2.0, y * piece.size_m.y() / 2.0});
      }
      break;
    case world::FurnitureShape::kPolygon:
      for (const world::Vec2& corner : piece.points_m) {
        view.outline_m.push_back(X_WF * corner);
      }
      break;
    case world::FurnitureShape::kLegs:
      view.kind = render::FurnitureKind::kLegs;
      for (const world::Vec2& leg : piece.points_m) {
        view.circles.push_back({X_WF * leg, piece.leg_radius_m});
      }
      break;
  }
  return view;
}

}  // namespace

world::Vec2 tile_centre_m(const world::Carpet& carpet, int column, int row) {
  return carpet.origin_m + carpet.tile_m * world::Vec2{column + 0.5, row + 0.5};
}

render::SceneView view_of(const Scene& scene, std::span<const world::Tag> tags,
                          std::span<const world::Pose2> X_WF) {
  render::SceneView view;
  view.title = scene.title;
  view.scene = scene.name;
  view.seed = scene.seed;
  for (const world::Wall& wall : scene.world.walls) {
    view.walls.push_back({wall.points_m, wall.closed});
  }
  for (std::size_t i = 0; i < scene.world.furniture.size(); ++i) {
    const world::Furniture& piece = scene.world.furniture[i];
    view.furniture.push_back(
        view_of(piece, i < X_WF.size() ? X_WF[i] : piece.X_WF, scene.robot.base.height_m));
  }
  for (const auto& [column, row] : scene.world.carpet.tiles) {
    view.tiles.push_back({.center_m = tile_centre_m(scene.world.carpet, column, row),
                          .size_m = scene.world.carpet.tile_m,
                          .yaw_rad = 0.0,
                          .state = render::TileState::kUnvisited,
                          .label = {}});
  }
  for (const world::Tag& tag : tags) {
    if (tag.place == world::TagPlace::kCarpet) {
      view.tags.push_back({tag.at_m, !tag.readable});
    }
  }
  for (const world::Landmark& landmark : scene.world.landmarks) {
    view.landmarks.push_back({landmark.at_m, std::string(label_of(landmark.kind))});
  }
  for (const world::Cliff& cliff : scene.world.cliffs) {
    view.cliffs_m.push_back(cliff.corners_m);
  }
  for (const world::VirtualWall& wall : scene.world.virtual_walls) {
    view.virtual_walls.push_back({wall.X_WV, wall.range_m, wall.half_angle_rad});
  }
  if (scene.world.home_base) {
    view.home_base = scene.world.home_base->X_WH;
  }
  view.start = scene.robot.X_WR_start;
  view.ceiling_m = scene.world.ceiling_m;
  view.north_yaw_rad = scene.world.north_yaw_rad;
  return view;
}

render::PhaseRunView plan_of(const Scene& scene, std::span<const world::Pose2> X_WF) {
  render::SceneView scenery = view_of(scene, {}, X_WF);
  render::PhaseRunView view;
  view.title = scene.title;
  view.scene = scene.name;
  view.seed = scene.seed;
  view.walls = std::move(scenery.walls);
  view.furniture = std::move(scenery.furniture);
  for (const world::Person& person : scene.world.people) {
    view.people.push_back({person.path_m, person.radius_m});
  }
  view.start = scene.robot.X_WR_start;
  view.robot_radius_m = scene.robot.base.radius_m;
  return view;
}

}  // namespace sensotwin::twin
