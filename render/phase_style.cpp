// SPDX-License-Identifier: MIT
#include "render/phase_style.hpp"

#include <algorithm>
#include <array>

#include "render/chart_style.hpp"

namespace sensotwin::render {
namespace {

// Units, chosen by looking at the pictures at 1000 pixels width.
constexpr double kFlowText = 22.0;
constexpr double kFlowLine = 38.0;
constexpr double kFlowSwatch = 36.0;
constexpr double kFlowGap = 34.0;

/// Calls `put(item, left, top)` for each item where it flows to. \returns the height used
template <class Put>
double flow(const Canvas& canvas, double width_px, double u, const std::vector<FlowItem>& items,
            const Put& put) {
  const TextStyle style{kFlowText * u, palette::kInk};
  double x = 0.0;
  double y = 0.0;
  for (const FlowItem& item : items) {
    const double width = (kFlowSwatch + 12.0) * u + canvas.width_of(item.text, style);
    if (x > 0.0 && x + width > width_px) {
      x = 0.0;
      y += kFlowLine * u;
    }
    put(item, x, y);
    x += width + kFlowGap * u;
  }
  return items.empty() ? 0.0 : y + kFlowLine * u;
}

}  // namespace

Vec2 Panel::pixel(const ChartPoint& p) const {
  return {plot.x + share_along(x, p.x) * plot.width, plot.bottom() - share_along(y, p.y) * plot.height};
}

void draw_panel(Canvas& canvas, const Panel& panel, bool name_x) {
  const double u = panel.unit_px;
  ChartFrame frame;
  frame.width_px = static_cast<int>(1600.0 * u);
  frame.height_px = frame.width_px;
  draw_axes(canvas, frame, panel.plot, panel.x, panel.y);
  const TextStyle name{24.0 * u, palette::kInk, true};
  // Above the numbers of the axis, which take about 70 units.
  canvas.text({panel.plot.x - 64.0 * u, panel.plot.y - 28.0 * u}, panel.y.label, name);
  if (name_x) {
    TextStyle below = name;
    below.align = Align::kCenter;
    canvas.text({panel.plot.center().x(), panel.plot.bottom() + 70.0 * u}, panel.x.label, below);
  }
}

void draw_sheet_heading(Canvas& canvas, int width_px, double u, const std::string& title,
                        const std::string& second) {
  const double width = width_px - 96.0 * u;
  const TextStyle large = canvas.fitted(title, {38.0 * u, palette::kInk, true}, width);
  canvas.text({48.0 * u, 50.0 * u}, canvas.cut(title, large, width), large);
  const TextStyle small = canvas.fitted(second, {24.0 * u, palette::kSoftInk}, width, 0.8);
  canvas.text({48.0 * u, 94.0 * u}, canvas.cut(second, small, width), small);
}

double draw_flow_legend(Canvas& canvas, const RectPx& into, double u, const std::vector<FlowItem>& items) {
  return flow(canvas, into.width, u, items, [&](const FlowItem& item, double x, double y) {
    const Vec2 middle{into.x + x + kFlowSwatch * u / 2.0, into.y + y + kFlowLine * u / 2.0};
    item.swatch(canvas, middle, u);
    canvas.text({into.x + x + (kFlowSwatch + 12.0) * u, middle.y()}, item.text,
                {kFlowText * u, palette::kInk});
  });
}

double flow_height(const Canvas& canvas, double width_px, double u, const std::vector<FlowItem>& items) {
  return flow(canvas, width_px, u, items, [](const FlowItem&, double, double) {});
}

Rgba turn_color(std::size_t index) {
  static constexpr std::array kTurns{palette::kBlue, palette::kOrange, palette::kGreen,
                                     palette::kPink, palette::kSky,    palette::kVermilion};
  return kTurns[index % kTurns.size()];
}

RunColors::RunColors(const PhaseRunView& view)
    : coloring_(view.coloring), segments_(view.segments), span_s_(counted_span_s(view)) {}

Rgba RunColors::at(double t_s) const {
  if (t_s < span_s_.low || t_s > span_s_.high) {
    return palette::kHairline;
  }
  if (coloring_ == PathColoring::kTime) {
    return time_color(span_s_.high > span_s_.low ? (t_s - span_s_.low) / (span_s_.high - span_s_.low) : 0.0);
  }
  std::size_t turn = 0;
  std::size_t counted = 0;
  for (const SegmentView& segment : segments_) {
    if (segment.counted && segment.from_s <= t_s) {
      turn = counted;
    }
    counted += segment.counted ? 1 : 0;
  }
  return turn_color(turn);
}

}  // namespace sensotwin::render
