// SPDX-License-Identifier: MIT
#include "render/distribution_chart.hpp"

#include <algorithm>
#include <cmath>

#include "render/chart_style.hpp"

namespace sensotwin::render {
namespace {

// Units of a chart 1600 wide, chosen by looking at the charts.
constexpr double kRightUnits = 64.0;
constexpr double kRowUnits = 40.0;
constexpr double kIntervalUnits = 30.0;
constexpr double kAfterRowsUnits = 26.0;
constexpr double kLimitUnits = 28.0;
constexpr double kTextLeftUnits = 48.0;
/// A limit is part of the axis while it lies within so many spans of the values. Chosen: the values still
/// fill a quarter of the chart.
constexpr double kNearSpans = 3.0;
/// Of whole numbers so many at least: fewer would make a wall of one colour, with ticks between the numbers.
constexpr double kWholeSpanMin = 11.0;

struct Bin {
  double low{0.0};
  double high{0.0};
  int kept{0};
  int beyond{0};
};

struct Bins {
  std::vector<Bin> bins;
  bool whole{false};
};

[[nodiscard]] bool beyond(const DistributionChart& chart, double value) {
  return std::any_of(chart.limits.begin(), chart.limits.end(), [&](const DistributionLimit& limit) {
    return limit.of_each && (limit.upper ? value > limit.value : value < limit.value);
  });
}

[[nodiscard]] double quartile(const std::vector<double>& ascending, double share) {
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

/// Where bars begin, how wide they are and how many.
[[nodiscard]] Bins empty_bins(const std::vector<double>& ascending) {
  const double low = ascending.front();
  const double high = ascending.back();
  const double span = high - low;
  Bins out;
  out.whole = span <= 60.0 && std::all_of(ascending.begin(), ascending.end(),
                                          [](double value) { return value == std::nearbyint(value); });
  double first = low;
  double width = span;
  int count = 1;
  if (out.whole) {
    first = low - 0.5;
    width = 1.0;
    count = static_cast<int>(span) + 1;
  } else if (!(span > 0.0)) {
    width = std::max(std::abs(low) * 0.02, 1e-9);
    first = low - width / 2.0;
  } else {
    const double middle_half = quartile(ascending, 0.75) - quartile(ascending, 0.25);
    const double advised = 2.0 * middle_half / std::cbrt(static_cast<double>(ascending.size()));
    const double bars = advised > 0.0 ? span / advised : 20.0;
    count = static_cast<int>(std::clamp(std::ceil(bars), 8.0, 60.0));
    width = span / count;
  }
  for (int i = 0; i < count; ++i) {
    out.bins.push_back({.low = first + i * width, .high = first + (i + 1) * width});
  }
  return out;
}

[[nodiscard]] Bins bins_of(const DistributionChart& chart) {
  std::vector<double> ascending = chart.values;
  std::sort(ascending.begin(), ascending.end());
  Bins out = empty_bins(ascending);
  const double width = out.bins.front().high - out.bins.front().low;
  for (const double value : ascending) {
    const double share = std::floor((value - out.bins.front().low) / width);
    const auto last = static_cast<double>(out.bins.size() - 1);
    Bin& bin = out.bins[static_cast<std::size_t>(std::clamp(share, 0.0, last))];
    ++(beyond(chart, value) ? bin.beyond : bin.kept);
  }
  return out;
}

/// The bars, with the limits that lie near them, and air around.
[[nodiscard]] ChartRange range_of(const DistributionChart& chart, const Bins& bins) {
  ChartRange range{bins.bins.front().low, bins.bins.back().high};
  const double reach = kNearSpans * (range.high - range.low);
  const ChartRange near{range.low - reach, range.high + reach};
  for (const DistributionLimit& limit : chart.limits) {
    if (limit.value >= near.low && limit.value <= near.high) {
      range = {std::min(range.low, limit.value), std::max(range.high, limit.value)};
    }
  }
  const double span = range.high - range.low;
  const double air = std::max(0.06 * span, bins.whole ? (kWholeSpanMin - span) / 2.0 : 0.0);
  return {range.low - air, range.high + air};
}

[[nodiscard]] std::optional<RenderError> fault_of(const DistributionChart& chart) {
  if (auto fault = frame_fault(chart.frame)) {
    return fault;
  }
  if (chart.values.empty()) {
    return RenderError{RenderError::Kind::kBadView, "a distribution without values cannot be drawn"};
  }
  for (const double value : chart.values) {
    if (auto fault = value_fault(value, false, "distribution")) {
      return fault;
    }
  }
  for (const DistributionLimit& limit : chart.limits) {
    if (auto fault = value_fault(limit.value, false, "limit " + limit.label)) {
      return fault;
    }
  }
  for (const DistributionRow& row : chart.rows) {
    if (auto fault = row.interval ? value_fault(row.estimate, false, "row " + row.text) : std::nullopt) {
      return fault;
    }
  }
  return std::nullopt;
}

[[nodiscard]] double rows_units(const DistributionChart& chart) {
  double units = chart.rows.empty() ? 0.0 : kAfterRowsUnits;
  for (const DistributionRow& row : chart.rows) {
    units += kRowUnits + (row.interval ? kIntervalUnits : 0.0);
  }
  return units;
}

[[nodiscard]] double x_px(const Chart& placed, double value) {
  return placed.plot.x + std::clamp(share_along(placed.x, value), 0.0, 1.0) * placed.plot.width;
}

void draw_interval(Canvas& canvas, const Chart& placed, const DistributionRow& row, double y, double u) {
  const RectPx& plot = placed.plot;
  canvas.line({plot.x, y}, {plot.right(), y}, {1.5 * u, palette::kGrid, 0.0});
  const double from = x_px(placed, row.interval->low);
  const double to = x_px(placed, row.interval->high);
  canvas.line({from, y}, {to, y}, {5.0 * u, row.color, 0.0});
  for (const auto& [end, value, outward] :
       {std::tuple{from, row.interval->low, -1.0}, std::tuple{to, row.interval->high, 1.0}}) {
    const bool inside = share_along(placed.x, value) >= 0.0 && share_along(placed.x, value) <= 1.0;
    if (inside) {
      canvas.line({end, y - 8.0 * u}, {end, y + 8.0 * u}, {3.0 * u, row.color, 0.0});
    } else {
      const std::vector<Vec2> arrow{{end + outward * 14.0 * u, y}, {end, y - 9.0 * u}, {end, y + 9.0 * u}};
      canvas.fill(arrow, row.color);
    }
  }
  if (row.limit && share_along(placed.x, *row.limit) >= 0.0 && share_along(placed.x, *row.limit) <= 1.0) {
    const double at = x_px(placed, *row.limit);
    canvas.line({at, y - 11.0 * u}, {at, y + 11.0 * u}, {3.0 * u, palette::kInk, 0.0});
  }
  canvas.disc({x_px(placed, row.estimate), y}, 8.0 * u, palette::kPaper);
  canvas.disc({x_px(placed, row.estimate), y}, 6.0 * u, row.color);
}

void draw_rows(Canvas& canvas, const DistributionChart& chart, const Chart& placed, double top, double u) {
  double y = top;
  for (const DistributionRow& row : chart.rows) {
    const double middle = y + kRowUnits * u / 2.0;
    canvas.disc({(kTextLeftUnits + 8.0) * u, middle}, 8.0 * u, row.color);
    const double left = (kTextLeftUnits + 28.0) * u;
    const double width = chart.frame.width_px - left - 48.0 * u;
    const TextStyle style = canvas.fitted(row.text, {23.0 * u, palette::kInk}, width, 0.8);
    canvas.text({left, middle}, canvas.cut(row.text, style, width), style);
    y += kRowUnits * u;
    if (row.interval) {
      draw_interval(canvas, placed, row, y + kIntervalUnits * u / 3.0, u);
      y += kIntervalUnits * u;
    }
  }
}

void draw_bars(Canvas& canvas, const Chart& placed, const Bins& bins, double u) {
  for (const Bin& bin : bins.bins) {
    const double left = x_px(placed, bin.low);
    const double width = x_px(placed, bin.high) - left;
    const double gap = std::min(3.0 * u, 0.2 * width);
    const auto height_of = [&](int count) { return share_along(placed.y, count) * placed.plot.height; };
    const double kept = height_of(bin.kept);
    const double all = height_of(bin.kept + bin.beyond);
    const double bottom = placed.plot.bottom();
    canvas.fill(RectPx{left + gap / 2.0, bottom - kept, width - gap, kept}, palette::kSky);
    canvas.fill(RectPx{left + gap / 2.0, bottom - all, width - gap, all - kept}, palette::kVermilion);
  }
}

/// Where the line of a limit stands: among whole numbers, beside the bar that still keeps it.
[[nodiscard]] double line_of(const DistributionLimit& limit, bool whole) {
  const bool on_bar = whole && limit.of_each && limit.value == std::nearbyint(limit.value);
  return limit.value + (on_bar ? (limit.upper ? 0.5 : -0.5) : 0.0);
}

/// Each limit's words on a line of their own, so that near limits do not write over each other.
void draw_limits(Canvas& canvas, const DistributionChart& chart, const Chart& placed, bool whole, double u) {
  const RectPx& plot = placed.plot;
  const auto share_of = [&](const DistributionLimit& limit) {
    return share_along(placed.x, line_of(limit, whole));
  };
  for (const DistributionLimit& limit : chart.limits) {
    if (const double share = share_of(limit); share >= 0.0 && share <= 1.0) {
      const double x = plot.x + share * plot.width;
      canvas.line({x, plot.bottom()}, {x, plot.y}, {2.5 * u, limit.color, 8.0 * u});
    }
  }
  double y = plot.y + 16.0 * u;
  for (const DistributionLimit& limit : chart.limits) {
    const double share = share_of(limit);
    const bool right = share > 0.6;
    const TextStyle style{20.0 * u, limit.color,
                          true,     right ? Align::kRight : Align::kLeft,
                          0.0,      palette::kPaper.with_alpha(240)};
    if (share < 0.0 || share > 1.0) {
      canvas.text({right ? plot.right() : plot.x + 10.0 * u, y},
                  right ? limit.label + " \u2192" : "\u2190 " + limit.label, style);
    } else {
      canvas.text({plot.x + share * plot.width + (right ? -10.0 : 10.0) * u, y}, limit.label, style);
    }
    y += kLimitUnits * u;
  }
}

/// The frame with room for the rows. The unit is that of the chart without them.
[[nodiscard]] ChartFrame grown(const DistributionChart& chart) {
  ChartFrame frame = chart.frame;
  frame.height_px += static_cast<int>(std::ceil(rows_units(chart) * chart_unit_px(chart.frame)));
  return frame;
}

[[nodiscard]] Chart paint(Canvas& canvas, const DistributionChart& chart) {
  const double u = chart_unit_px(chart.frame);
  const double rows = rows_units(chart) * u;
  const Bins bins = bins_of(chart);
  int most = 0;
  for (const Bin& bin : bins.bins) {
    most = std::max(most, bin.kept + bin.beyond);
  }
  Chart placed;
  placed.plot = chart_plot(chart.frame, kRightUnits);
  const double rows_top = placed.plot.y - 44.0 * u;
  placed.plot.y += rows;
  // Room above the highest bar for the words of the limits.
  const double words = kLimitUnits * u * static_cast<double>(chart.limits.size()) / placed.plot.height;
  placed.x = {chart.frame.x.label, false, range_of(chart, bins)};
  placed.y = {chart.frame.y.label, false,
              ChartRange{0.0, std::max(4.0, most * 1.06) / std::max(0.4, 1.0 - words)}};
  draw_chart_heading(canvas, chart.frame);
  draw_axis_labels(canvas, chart.frame, placed.plot);
  draw_axes(canvas, chart.frame, placed.plot, placed.x, placed.y);
  draw_rows(canvas, chart, placed, rows_top, u);
  draw_bars(canvas, placed, bins, u);
  draw_limits(canvas, chart, placed, bins.whole, u);
  return placed;
}

}  // namespace

Rendered<Chart> draw(const DistributionChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_image(grown(chart), [&](Canvas& canvas) { return paint(canvas, chart); });
}

Rendered<std::string> draw_svg(const DistributionChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_svg(grown(chart), [&](Canvas& canvas) { return paint(canvas, chart); });
}

}  // namespace sensotwin::render
