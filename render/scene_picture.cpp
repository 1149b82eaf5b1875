// SPDX-License-Identifier: MIT
#include "render/scene_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/tag_names.hpp"

namespace sensotwin::render {
namespace {

[[nodiscard]] double px_per_m_for(const Extent& extent, double width_px, double height_px, double border_px) {
  return std::min((width_px - 2.0 * border_px) / extent.size_m().x(),
                  (height_px - 2.0 * border_px) / extent.size_m().y());
}

/// Places labels so that none lies on another.
class Labels {
 public:
  explicit Labels(RectPx within) : within_(within) {}
  [[nodiscard]] bool claim(const RectPx& box) {
    const bool outside = box.x < within_.x || box.y < within_.y || box.right() > within_.right() ||
                         box.bottom() > within_.bottom();
    if (outside ||
        std::any_of(taken_.begin(), taken_.end(), [&](const RectPx& b) { return b.overlaps(box); })) {
      return false;
    }
    taken_.push_back(box);
    return true;
  }
  /// Nothing may be written there.
  void keep_clear(const RectPx& box) { taken_.push_back(box); }
  [[nodiscard]] const std::vector<RectPx>& taken() const { return taken_; }

 private:
  RectPx within_;
  std::vector<RectPx> taken_;
};

/// A piece's name in its middle, upright or, in a tall piece, turned; left out when it would not fit.
void draw_furniture_name(Canvas& canvas, Labels& labels, const FurnitureView& piece, const Projection& X,
                         double u) {
  const Polygon outline = footprint(piece);
  if (piece.name.empty() || outline.size() < 3) {
    return;
  }
  Vec2 low = X.pixel(outline[0]);
  Vec2 high = low;
  for (const Vec2& p : outline) {
    low = low.cwiseMin(X.pixel(p));
    high = high.cwiseMax(X.pixel(p));
  }
  const Vec2 middle = (low + high) / 2.0;
  const Vec2 size = high - low;
  TextStyle style{22.0 * u, palette::kInk, false, Align::kCenter, 0.0, palette::kFurniture.with_alpha(220)};
  const double margin = 10.0 * u;
  const bool turned = size.y() > size.x() && canvas.width_of(piece.name, style) > size.x() - margin;
  const double along = (turned ? size.y() : size.x()) - margin;
  const double across = (turned ? size.x() : size.y()) - 4.0 * u;
  style.turn_rad = turned ? robot::kPi / 2.0 : 0.0;
  style = canvas.fitted(piece.name, style, along, 0.75);
  const double width = canvas.width_of(piece.name, style);
  if (width > along || style.size_px > across) {
    return;
  }
  const Vec2 box = turned ? Vec2{style.size_px, width} : Vec2{width, style.size_px};
  if (labels.claim({middle.x() - box.x() / 2.0, middle.y() - box.y() / 2.0, box.x(), box.y()})) {
    canvas.text(middle, piece.name, style);
  }
}

/// Whether a wall runs through the box, to a pixel or two.
[[nodiscard]] bool wall_under(const SceneView& view, const Projection& X, const RectPx& box) {
  const double step = std::max(1.0, box.height / 3.0);
  for (const WallView& wall : view.walls) {
    const std::size_t n = wall.points_m.size();
    for (std::size_t i = 0; i + (wall.closed ? 0 : 1) < n; ++i) {
      const Vec2 from = X.pixel(wall.points_m[i]);
      const Vec2 along = X.pixel(wall.points_m[(i + 1) % n]) - from;
      const int steps = static_cast<int>(std::ceil(along.norm() / step));
      for (int k = 0; k <= steps; ++k) {
        const Vec2 p = from + along * (static_cast<double>(k) / std::max(1, steps));
        if (p.x() > box.x && p.x() < box.right() && p.y() > box.y && p.y() < box.bottom()) {
          return true;
        }
      }
    }
  }
  return false;
}

/// Beside its point: right, left, below or above, off the walls wherever there is room; left out where there
/// is none.
void draw_point_label(Canvas& canvas, Labels& labels, const SceneView& view, const Projection& X,
                      const Vec2& at_m, const std::string& text, double u) {
  if (text.empty()) {
    return;
  }
  const Vec2 at_px = X.pixel(at_m);
  const TextStyle plain{19.0 * u, palette::kInk, false, Align::kLeft, 0.0, palette::kPaper.with_alpha(225)};
  const double width = canvas.width_of(text, plain);
  const double h = plain.size_px;
  const double gap = 16.0 * u;
  const std::array offsets{Vec2{gap, -h / 2.0}, Vec2{-gap - width, -h / 2.0}, Vec2{-width / 2.0, gap},
                           Vec2{-width / 2.0, -gap - h}};
  for (const bool off_walls : {true, false}) {
    for (const Vec2& offset : offsets) {
      const RectPx box{at_px.x() + offset.x(), at_px.y() + offset.y(), width, h};
      if ((!off_walls || !wall_under(view, X, box)) && labels.claim(box)) {
        canvas.text({box.x, box.center().y()}, text, plain);
        return;
      }
    }
  }
}

void draw_tile_labels(Canvas& canvas, const SceneView& view, const Projection& X, double px_per_m,
                      TileStyle tiles, double u) {
  for (const TileView& tile : view.tiles) {
    const double side = tile.size_m * px_per_m;
    const bool dark = tiles == TileStyle::kStates && luminance(tile_color(tile.state)) <= 0.3;
    const Rgba ink = dark ? palette::kPaper : palette::kInk;
    const TextStyle wanted{std::min(18.0 * u, 0.4 * side), ink, false, Align::kCenter};
    const TextStyle style = canvas.fitted(tile.label, wanted, 0.85 * side, 0.6);
    // Below 9 units it could not be read: leave it out.
    if (!tile.label.empty() && style.size_px >= 9.0 * u && canvas.width_of(tile.label, style) <= 0.9 * side) {
      canvas.text(X.pixel(tile.center_m), tile.label, style);
    }
  }
}

void draw_names(Canvas& canvas, const SceneView& view, const Picture& picture, TileStyle tiles, double u) {
  const Projection& pixel_from_W = picture.pixel_from_W;
  draw_tile_labels(canvas, view, pixel_from_W, pixel_from_W.px_per_m(Vec3::Zero()), tiles, u);
  // Names may reach a little over the plot's edge: there is white paper.
  const RectPx plot = picture.plot;
  const RectPx room{plot.x - 30.0 * u, plot.y - 24.0 * u, plot.width + 60.0 * u, plot.height + 40.0 * u};
  Labels labels(room);
  if (view.robot) {
    const double r = view.robot->radius_m * pixel_from_W.px_per_m(Vec3::Zero());
    const Vec2 c = pixel_from_W.pixel(view.robot->X_WR.p_m);
    labels.keep_clear({c.x() - r, c.y() - r, 2.0 * r, 2.0 * r});
  }
  for (const FurnitureView& piece : view.furniture) {
    draw_furniture_name(canvas, labels, piece, pixel_from_W, u);
  }
  for (const LandmarkView& mark : view.landmarks) {
    draw_point_label(canvas, labels, view, pixel_from_W, mark.at_m, mark.label, u);
  }
  LabelPlacer placer(room);
  for (const RectPx& box : labels.taken()) {
    placer.keep_clear(box);
  }
  draw_tag_names(canvas, view, pixel_from_W, placer, false, u);
}

}  // namespace

Rendered<Picture> draw_plan(OffscreenContext& context, const SceneView& view, const Extent& extent,
                            int width_px, int height_px, double line_px, TileStyle tiles) {
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  // Half a wall and a little paper around the outermost thing.
  const double px_per_m = px_per_m_for(extent, width_px, height_px, 5.0 * line_px);
  Picture picture;
  picture.plot = {0.0, 0.0, static_cast<double>(width_px), static_cast<double>(height_px)};
  picture.pixel_from_W = Projection::top(extent.center_m(), picture.plot.center(), px_per_m);
  Drawing drawing;
  drawing.width_px = width_px;
  drawing.height_px = height_px;
  drawing.clip_from_W = picture.pixel_from_W.clip_from_world(width_px, height_px);
  drawing.layers.push_back({top_view_triangles(view, px_per_m, line_px, tiles), false, false});
  auto image = context.draw(drawing);
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

Rendered<Picture> draw_top_view(OffscreenContext& context, const SceneView& view,
                                const PictureOptions& options) {
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  if (auto fault = size_fault(options.width_px, options.height_px)) {
    return Unexpected{*fault};
  }
  const Extent extent = extent_of(view);
  const Sheet sheet =
      sheet_for(options.width_px, options.height_px, extent.size_m().x() / extent.size_m().y());
  const double u = sheet.unit_px;
  const double px_per_m = px_per_m_for(extent, sheet.plot.width, sheet.plot.height, 5.0 * u);
  Picture picture;
  picture.plot = sheet.plot;
  picture.pixel_from_W = Projection::top(extent.center_m(), sheet.plot.center(), px_per_m);
  Drawing drawing;
  drawing.width_px = sheet.width_px;
  drawing.height_px = sheet.height_px;
  drawing.clip_from_W = picture.pixel_from_W.clip_from_world(sheet.width_px, sheet.height_px);
  drawing.layers.push_back({top_view_triangles(view, px_per_m, u, options.tiles), false, false});
  auto image = context.draw(drawing);
  if (!image) {
    return Unexpected{image.error()};
  }
  Canvas canvas = Canvas::over(*image);
  draw_names(canvas, view, picture, options.tiles, u);
  draw_heading(canvas, sheet, view);
  draw_legend(canvas, sheet, view, legend_of(view, options.tiles), options.tiles);
  picture.scale_bar = scale_bar_for(sheet, px_per_m);
  draw_scale_bar(canvas, sheet, picture.scale_bar);
  draw_north(canvas, sheet, {std::cos(view.north_yaw_rad), -std::sin(view.north_yaw_rad)});
  auto finished = canvas.take_image();
  if (!finished) {
    return Unexpected{finished.error()};
  }
  picture.image = std::move(*finished);
  return picture;
}

}  // namespace sensotwin::render
