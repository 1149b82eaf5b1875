// SPDX-License-Identifier: MIT
#include "render/plan_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/phase_pictures.hpp"
#include "render/plane_geometry.hpp"

namespace sensotwin::render {
namespace {

[[nodiscard]] std::array<Vec2, 4> diamond(const Vec2& c, double r) {
  return {Vec2{c.x() + r, c.y()}, Vec2{c.x(), c.y() + r}, Vec2{c.x() - r, c.y()}, Vec2{c.x(), c.y() - r}};
}

/// What stands about, and who walks.
void add_scenery(std::vector<FlowItem>& items, const PhaseRunView& view) {
  if (!view.walls.empty()) {
    items.push_back(
        {"wall", [](Canvas& canvas, const Vec2& c, double u) {
           canvas.line(c - Vec2{18.0, 0.0} * u, c + Vec2{18.0, 0.0} * u, {5.0 * u, palette::kWall, 0.0});
         }});
  }
  if (!view.furniture.empty()) {
    items.push_back({"furniture", [](Canvas& canvas, const Vec2& c, double u) {
                       const RectPx box{c.x() - 14.0 * u, c.y() - 10.0 * u, 28.0 * u, 20.0 * u};
                       canvas.fill(box, palette::kFurniture);
                       canvas.outline(box, {2.0 * u, palette::kFurnitureEdge, 0.0});
                     }});
  }
  if (!view.people.empty()) {
    items.push_back(
        {"person, and their way", [](Canvas& canvas, const Vec2& c, double u) {
           canvas.line(c - Vec2{10.0, 0.0} * u, c + Vec2{22.0, 0.0} * u, {2.6 * u, palette::kGreen, 7.0 * u});
           paint_person(canvas, c - Vec2{10.0, 0.0} * u, 8.0 * u, u);
         }});
  }
}

}  // namespace

void paint_diamond(Canvas& canvas, const Vec2& c, double u, bool missing) {
  canvas.fill(diamond(c, (kTagMark + 3.0) * u), palette::kPaper);
  canvas.fill(diamond(c, kTagMark * u), palette::kCeilingTag);
  if (missing) {
    canvas.fill(diamond(c, 0.55 * kTagMark * u), palette::kPaper);
  }
}

void paint_start(Canvas& canvas, const Vec2& c, const Vec2& heading_px, double ring_px, double u) {
  const Vec2 tip = c + (ring_px + 24.5 * u) * heading_px;
  const Vec2 aside{-heading_px.y(), heading_px.x()};
  const Vec2 neck = tip - 13.0 * u * heading_px;
  for (const auto& [grow, color] : {std::pair{3.0, palette::kPaper}, std::pair{0.0, palette::kBlue}}) {
    canvas.line(c, neck, {(3.5 + 2.0 * grow) * u, color, 0.0});
    const double wide = 7.5 * u + grow * u;
    canvas.fill(std::array{Vec2(tip + 1.6 * grow * u * heading_px), Vec2(neck + wide * aside),
                           Vec2(neck - grow * u * heading_px), Vec2(neck - wide * aside)},
                color);
  }
  canvas.disc(c, ring_px + 3.5 * u, palette::kPaper);
  canvas.ring(c, ring_px, {3.5 * u, palette::kBlue, 0.0});
  canvas.disc(c, 4.0 * u, palette::kBlue);
}

void paint_robot(Canvas& canvas, const Vec2& c, double radius_px, const Vec2& heading_px, double u) {
  const double r = radius_px;
  const Vec2 aside{-heading_px.y(), heading_px.x()};
  canvas.disc(c, r + 2.5 * u, palette::kPaper);
  canvas.disc(c, r, palette::kRobot);
  canvas.fill(std::array{Vec2(c + 0.72 * r * heading_px), Vec2(c - 0.36 * r * heading_px + 0.48 * r * aside),
                         Vec2(c - 0.14 * r * heading_px), Vec2(c - 0.36 * r * heading_px - 0.48 * r * aside)},
              palette::kOrange);
}

void paint_person(Canvas& canvas, const Vec2& c, double radius_px, double u) {
  canvas.disc(c, radius_px + 2.5 * u, palette::kPaper);
  canvas.disc(c, radius_px, palette::kGreen);
}

void paint_cross(Canvas& canvas, const Vec2& c, double u) {
  for (const auto& [width, color] : {std::pair{6.0, palette::kPaper}, std::pair{2.6, palette::kInk}}) {
    canvas.line(c + Vec2{-8.0, -8.0} * u, c + Vec2{8.0, 8.0} * u, {width * u, color, 0.0});
    canvas.line(c + Vec2{-8.0, 8.0} * u, c + Vec2{8.0, -8.0} * u, {width * u, color, 0.0});
  }
}

namespace phase {

std::vector<FlowItem> plan_legend(const PhaseRunView& view) {
  std::vector<FlowItem> items;
  const ChartRange span = counted_span_s(view);
  const Vec2 half{18.0, 0.0};
  if (!view.ideal_m.empty()) {
    items.push_back({"ideal path", [half](Canvas& canvas, const Vec2& c, double u) {
                       canvas.line(c - half * u, c + half * u, {2.4 * u, palette::kInk, 8.0 * u});
                     }});
  }
  if (!view.driven.empty()) {
    const bool by_time = view.coloring == PathColoring::kTime;
    const std::string text = by_time ? fmt::format("driven, {:.0f} to {:.0f} s", span.low, span.high)
                                     : std::string("driven, a colour a segment");
    items.push_back({text, [half, by_time](Canvas& canvas, const Vec2& c, double u) {
                       canvas.line(c - half * u, c + half * u, {10.0 * u, palette::kInk, 0.0});
                       const int n = by_time ? 18 : 3;
                       for (int i = 0; i < n; ++i) {
                         const Vec2 step = 2.0 * half * u / n;
                         canvas.line(
                             c - half * u + i * step, c - half * u + (i + 1) * step,
                             {7.0 * u,
                              by_time ? time_color((i + 0.5) / n) : turn_color(static_cast<std::size_t>(i)),
                              0.0});
                       }
                     }});
  }
  if (!view.driven.empty() && span.low > view.driven.front().t_s) {
    items.push_back({"approach, not counted", [half](Canvas& canvas, const Vec2& c, double u) {
                       canvas.line(c - half * u, c + half * u, {10.0 * u, palette::kInk, 0.0});
                       canvas.line(c - half * u, c + half * u, {7.0 * u, palette::kHairline, 0.0});
                     }});
  }
  const auto missing = [](const PhaseTagView& tag) { return tag.missing; };
  if (!std::all_of(view.tags.begin(), view.tags.end(), missing)) {
    items.push_back(
        {view.tags_are, [](Canvas& canvas, const Vec2& c, double u) { paint_diamond(canvas, c, u, false); }});
  }
  if (std::any_of(view.tags.begin(), view.tags.end(), missing)) {
    items.push_back(
        {"missing tag", [](Canvas& canvas, const Vec2& c, double u) { paint_diamond(canvas, c, u, true); }});
  }
  if (!view.estimates.empty()) {
    items.push_back({"estimate, 95 %", [](Canvas& canvas, const Vec2& c, double u) {
                       std::vector<Vec2> rim = ellipse_outline(c, {17.0 * u, 11.0 * u, 0.0});
                       canvas.fill(rim, palette::kCeilingTag.with_alpha(38));
                       canvas.line(rim, {2.4 * u, palette::kCeilingTag, 0.0});
                       paint_cross(canvas, c, 0.7 * u);
                     }});
  }
  add_scenery(items, view);
  if (view.start) {
    items.push_back({"start", [](Canvas& canvas, const Vec2& c, double u) {
                       paint_start(canvas, c - Vec2{9.0, 0.0} * u, {1.0, 0.0}, 7.6 * u, 0.8 * u);
                     }});
  }
  if (view.end) {
    items.push_back({"end", [](Canvas& canvas, const Vec2& c, double u) {
                       paint_robot(canvas, c, 13.0 * u, {1.0, 0.0}, u);
                     }});
  }
  return items;
}

}  // namespace phase
}  // namespace sensotwin::render
