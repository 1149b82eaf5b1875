// SPDX-License-Identifier: MIT
#include "render/tag_names.hpp"

#include <array>

#include "render/plane_geometry.hpp"

namespace sensotwin::render {
namespace {

[[nodiscard]] std::vector<Vec2> on_floor(const Projection& X, std::span<const Vec2> points_m, bool closed) {
  std::vector<Vec2> line;
  for (const Vec2& p : points_m) {
    line.push_back(X.pixel(p));
  }
  if (closed && !line.empty()) {
    line.push_back(line.front());
  }
  return line;
}

void avoid_lines(const SceneView& view, const Projection& X, LabelPlacer& placer, double u) {
  placer.avoid(on_floor(X, view.ideal_path_m, view.ideal_closed));
  for (const WallView& wall : view.walls) {
    placer.avoid(on_floor(X, wall.points_m, wall.closed));
  }
  std::vector<Vec2> path_m;
  // Steps of about four units: as fine as letters are.
  for (const TimedPoint& point : thinned(view.trajectory, 4.0 * u / X.px_per_m(Vec3::Zero()))) {
    path_m.push_back(point.p_m);
  }
  placer.avoid(on_floor(X, path_m, false));
}

}  // namespace

void draw_tag_names(Canvas& canvas, const SceneView& view, const Projection& X, LabelPlacer& placer,
                    bool hanging, double u) {
  const auto pixel = [&](const CeilingTagView& tag) {
    return X.pixel(Vec3{tag.at_m.x(), tag.at_m.y(), hanging ? tag.height_m : 0.0});
  };
  const double mark = 10.0 * u;
  for (const CeilingTagView& tag : view.ceiling_tags) {
    const Vec2 at = pixel(tag);
    placer.keep_clear({at.x() - mark, at.y() - mark, 2.0 * mark, 2.0 * mark});
    placer.avoid(std::array{at, X.pixel(tag.at_m)});
  }
  if (view.robot && view.target_tag && *view.target_tag < view.ceiling_tags.size()) {
    const Vec2& at = view.robot->X_WR.p_m;
    const double height_m = hanging ? view.robot->height_m : 0.0;
    placer.avoid(
        std::array{X.pixel(Vec3{at.x(), at.y(), height_m}), pixel(view.ceiling_tags[*view.target_tag])});
  }
  if (!hanging) {
    avoid_lines(view, X, placer, u);
  }
  // Many names are written smaller.
  const double size = (view.ceiling_tags.size() > 24 ? 18.0 : 20.0) * u;
  const TextStyle style{size, palette::kInk, false, Align::kLeft, 0.0, palette::kPaper.with_alpha(225)};
  for (const CeilingTagView& tag : view.ceiling_tags) {
    if (tag.label.empty()) {
      continue;
    }
    const Vec2 at = pixel(tag);
    const auto place = placer.place(at, 16.0 * u, {canvas.width_of(tag.label, style), 0.9 * size});
    if (place.far) {
      canvas.line(at, leader_end(place, at), {1.5 * u, palette::kCeilingTag.with_alpha(150), 0.0});
    }
    canvas.text({place.box.x, place.box.center().y()}, tag.label, style);
  }
}

}  // namespace sensotwin::render
