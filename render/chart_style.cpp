// SPDX-License-Identifier: MIT
#include "render/chart_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sensotwin::render {
namespace {

// Units, chosen by looking at the charts at 1000 pixels width.
constexpr double kLeft = 112.0;
constexpr double kTop = 168.0;
constexpr double kBottom = 112.0;
constexpr double kTickSize = 22.0;
constexpr double kLabelSize = 24.0;

[[nodiscard]] std::vector<Tick> ticks_of(const Axis& axis, double length_px, double every_px) {
  return axis.log ? log_ticks(axis.range->low, axis.range->high)
                  : linear_ticks(axis.range->low, axis.range->high,
                                 std::max(2, static_cast<int>(length_px / every_px)));
}

}  // namespace

double chart_unit_px(const ChartFrame& frame) {
  return std::min(frame.width_px / 1600.0, frame.height_px / 700.0);
}

RectPx chart_plot(const ChartFrame& frame, double right_units) {
  const double u = chart_unit_px(frame);
  return {kLeft * u, kTop * u, frame.width_px - (kLeft + right_units) * u,
          frame.height_px - (kTop + kBottom) * u};
}

void draw_chart_heading(Canvas& canvas, const ChartFrame& frame) {
  const double u = chart_unit_px(frame);
  const double width = frame.width_px - 96.0 * u;
  const TextStyle title = canvas.fitted(frame.title, {38.0 * u, palette::kInk, true}, width);
  canvas.text({48.0 * u, 50.0 * u}, canvas.cut(frame.title, title, width), title);
  const TextStyle small = canvas.fitted(frame.subtitle, {24.0 * u, palette::kSoftInk}, width, 0.8);
  canvas.text({48.0 * u, 94.0 * u}, canvas.cut(frame.subtitle, small, width), small);
}

void draw_axis_labels(Canvas& canvas, const ChartFrame& frame, const RectPx& plot) {
  const double u = chart_unit_px(frame);
  canvas.text({48.0 * u, plot.y - 28.0 * u}, frame.y.label, {kLabelSize * u, palette::kInk, true});
  canvas.text({plot.center().x(), plot.bottom() + 80.0 * u}, frame.x.label,
              {kLabelSize * u, palette::kInk, true, Align::kCenter});
}

void draw_axes(Canvas& canvas, const ChartFrame& frame, const RectPx& plot, const Axis& x, const Axis& y) {
  const double u = chart_unit_px(frame);
  const TextStyle style{kTickSize * u, palette::kSoftInk};
  for (const Tick& tick : ticks_of(y, plot.height, 95.0 * u)) {
    const double at = plot.bottom() - share_along(y, tick.value) * plot.height;
    canvas.line({plot.x, at}, {plot.right(), at}, {1.5 * u, palette::kGrid, 0.0});
    TextStyle right = style;
    right.align = Align::kRight;
    canvas.text({plot.x - 14.0 * u, at}, tick.label, right);
  }
  for (const Tick& tick : ticks_of(x, plot.width, 130.0 * u)) {
    const double at = plot.x + share_along(x, tick.value) * plot.width;
    canvas.line({at, plot.bottom()}, {at, plot.bottom() + 9.0 * u}, {1.5 * u, palette::kSoftInk, 0.0});
    TextStyle middle = style;
    middle.align = Align::kCenter;
    canvas.text({at, plot.bottom() + 30.0 * u}, tick.label, middle);
  }
  canvas.line({plot.x, plot.bottom()}, {plot.right(), plot.bottom()}, {2.0 * u, palette::kSoftInk, 0.0});
}

void draw_reference_lines(Canvas& canvas, const ChartFrame& frame, const Chart& chart,
                          std::span<const ReferenceLine> lines) {
  const double u = chart_unit_px(frame);
  for (const ReferenceLine& line : lines) {
    const double share = share_along(line.vertical ? chart.x : chart.y, line.value);
    if (!(share >= 0.0 && share <= 1.0)) {
      continue;
    }
    const RectPx& plot = chart.plot;
    TextStyle style{20.0 * u, line.color, false, Align::kLeft, 0.0, palette::kPaper.with_alpha(230)};
    if (line.vertical) {
      const double x = plot.x + share * plot.width;
      canvas.line({x, plot.bottom()}, {x, plot.y}, {2.0 * u, line.color, 8.0 * u});
      // On the side where there is more room.
      style.align = share > 0.7 ? Align::kRight : Align::kLeft;
      canvas.text({x + (share > 0.7 ? -10.0 : 10.0) * u, plot.y + 16.0 * u}, line.label, style);
    } else {
      const double y = plot.bottom() - share * plot.height;
      canvas.line({plot.x, y}, {plot.right(), y}, {2.0 * u, line.color, 8.0 * u});
      canvas.text({plot.x + 12.0 * u, y - 18.0 * u}, line.label, style);
    }
  }
}

ChartRange padded(ChartRange range, bool log) {
  if (log) {
    // A twentieth of the axis on either side; an octave about a single value.
    const double factor = range.high > range.low ? std::pow(range.high / range.low, 0.05) : 2.0;
    return {range.low / factor, range.high * factor};
  }
  const double span = range.high - range.low;
  if (!(span > 0.0)) {
    const double half = range.low == 0.0 ? 1.0 : std::abs(range.low) * 0.1;
    return {range.low == 0.0 ? 0.0 : range.low - half, range.high + half};
  }
  const bool from_zero = range.low >= 0.0 && range.low < 0.5 * range.high;
  return {from_zero ? 0.0 : range.low - 0.05 * span, range.high + 0.06 * span};
}

double share_along(const Axis& axis, double value) {
  const ChartRange& r = *axis.range;
  return axis.log ? std::log(value / r.low) / std::log(r.high / r.low) : (value - r.low) / (r.high - r.low);
}

std::optional<RenderError> value_fault(double value, bool log, std::string_view what) {
  if (!std::isfinite(value)) {
    return RenderError{RenderError::Kind::kBadView,
                       fmt::format("cannot draw {}: {} is not finite", what, value)};
  }
  if (log && value <= 0.0) {
    return RenderError{RenderError::Kind::kBadView,
                       fmt::format("cannot draw {}: {} has no place on a logarithmic axis", what, value)};
  }
  return std::nullopt;
}

std::optional<RenderError> frame_fault(const ChartFrame& frame) {
  if (auto fault = size_fault(frame.width_px, frame.height_px)) {
    return fault;
  }
  if (frame.height_px == 0) {
    return RenderError{RenderError::Kind::kBadView, "a chart needs a height"};
  }
  for (const Axis* axis : {&frame.x, &frame.y}) {
    if (!axis->range) {
      continue;
    }
    for (const double end : {axis->range->low, axis->range->high}) {
      if (auto fault = value_fault(end, axis->log, "axis " + axis->label)) {
        return fault;
      }
    }
    if (!(axis->range->high > axis->range->low)) {
      return RenderError{RenderError::Kind::kBadView, "axis " + axis->label + " has an empty range"};
    }
  }
  return std::nullopt;
}

Vec2 Chart::pixel(const ChartPoint& p) const {
  return {plot.x + share_along(x, p.x) * plot.width, plot.bottom() - share_along(y, p.y) * plot.height};
}

}  // namespace sensotwin::render
