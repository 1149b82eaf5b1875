// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "render/canvas.hpp"
#include "render/charts.hpp"
#include "render/ticks.hpp"

/// What all charts share: frame, axes and the map from data to pixels.
namespace sensotwin::render {

/// Units of length are pixels of a chart 1600 wide, as in picture_layout.hpp.
[[nodiscard]] double chart_unit_px(const ChartFrame& frame);
/// The plot, with `right_units` left free beside it for labels or a scale.
[[nodiscard]] RectPx chart_plot(const ChartFrame& frame, double right_units);
void draw_chart_heading(Canvas& canvas, const ChartFrame& frame);
/// Names of the axes: x below the plot, y above its left end, where it reads without turning one's head.
void draw_axis_labels(Canvas& canvas, const ChartFrame& frame, const RectPx& plot);
/// Grid, ticks and axes for ranges that are set.
void draw_axes(Canvas& canvas, const ChartFrame& frame, const RectPx& plot, const Axis& x, const Axis& y);
void draw_reference_lines(Canvas& canvas, const ChartFrame& frame, const Chart& chart,
                          std::span<const ReferenceLine> lines);

/// The range with air above and below, from 0 when the data begin near it. An empty range is widened.
[[nodiscard]] ChartRange padded(ChartRange range, bool log);
/// 0 to 1 along the axis. \pre axis.range
[[nodiscard]] double share_along(const Axis& axis, double value);

[[nodiscard]] std::optional<RenderError> frame_fault(const ChartFrame& frame);
/// `what` names the thing in the message: "series ours".
[[nodiscard]] std::optional<RenderError> value_fault(double value, bool log, std::string_view what);

/// A chart onto pixels or into an SVG: `paint(canvas)` returns the chart without its image.
template <class Paint>
[[nodiscard]] Rendered<Chart> painted_image(const ChartFrame& frame, const Paint& paint) {
  Canvas canvas = Canvas::pixels(frame.width_px, frame.height_px);
  Chart chart = paint(canvas);
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  chart.image = std::move(*image);
  return chart;
}
template <class Paint>
[[nodiscard]] Rendered<std::string> painted_svg(const ChartFrame& frame, const Paint& paint) {
  Canvas canvas = Canvas::svg(frame.width_px, frame.height_px);
  (void)paint(canvas);
  return canvas.take_svg();
}

}  // namespace sensotwin::render
