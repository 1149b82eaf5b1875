// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/chart_style.hpp"
#include "render/charts.hpp"

namespace sensotwin::render {
namespace {

constexpr double kScaleUnits = 230.0;

[[nodiscard]] std::optional<RenderError> fault_of(const HeatmapChart& chart) {
  if (auto fault = frame_fault(chart.frame)) {
    return fault;
  }
  if (chart.columns.empty() || chart.rows.empty() ||
      chart.values.size() != chart.columns.size() * chart.rows.size()) {
    return RenderError{RenderError::Kind::kBadView,
                       fmt::format("a heat map of {} rows and {} columns cannot hold {} values",
                                   chart.rows.size(), chart.columns.size(), chart.values.size())};
  }
  for (const double value : chart.values) {
    if (auto fault = value_fault(value, false, "heat map")) {
      return fault;
    }
  }
  if (chart.range && !(chart.range->high > chart.range->low)) {
    return RenderError{RenderError::Kind::kBadView,
                       "the colours of a heat map need a range that is not empty"};
  }
  return std::nullopt;
}

[[nodiscard]] ChartRange color_range(const HeatmapChart& chart) {
  if (chart.range) {
    return *chart.range;
  }
  const auto [low, high] = std::minmax_element(chart.values.begin(), chart.values.end());
  return *high > *low ? ChartRange{*low, *high} : ChartRange{*low - 0.5, *high + 0.5};
}

void draw_cells(Canvas& canvas, const HeatmapChart& chart, const RectPx& plot, const ChartRange& range,
                double u) {
  const double width = plot.width / static_cast<double>(chart.columns.size());
  const double height = plot.height / static_cast<double>(chart.rows.size());
  const double gap = std::min(2.0 * u, 0.1 * std::min(width, height));
  for (std::size_t i = 0; i < chart.values.size(); ++i) {
    const std::size_t rows_below = i / chart.columns.size();
    const auto row = static_cast<double>(rows_below);
    const auto column = static_cast<double>(i % chart.columns.size());
    const RectPx cell{plot.x + column * width + gap / 2.0, plot.bottom() - (row + 1.0) * height + gap / 2.0,
                      width - gap, height - gap};
    const Rgba color = quantity_color((chart.values[i] - range.low) / (range.high - range.low));
    canvas.fill(cell, color);
    const std::string text = fmt::format("{:.{}f}", chart.values[i], chart.decimals);
    const TextStyle wanted{std::min(22.0 * u, 0.6 * height),
                           luminance(color) > 0.25 ? palette::kInk : palette::kPaper, false, Align::kCenter};
    const TextStyle style = canvas.fitted(text, wanted, 0.86 * width, 0.5);
    if (canvas.width_of(text, style) <= 0.95 * width && style.size_px >= 8.0 * u) {
      canvas.text(cell.center(), text, style);
    }
  }
}

void draw_names(Canvas& canvas, const HeatmapChart& chart, const RectPx& plot, double u) {
  const double width = plot.width / static_cast<double>(chart.columns.size());
  const double height = plot.height / static_cast<double>(chart.rows.size());
  for (std::size_t i = 0; i < chart.columns.size(); ++i) {
    TextStyle style{22.0 * u, palette::kSoftInk, false, Align::kCenter};
    style = canvas.fitted(chart.columns[i], style, 0.95 * width, 0.5);
    canvas.text({plot.x + (static_cast<double>(i) + 0.5) * width, plot.bottom() + 30.0 * u}, chart.columns[i],
                style);
  }
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    const TextStyle style{std::min(22.0 * u, 0.9 * height), palette::kSoftInk, false, Align::kRight};
    canvas.text({plot.x - 14.0 * u, plot.bottom() - (static_cast<double>(i) + 0.5) * height}, chart.rows[i],
                canvas.fitted(chart.rows[i], style, plot.x - 20.0 * u, 0.5));
  }
}

void draw_color_scale(Canvas& canvas, const HeatmapChart& chart, const RectPx& plot, const ChartRange& range,
                      double u) {
  const RectPx bar{plot.right() + 48.0 * u, plot.y, 30.0 * u, plot.height};
  constexpr int kSteps = 128;
  for (int i = 0; i < kSteps; ++i) {
    const double top = bar.y + bar.height * i / kSteps;
    // One pixel of overlap, so that no seam shows between neighbours.
    canvas.fill(RectPx{bar.x, top, bar.width, std::min(bar.height / kSteps + 1.0, bar.bottom() - top)},
                quantity_color(1.0 - (i + 0.5) / kSteps));
  }
  for (const Tick& tick : linear_ticks(range.low, range.high, 6)) {
    const double y = bar.bottom() - (tick.value - range.low) / (range.high - range.low) * bar.height;
    canvas.line({bar.right(), y}, {bar.right() + 8.0 * u, y}, {1.5 * u, palette::kSoftInk, 0.0});
    canvas.text({bar.right() + 16.0 * u, y}, tick.label, {22.0 * u, palette::kSoftInk});
  }
  TextStyle label{24.0 * u, palette::kInk, true, Align::kRight};
  const Vec2 anchor{chart.frame.width_px - 48.0 * u, plot.y - 28.0 * u};
  canvas.text(anchor, chart.value_label, canvas.fitted(chart.value_label, label, 0.6 * plot.width));
}

[[nodiscard]] Chart paint(Canvas& canvas, const HeatmapChart& chart) {
  const double u = chart_unit_px(chart.frame);
  Chart placed;
  placed.plot = chart_plot(chart.frame, kScaleUnits);
  // Data space: cell (column, row) covers [column, column + 1] x [row, row + 1].
  placed.x = {chart.frame.x.label, false, ChartRange{0.0, static_cast<double>(chart.columns.size())}};
  placed.y = {chart.frame.y.label, false, ChartRange{0.0, static_cast<double>(chart.rows.size())}};
  const ChartRange range = color_range(chart);
  draw_chart_heading(canvas, chart.frame);
  draw_axis_labels(canvas, chart.frame, placed.plot);
  draw_cells(canvas, chart, placed.plot, range, u);
  draw_names(canvas, chart, placed.plot, u);
  draw_color_scale(canvas, chart, placed.plot, range, u);
  return placed;
}

}  // namespace

Rendered<Chart> draw(const HeatmapChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_image(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

Rendered<std::string> draw_svg(const HeatmapChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_svg(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

}  // namespace sensotwin::render
