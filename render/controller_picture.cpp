// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "render/chart_style.hpp"
#include "render/phase_charts.hpp"

namespace sensotwin::render {
namespace {

/// Sets of one rule share this. Okabe and Ito: blue, black, vermilion stay apart for every eye.
[[nodiscard]] Rgba rule_color(int rule) {
  static constexpr std::array kColors{palette::kBlue, palette::kSoftInk, palette::kVermilion, palette::kGreen,
                                      palette::kPurple};
  return kColors[static_cast<std::size_t>(std::max(0, rule)) % kColors.size()];
}

[[nodiscard]] Rgba curve_color(std::size_t index) {
  static constexpr std::array kColors{palette::kInk, palette::kOrange, palette::kSky, palette::kPink};
  return kColors[index % kColors.size()];
}

[[nodiscard]] ChartRange range_of(const std::vector<FuzzySetView>& sets) {
  double low = 1e300;
  double high = -1e300;
  for (const FuzzySetView& set : sets) {
    for (const ChartPoint& corner : set.corners) {
      low = std::min(low, corner.x);
      high = std::max(high, corner.x);
    }
  }
  return high > low ? ChartRange{low, high}
                    : padded(high < low ? ChartRange{0.0, 1.0} : ChartRange{low, high}, false);
}

/// The middle of a set's top: where its name stands.
[[nodiscard]] ChartPoint top_of(const FuzzySetView& set) {
  double most = -1e300;
  for (const ChartPoint& corner : set.corners) {
    most = std::max(most, corner.y);
  }
  double first = 0.0;
  double last = 0.0;
  bool any = false;
  for (const ChartPoint& corner : set.corners) {
    if (corner.y >= most) {
      first = any ? first : corner.x;
      last = corner.x;
      any = true;
    }
  }
  return {0.5 * (first + last), most};
}

/// Each in the middle over its set's top; beside another name when two tops are one.
void paint_set_names(Canvas& canvas, const std::vector<FuzzySetView>& sets, const Panel& panel) {
  const double u = panel.unit_px;
  std::vector<RectPx> taken;
  for (const FuzzySetView& set : sets) {
    if (set.corners.empty()) {
      continue;
    }
    const TextStyle style{23.0 * u, rule_color(set.rule), true, Align::kCenter};
    const Vec2 at = panel.pixel(top_of(set));
    const double width = canvas.width_of(set.name, style);
    RectPx box{at.x() - width / 2.0, at.y() - 34.0 * u, width, 22.0 * u};
    box.x = std::clamp(box.x, panel.plot.x, std::max(panel.plot.x, panel.plot.right() - width));
    for (const RectPx& other : taken) {
      if (box.overlaps(other)) {
        box.x = other.right() + 12.0 * u;
      }
    }
    taken.push_back(box);
    canvas.text(box.center(), set.name, style);
  }
}

void paint_sets(Canvas& canvas, const std::vector<FuzzySetView>& sets, const Panel& panel) {
  const double u = panel.unit_px;
  draw_panel(canvas, panel);
  for (const FuzzySetView& set : sets) {
    if (set.corners.empty()) {
      continue;
    }
    std::vector<Vec2> line;
    for (const ChartPoint& corner : set.corners) {
      line.push_back(panel.pixel(corner));
    }
    std::vector<Vec2> area = line;
    area.push_back(panel.pixel({set.corners.back().x, 0.0}));
    area.push_back(panel.pixel({set.corners.front().x, 0.0}));
    canvas.fill(area, rule_color(set.rule).with_alpha(34));
    canvas.line(line, {4.0 * u, rule_color(set.rule), 0.0});
  }
  paint_set_names(canvas, sets, panel);
}

void paint_curves(Canvas& canvas, const FuzzyControllerView& view, const Panel& panel) {
  const double u = panel.unit_px;
  draw_panel(canvas, panel);
  const Vec2 origin = panel.pixel({0.0, 0.0});
  if (origin.x() > panel.plot.x && origin.x() < panel.plot.right()) {
    canvas.line({origin.x(), panel.plot.y}, {origin.x(), panel.plot.bottom()},
                {1.6 * u, palette::kSoftInk, 0.0});
  }
  if (origin.y() > panel.plot.y && origin.y() < panel.plot.bottom()) {
    canvas.line({panel.plot.x, origin.y()}, {panel.plot.right(), origin.y()},
                {1.6 * u, palette::kSoftInk, 0.0});
  }
  // The controller shown lies on top.
  for (std::size_t i = view.curves.size(); i-- > 0;) {
    std::vector<Vec2> line;
    for (const ChartPoint& point : view.curves[i].points) {
      line.push_back(panel.pixel(point));
    }
    canvas.line(line, {(i == 0 ? 5.0 : 3.6) * u, curve_color(i), i == 0 ? 0.0 : 13.0 * u});
  }
}

[[nodiscard]] std::vector<FlowItem> legend_of(const FuzzyControllerView& view) {
  std::vector<FlowItem> items;
  for (std::size_t i = 0; i < view.curves.size(); ++i) {
    items.push_back({view.curves[i].name, [i](Canvas& canvas, const Vec2& c, double u) {
                       canvas.line(c - Vec2{18.0, 0.0} * u, c + Vec2{18.0, 0.0} * u,
                                   {(i == 0 ? 5.0 : 3.6) * u, curve_color(i), i == 0 ? 0.0 : 7.0 * u});
                     }});
  }
  return items;
}

/// "if Neg then CCW", one for each rule that has both sets.
[[nodiscard]] std::vector<FlowItem> rules_of(const FuzzyControllerView& view) {
  std::vector<FlowItem> items;
  for (const FuzzySetView& input : view.inputs) {
    const auto output = std::find_if(view.outputs.begin(), view.outputs.end(),
                                     [&](const FuzzySetView& set) { return set.rule == input.rule; });
    if (output != view.outputs.end()) {
      items.push_back(
          {input.name + " → " + output->name, [rule = input.rule](Canvas& canvas, const Vec2& c, double u) {
             const RectPx box{c.x() - 18.0 * u, c.y() - 11.0 * u, 36.0 * u, 22.0 * u};
             canvas.fill(box, rule_color(rule).with_alpha(34));
             canvas.outline(box, {3.0 * u, rule_color(rule), 0.0});
           }});
    }
  }
  return items;
}

[[nodiscard]] ChartRange curve_range(const FuzzyControllerView& view) {
  double low = 0.0;
  double high = 0.0;
  for (const ControlCurveView& curve : view.curves) {
    for (const ChartPoint& point : curve.points) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
  }
  const double air = high > low ? 0.06 * (high - low) : 1.0;
  return {low - air, high + air};
}

}  // namespace

Rendered<PanelPicture> draw_controller(const FuzzyControllerView& view, int width_px) {
  if (auto fault = size_fault(width_px, 0)) {
    return Unexpected{*fault};
  }
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  const double u = width_px / 1600.0;
  Canvas canvas = Canvas::pixels(width_px, static_cast<int>(std::lround(1114.0 * u)));
  draw_sheet_heading(canvas, width_px, u, view.title, view.subtitle);
  const std::vector<FlowItem> rules = rules_of(view);
  draw_flow_legend(canvas, {48.0 * u, 126.0 * u, 800.0 * u, 0.0}, u, rules);
  draw_flow_legend(canvas, {848.0 * u, 126.0 * u, 704.0 * u, 0.0}, u, legend_of(view));
  // The names stand in the quarter above full membership.
  const Axis membership{"membership", false, ChartRange{0.0, 1.25}};
  PanelPicture picture;
  picture.panels = {{{112.0 * u, 250.0 * u, 620.0 * u, 290.0 * u},
                     {view.input_label, false, range_of(view.inputs)},
                     membership,
                     u},
                    {{112.0 * u, 712.0 * u, 620.0 * u, 290.0 * u},
                     {view.output_label, false, range_of(view.outputs)},
                     membership,
                     u},
                    {{912.0 * u, 250.0 * u, 632.0 * u, 752.0 * u},
                     {view.input_label, false, range_of(view.inputs)},
                     {view.output_label, false, curve_range(view)},
                     u}};
  paint_sets(canvas, view.inputs, picture.panels[0]);
  paint_sets(canvas, view.outputs, picture.panels[1]);
  paint_curves(canvas, view, picture.panels[2]);
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

}  // namespace sensotwin::render
