// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "render/label_placer.hpp"
#include "render/phase_pictures.hpp"
#include "render/plan_marks.hpp"
#include "render/plane_geometry.hpp"
#include "render/scene_layers.hpp"
#include "render/ticks.hpp"

namespace sensotwin::render {
namespace {

constexpr Rgba kGridOnFloor{0x9A, 0xA5, 0xB1, 70};
constexpr double kRibbon = 4.6;  ///< units: the driven path
constexpr double kCasing = 7.2;  ///< units: its dark rim, which keeps pale colours visible

/// The plan under the brush.
struct Plan {
  Canvas& canvas;
  const PhaseRunView& view;
  RectPx plot;
  double u{1.0};
  Projection X;
  double px_per_m{1.0};

  [[nodiscard]] std::vector<Vec2> pixels(std::span<const Vec2> points_m) const {
    std::vector<Vec2> out;
    out.reserve(points_m.size());
    for (const Vec2& p : points_m) {
      out.push_back(X.pixel(p));
    }
    return out;
  }
};

[[nodiscard]] Vec2 heading_px(const Pose2& X) {
  return {std::cos(X.yaw_rad), -std::sin(X.yaw_rad)};
}

/// Never smaller than can be seen.
[[nodiscard]] double robot_radius_px(const Plan& plan) {
  return std::max(plan.view.robot_radius_m * plan.px_per_m, 11.0 * plan.u);
}

/// Around the robot when it came back, so that neither hides the other.
[[nodiscard]] double start_ring_px(const Plan& plan) {
  const double small = 9.5 * plan.u;
  if (!plan.view.end) {
    return small;
  }
  const double apart = plan.px_per_m * (plan.view.end->p_m - plan.view.start->p_m).norm();
  const double around = robot_radius_px(plan) + 8.0 * plan.u;
  return apart < around + small ? std::max(small, around + std::min(apart, small)) : small;
}

void paint_floor(const Plan& plan) {
  SceneView scene;
  scene.walls = plan.view.walls;
  const WallView* room = room_of(scene);
  if (room != nullptr) {
    plan.canvas.fill(plan.pixels(room->points_m), palette::kFloor);
  }
  for (const WallView& wall : scene.walls) {
    if (room != nullptr && encloses_matter(wall, *room)) {
      plan.canvas.fill(plan.pixels(wall.points_m), palette::kMasonry);
    }
  }
}

[[nodiscard]] std::vector<Vec2> wall_px(const Plan& plan, const WallView& wall) {
  std::vector<Vec2> line = plan.pixels(wall.points_m);
  if (wall.closed && !line.empty()) {
    line.push_back(line.front());
  }
  return line;
}

void paint_walls(const Plan& plan) {
  for (const WallView& wall : plan.view.walls) {
    plan.canvas.line(wall_px(plan, wall), {5.0 * plan.u, palette::kWall, 0.0});
  }
}

void paint_furniture(const Plan& plan) {
  const double u = plan.u;
  for (const FurnitureView& piece : plan.view.furniture) {
    std::vector<Vec2> rim = plan.pixels(footprint(piece));
    if (rim.empty()) {
      continue;
    }
    const bool solid = piece.kind == FurnitureKind::kSolid;
    plan.canvas.fill(rim, palette::kFurniture.with_alpha(solid ? 255 : 110));
    rim.push_back(rim.front());
    plan.canvas.line(rim, {2.0 * u, palette::kFurnitureEdge, solid ? 0.0 : 7.0 * u});
    if (piece.kind == FurnitureKind::kLegs) {
      for (const CircleView& leg : piece.circles) {
        plan.canvas.disc(plan.X.pixel(leg.center_m), std::max(leg.radius_m * plan.px_per_m, 3.0 * u),
                         palette::kFurnitureEdge);
      }
    }
  }
}

/// Their ways below their bodies, which stand where they come.
void paint_people(const Plan& plan) {
  for (const PersonView& person : plan.view.people) {
    plan.canvas.line(plan.pixels(person.path_m), {2.6 * plan.u, palette::kGreen, 9.0 * plan.u});
  }
  for (const PersonView& person : plan.view.people) {
    if (!person.path_m.empty()) {
      paint_person(plan.canvas, plan.X.pixel(person.path_m.front()),
                   std::max(person.radius_m * plan.px_per_m, 7.0 * plan.u), plan.u);
    }
  }
}

/// Metres along both sides, light lines across.
void paint_axes(const Plan& plan) {
  const RectPx& plot = plan.plot;
  const double u = plan.u;
  // Where the plot's corners are in W.
  const Vec2 origin_px = plan.X.pixel(Vec2{0.0, 0.0});
  const double left_m = (plot.x - origin_px.x()) / plan.px_per_m;
  const double right_m = (plot.right() - origin_px.x()) / plan.px_per_m;
  const double bottom_m = (origin_px.y() - plot.bottom()) / plan.px_per_m;
  const double top_m = (origin_px.y() - plot.y) / plan.px_per_m;
  const TextStyle style{20.0 * u, palette::kSoftInk, false, Align::kCenter};
  // One spacing for both directions, so that the cells are square; 65 to 160 units apart.
  const double step = round_length_below(160.0 * u / plan.px_per_m);
  const auto each = [step](double low, double high, const auto& put) {
    const int first = static_cast<int>(std::ceil(low / step - 1e-6));
    for (int k = first; k * step <= high + 1e-6 * step; ++k) {
      put(k * step, plain_number(k * step));
    }
  };
  each(left_m, right_m, [&](double value, const std::string& label) {
    const double x = origin_px.x() + value * plan.px_per_m;
    plan.canvas.line({x, plot.y}, {x, plot.bottom()}, {1.5 * u, kGridOnFloor, 0.0});
    plan.canvas.text({x, plot.bottom() + 20.0 * u}, label, style);
  });
  each(bottom_m, top_m, [&](double value, const std::string& label) {
    const double y = origin_px.y() - value * plan.px_per_m;
    plan.canvas.line({plot.x, y}, {plot.right(), y}, {1.5 * u, kGridOnFloor, 0.0});
    TextStyle right = style;
    right.align = Align::kRight;
    plan.canvas.text({plot.x - 12.0 * u, y}, label, right);
  });
  plan.canvas.text({plot.x - 22.0 * u, plot.bottom() + 20.0 * u}, "m", style);
}

[[nodiscard]] std::vector<Vec2> ideal_px(const Plan& plan) {
  std::vector<Vec2> line = plan.pixels(plan.view.ideal_m);
  if (plan.view.ideal_closed && !line.empty()) {
    line.push_back(line.front());
  }
  return line;
}

/// Stretches of one colour, so that a hundred thousand points cost a few hundred strokes and no seam shows.
void paint_driven(const Plan& plan) {
  const std::vector<TimedPoint> path = thinned(plan.view.driven, 0.5 / plan.px_per_m);
  const RunColors colors(plan.view);
  std::vector<Vec2> line;
  line.reserve(path.size());
  for (const TimedPoint& point : path) {
    line.push_back(plan.X.pixel(point.p_m));
  }
  plan.canvas.line(line, {kCasing * plan.u, palette::kInk, 0.0});
  for (std::size_t i = 0; i + 1 < line.size();) {
    const Rgba color = colors.at(path[i + 1].t_s);
    std::size_t end = i + 1;
    while (end + 1 < line.size() && colors.at(path[end + 1].t_s) == color) {
      ++end;
    }
    plan.canvas.line(std::span(line).subspan(i, end - i + 1), {kRibbon * plan.u, color, 0.0});
    i = end;
  }
}

/// Rings of earlier estimates, thinned to those that tell something new, below the last one of each tag.
void paint_estimates(const Plan& plan) {
  std::map<std::string, const TagEstimateView*> last;
  for (const TagEstimateView& estimate : plan.view.estimates) {
    last[estimate.name] = &estimate;
  }
  std::map<std::string, double> ring_m;
  const double widest_m = 0.16 * std::min(plan.plot.width, plan.plot.height) / plan.px_per_m;
  const double thinnest_m = 14.0 * plan.u / plan.px_per_m;
  for (const TagEstimateView& estimate : plan.view.estimates) {
    const Ellipse ellipse = ellipse_of(estimate.covariance_m2);
    const auto [drawn, first] = ring_m.try_emplace(estimate.name, 1e9);
    // Chosen: a third smaller than the last ring can be told from it without a thicket.
    if (&estimate != last[estimate.name] && ellipse.major_m < widest_m && ellipse.major_m > thinnest_m &&
        ellipse.major_m < 0.67 * drawn->second) {
      drawn->second = ellipse.major_m;
      plan.canvas.line(plan.pixels(ellipse_outline(estimate.at_m, ellipse)),
                       {1.4 * plan.u, palette::kCeilingTag.with_alpha(100), 0.0});
    }
  }
  for (const auto& [name, estimate] : last) {
    const std::vector<Vec2> rim =
        plan.pixels(ellipse_outline(estimate->at_m, ellipse_of(estimate->covariance_m2)));
    plan.canvas.fill(rim, palette::kCeilingTag.with_alpha(38));
    plan.canvas.line(rim, {2.4 * plan.u, palette::kCeilingTag, 0.0});
  }
}

void paint_marks(const Plan& plan) {
  for (const PhaseTagView& tag : plan.view.tags) {
    paint_diamond(plan.canvas, plan.X.pixel(tag.at_m), plan.u, tag.missing);
  }
  std::map<std::string, const TagEstimateView*> last;
  for (const TagEstimateView& estimate : plan.view.estimates) {
    last[estimate.name] = &estimate;
  }
  for (const auto& [name, estimate] : last) {
    paint_cross(plan.canvas, plan.X.pixel(estimate->at_m), 0.6 * plan.u);
  }
  if (plan.view.start) {
    paint_start(plan.canvas, plan.X.pixel(plan.view.start->p_m), heading_px(*plan.view.start),
                start_ring_px(plan), plan.u);
  }
  if (plan.view.end) {
    paint_robot(plan.canvas, plan.X.pixel(plan.view.end->p_m), robot_radius_px(plan),
                heading_px(*plan.view.end), plan.u);
  }
}

/// How far a tag's name must stay from it: off its mark, and off the robot where that covers the mark.
[[nodiscard]] double name_distance_px(const Plan& plan, const Vec2& at_px) {
  double distance = kTagMark * plan.u;
  const auto covered = [&](const Pose2& X, double r) {
    if ((plan.X.pixel(X.p_m) - at_px).norm() < r) {
      distance = std::max(distance, r + 2.0 * plan.u);
    }
  };
  if (plan.view.start) {
    covered(*plan.view.start, start_ring_px(plan));
  }
  if (plan.view.end) {
    covered(*plan.view.end, robot_radius_px(plan));
  }
  return distance + 5.0 * plan.u;
}

/// Everything that names must not cover, and what they should rather not.
[[nodiscard]] LabelPlacer placer_of(const Plan& plan) {
  LabelPlacer placer(plan.plot);
  const double u = plan.u;
  const auto clear = [&](const Vec2& c, double r) {
    placer.keep_clear({c.x() - r, c.y() - r, 2 * r, 2 * r});
  };
  for (const PhaseTagView& tag : plan.view.tags) {
    clear(plan.X.pixel(tag.at_m), kTagMark * u);
  }
  if (plan.view.start) {
    const Vec2 at = plan.X.pixel(plan.view.start->p_m);
    const double ring = start_ring_px(plan);
    clear(at, ring + 3.0 * u);
    clear(at + (ring + 16.0 * u) * heading_px(*plan.view.start), 10.0 * u);
  }
  if (plan.view.end) {
    clear(plan.X.pixel(plan.view.end->p_m), robot_radius_px(plan));
  }
  placer.avoid(ideal_px(plan));
  std::vector<Vec2> driven;
  for (const TimedPoint& point : thinned(plan.view.driven, 4.0 * u / plan.px_per_m)) {
    driven.push_back(plan.X.pixel(point.p_m));
  }
  placer.avoid(driven);
  for (const WallView& wall : plan.view.walls) {
    placer.avoid(wall_px(plan, wall));
  }
  for (const FurnitureView& piece : plan.view.furniture) {
    placer.avoid(plan.pixels(footprint(piece)));
  }
  for (const PersonView& person : plan.view.people) {
    placer.avoid(plan.pixels(person.path_m));
  }
  return placer;
}

[[nodiscard]] TextStyle name_style(const Plan& plan) {
  // Many names are written smaller.
  const double size = (plan.view.tags.size() > 24 ? 18.0 : 22.0) * plan.u;
  return {size, palette::kCeilingTag, true, Align::kLeft, 0.0, palette::kPaper.with_alpha(235)};
}

/// Where the name of each tag stands; a leader, below all marks, where it had to step far away.
[[nodiscard]] std::vector<LabelPlacer::Place> placed_names(const Plan& plan) {
  LabelPlacer placer = placer_of(plan);
  const TextStyle style = name_style(plan);
  std::vector<LabelPlacer::Place> places;
  for (const PhaseTagView& tag : plan.view.tags) {
    const Vec2 at = plan.X.pixel(tag.at_m);
    const Vec2 size{plan.canvas.width_of(tag.name, style), 0.9 * style.size_px};
    places.push_back(tag.name.empty() ? LabelPlacer::Place{}
                                      : placer.place(at, name_distance_px(plan, at), size));
    if (places.back().far) {
      plan.canvas.line(at, leader_end(places.back(), at),
                       {1.5 * plan.u, palette::kCeilingTag.with_alpha(150), 0.0});
    }
  }
  return places;
}

void paint_names(const Plan& plan, const std::vector<LabelPlacer::Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    plan.canvas.text({places[i].box.x, places[i].box.center().y()}, plan.view.tags[i].name, name_style(plan));
  }
}

}  // namespace

namespace phase {

Projection paint_plan(Canvas& canvas, const PhaseRunView& view, const RectPx& plot, double u) {
  const Extent extent = extent_of(view);
  // Room for marks and names at the rim.
  const double border = 44.0 * u;
  const double px_per_m = std::min((plot.width - 2.0 * border) / extent.size_m().x(),
                                   (plot.height - 2.0 * border) / extent.size_m().y());
  Plan plan{canvas, view, plot, u, Projection::top(extent.center_m(), plot.center(), px_per_m), px_per_m};
  canvas.clip(plot);
  paint_floor(plan);
  canvas.unclip();
  paint_axes(plan);
  canvas.clip(plot);
  paint_walls(plan);
  paint_furniture(plan);
  paint_people(plan);
  paint_estimates(plan);
  paint_driven(plan);
  canvas.line(ideal_px(plan), {2.2 * u, palette::kInk, 11.0 * u});
  const std::vector<LabelPlacer::Place> places = placed_names(plan);
  paint_marks(plan);
  paint_names(plan, places);
  canvas.unclip();
  return plan.X;
}

}  // namespace phase
}  // namespace sensotwin::render
