// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "render/oblique_scene.hpp"
#include "render/plane_geometry.hpp"
#include "render/scene_picture.hpp"
#include "render/tag_names.hpp"

namespace sensotwin::render {
namespace {

// The view, chosen by looking: from the south-west, high enough to see every tile behind a table.
constexpr double kAzimuth_rad = robot::rad_from_deg(-118.0);
constexpr double kElevation_rad = robot::rad_from_deg(46.0);
/// Distance of the eye over the room's diagonal: far enough that parallel walls look parallel.
constexpr double kEyeDistance = 2.4;

[[nodiscard]] Vec3 lifted(const Vec2& p, double z_m) {
  return {p.x(), p.y(), z_m};
}

/// Around everything on the picture of an unscaled view: the outline of all things on the floor, and of the
/// walls under the ceiling.
[[nodiscard]] std::pair<Vec2, Vec2> bounds_px(const Projection& view_px, const SceneView& view) {
  Vec2 low{1e300, 1e300};
  Vec2 high = -low;
  const auto add = [&](const Vec2& p_m, double z_m) {
    const Vec2 p = view_px.pixel(Vec3{p_m.x(), p_m.y(), z_m});
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  const Extent extent = extent_of(view);
  if (needs_open_floor(view)) {
    const auto [from, to] = open_floor(view);
    for (const Vec2& p : {from, to, Vec2{from.x(), to.y()}, Vec2{to.x(), from.y()}}) {
      add(p, 0.0);
    }
  }
  const std::vector<Vec2> outline = outline_of(view);
  // Fewer than three corners span nothing: a metre around them does.
  for (const Vec2& p : outline.size() < 3 ? square(extent.center_m(), 1.0, 0.0) : outline) {
    add(p, 0.0);
  }
  if (const WallView* room = room_of(view)) {
    const double top_m = traced(view) ? kTracedWall_m : view.ceiling_m;
    for (const Vec2& p : room->points_m) {
      add(p, top_m);
    }
  }
  for (const FurnitureView& piece : view.furniture) {
    for (const Vec2& p : footprint(piece)) {
      add(p, piece.height_m);
    }
  }
  for (const CeilingTagView& tag : view.ceiling_tags) {
    add(tag.at_m, tag.height_m);
  }
  return {low, high};
}

/// Names stand on the tops of the pieces, where nothing hides them from above.
void draw_names(Canvas& canvas, const SceneView& view, const Projection& X, const RectPx& plot, double u) {
  for (const FurnitureView& piece : view.furniture) {
    const Polygon outline = footprint(piece);
    if (piece.name.empty() || outline.size() < 3) {
      continue;
    }
    Vec2 low{1e300, 1e300};
    Vec2 high = -low;
    for (const Vec2& p : outline) {
      low = low.cwiseMin(X.pixel(lifted(p, piece.height_m)));
      high = high.cwiseMax(X.pixel(lifted(p, piece.height_m)));
    }
    const TextStyle wanted{20.0 * u,       palette::kInk, false,
                           Align::kCenter, 0.0,           palette::kFurniture.with_alpha(200)};
    const double width = 0.9 * (high.x() - low.x());
    const TextStyle style = canvas.fitted(piece.name, wanted, width, 0.75);
    if (canvas.width_of(piece.name, style) <= width && style.size_px < 0.9 * (high.y() - low.y())) {
      canvas.text((low + high) / 2.0, piece.name, style);
    }
  }
  LabelPlacer placer({plot.x - 30.0 * u, plot.y - 24.0 * u, plot.width + 60.0 * u, plot.height + 40.0 * u});
  draw_tag_names(canvas, view, X, placer, true, u);
}

}  // namespace

Rendered<Picture> draw_oblique_view(OffscreenContext& context, const SceneView& view,
                                    const PictureOptions& options) {
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  if (auto fault = size_fault(options.width_px, options.height_px)) {
    return Unexpected{*fault};
  }
  const Extent extent = extent_of(view);
  const Vec3 target = lifted(extent.center_m(), 0.0);
  const double size_m = Vec3{extent.size_m().x(), extent.size_m().y(), view.ceiling_m}.norm();
  const double distance_m = kEyeDistance * size_m;
  const Vec3 eye =
      target + distance_m * Vec3{std::cos(kElevation_rad) * std::cos(kAzimuth_rad),
                                 std::cos(kElevation_rad) * std::sin(kAzimuth_rad), std::sin(kElevation_rad)};
  const Projection raw = perspective(eye, target, 0.3 * distance_m, 2.0 * distance_m);
  const auto [low, high] = bounds_px(raw, view);
  const Vec2 span = high - low;
  const Sheet sheet = sheet_for(options.width_px, options.height_px, span.x() / span.y());
  const double u = sheet.unit_px;
  const double scale = std::min(sheet.plot.width / span.x(), sheet.plot.height / span.y()) * 0.985;
  Picture picture;
  picture.plot = sheet.plot;
  picture.pixel_from_W = raw.scaled_and_moved(scale, sheet.plot.center() - scale * (low + high) / 2.0);
  const double px_per_m = picture.pixel_from_W.px_per_m(target);

  Scene3d scene = oblique_scene(view, eye, px_per_m, u, options.tiles);
  Drawing drawing;
  drawing.width_px = sheet.width_px;
  drawing.height_px = sheet.height_px;
  drawing.clip_from_W = picture.pixel_from_W.clip_from_world(sheet.width_px, sheet.height_px);
  drawing.layers.push_back({scene.ground.take(), false, false});
  drawing.layers.push_back({scene.solid.take(), true, true});
  drawing.layers.push_back({scene.glass.take(), true, false});
  auto image = context.draw(drawing);
  if (!image) {
    return Unexpected{image.error()};
  }
  Canvas canvas = Canvas::over(*image);
  draw_names(canvas, view, picture.pixel_from_W, picture.plot, u);
  draw_heading(canvas, sheet, view);
  draw_legend(canvas, sheet, view, legend_of(view, options.tiles), options.tiles);
  picture.scale_bar = scale_bar_for(sheet, px_per_m);
  draw_scale_bar(canvas, sheet, picture.scale_bar);
  const Vec2 north = {std::cos(view.north_yaw_rad), std::sin(view.north_yaw_rad)};
  const Vec2 north_end = extent.center_m() + north;
  draw_north(canvas, sheet,
             picture.pixel_from_W.pixel(north_end) - picture.pixel_from_W.pixel(extent.center_m()));
  auto finished = canvas.take_image();
  if (!finished) {
    return Unexpected{finished.error()};
  }
  picture.image = std::move(*finished);
  return picture;
}

}  // namespace sensotwin::render
