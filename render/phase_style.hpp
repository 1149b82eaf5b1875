// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas.hpp"
#include "render/charts.hpp"
#include "render/phase_views.hpp"

/// What the pictures of phase navigation share: panels of charts, a legend that flows, colours.
namespace sensotwin::render {

/// One chart among several on a sheet.
struct Panel {
  RectPx plot;
  Axis x;  ///< with range
  Axis y;  ///< with range
  double unit_px{1.0};
  [[nodiscard]] Vec2 pixel(const ChartPoint& p) const;
};
/// Grid, ticks, axes; the name of y above its left end, bold; that of x below, if `name_x`.
void draw_panel(Canvas& canvas, const Panel& panel, bool name_x = true);
/// A title in the sheets' style, with its second line.
void draw_sheet_heading(Canvas& canvas, int width_px, double unit_px, const std::string& title,
                        const std::string& second);

/// A line of a legend that draws its own sample about a point, 36 units wide.
struct FlowItem {
  std::string text;
  std::function<void(Canvas&, const Vec2& middle, double unit_px)> swatch;
};
/// Samples and texts in rows from the top left, wrapped at the right. \returns the height used
double draw_flow_legend(Canvas& canvas, const RectPx& into, double unit_px,
                        const std::vector<FlowItem>& items);
/// The same without drawing.
[[nodiscard]] double flow_height(const Canvas& canvas, double width_px, double unit_px,
                                 const std::vector<FlowItem>& items);

/// Colours for segments, sets and curves in turn: six of Okabe and Ito's, neighbours far apart in lightness
/// or hue for every kind of colour vision.
[[nodiscard]] Rgba turn_color(std::size_t index);
/// What a moment of the run is drawn in: soft grey outside the part that counts.
class RunColors {
 public:
  explicit RunColors(const PhaseRunView& view);
  [[nodiscard]] Rgba at(double t_s) const;

 private:
  PathColoring coloring_;
  std::vector<SegmentView> segments_;
  ChartRange span_s_;
};

}  // namespace sensotwin::render
