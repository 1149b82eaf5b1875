// SPDX-License-Identifier: MIT
#include "render/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/chart_style.hpp"

namespace sensotwin::render {
namespace {

constexpr double kRightUnits = 64.0;
constexpr double kEndLabelUnits = 190.0;

/// Collects the range of one axis.
class RangeOf {
 public:
  void add(double value) {
    range_ = range_ ? ChartRange{std::min(range_->low, value), std::max(range_->high, value)}
                    : ChartRange{value, value};
  }
  [[nodiscard]] ChartRange range(bool log) const {
    return padded(range_.value_or(log ? ChartRange{1.0, 10.0} : ChartRange{0.0, 1.0}), log);
  }

 private:
  std::optional<ChartRange> range_;
};

[[nodiscard]] std::optional<RenderError> point_fault(const ChartFrame& frame, const ChartPoint& p,
                                                     const std::string& what) {
  if (auto fault = value_fault(p.x, frame.x.log, what)) {
    return fault;
  }
  return value_fault(p.y, frame.y.log, what);
}

[[nodiscard]] std::optional<RenderError> fault_of(const LineChart& chart) {
  if (auto fault = frame_fault(chart.frame)) {
    return fault;
  }
  for (const Series& series : chart.series) {
    for (const ChartPoint& p : series.points) {
      if (auto fault = point_fault(chart.frame, p, "series " + series.name)) {
        return fault;
      }
    }
  }
  for (const ReferencePoint& reference : chart.reference_points) {
    if (auto fault = point_fault(chart.frame, reference.at, "reference " + reference.label)) {
      return fault;
    }
  }
  for (const ReferenceLine& line : chart.reference_lines) {
    const bool log = line.vertical ? chart.frame.x.log : chart.frame.y.log;
    if (auto fault = value_fault(line.value, log, "reference line " + line.label)) {
      return fault;
    }
  }
  return std::nullopt;
}

[[nodiscard]] Chart ranged(const LineChart& chart) {
  RangeOf x;
  RangeOf y;
  const auto add = [&](const ChartPoint& p) {
    x.add(p.x);
    y.add(p.y);
  };
  for (const Series& series : chart.series) {
    std::for_each(series.points.begin(), series.points.end(), add);
  }
  for (const ReferencePoint& reference : chart.reference_points) {
    add(reference.at);
  }
  for (const ReferenceLine& line : chart.reference_lines) {
    line.vertical ? x.add(line.value) : y.add(line.value);
  }
  Chart out;
  out.x = chart.frame.x;
  out.y = chart.frame.y;
  out.x.range = out.x.range ? out.x.range : x.range(out.x.log);
  out.y.range = out.y.range ? out.y.range : y.range(out.y.log);
  const bool labels = std::any_of(chart.series.begin(), chart.series.end(),
                                  [](const Series& s) { return !s.end_label.empty() && !s.end_label_above; });
  out.plot = chart_plot(chart.frame, labels ? kEndLabelUnits : kRightUnits);
  return out;
}

/// The series as pixels, points that share a pixel column merged to first, lowest, highest and last: 10^5
/// points look the same and cost what the picture's width costs.
[[nodiscard]] std::vector<Vec2> polyline_px(const Chart& chart, const Series& series) {
  std::vector<Vec2> all;
  for (const ChartPoint& p : series.points) {
    const Vec2 at = chart.pixel(p);
    if (series.style == SeriesStyle::kStep && !all.empty()) {
      all.push_back({at.x(), all.back().y()});
    }
    all.push_back(at);
  }
  if (all.size() < 8000) {
    return all;
  }
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    std::size_t low = i;
    std::size_t high = i;
    while (end < all.size() && std::floor(all[end].x()) == std::floor(all[i].x())) {
      low = all[end].y() < all[low].y() ? end : low;
      high = all[end].y() > all[high].y() ? end : high;
      ++end;
    }
    for (const std::size_t k : {i, std::min(low, high), std::max(low, high), end - 1}) {
      kept.push_back(all[k]);
    }
    i = end;
  }
  return kept;
}

void draw_series(Canvas& canvas, const Chart& chart, const Series& series, double u) {
  const std::vector<Vec2> points = polyline_px(chart, series);
  if (points.empty()) {
    return;
  }
  if (series.style == SeriesStyle::kMarkers) {
    for (const Vec2& p : points) {
      canvas.disc(p, 6.0 * u, series.color);
    }
    return;
  }
  canvas.line(points, {series.width_px * u, series.color, series.dashed ? 10.0 * u : 0.0});
  if (points.size() == 1) {
    canvas.disc(points[0], 6.0 * u, series.color);
  }
}

/// At the last point; pushed away where it would lie on an earlier one.
void draw_end_labels(Canvas& canvas, const LineChart& chart, const Chart& placed, double u) {
  std::vector<RectPx> taken;
  for (const Series& series : chart.series) {
    if (series.end_label.empty() || series.points.empty()) {
      continue;
    }
    const Vec2 end = placed.pixel(series.points.back());
    canvas.disc(end, 6.5 * u, series.color);
    const TextStyle style{21.0 * u, series.color, true, Align::kLeft, 0.0, palette::kPaper.with_alpha(230)};
    const double width = canvas.width_of(series.end_label, style);
    RectPx box{end.x() + 14.0 * u, end.y() - 13.0 * u, width, 26.0 * u};
    if (series.end_label_above) {
      box.x = end.x() - width / 2.0;
      box.y = end.y() - 44.0 * u;
    }
    for (const RectPx& other : taken) {
      if (box.overlaps(other)) {
        box.y = series.end_label_above ? other.y - box.height : other.bottom();
      }
    }
    taken.push_back(box);
    canvas.text({box.x, box.center().y()}, series.end_label, style);
  }
}

void draw_reference_points(Canvas& canvas, const LineChart& chart, const Chart& placed, double u) {
  for (const ReferencePoint& reference : chart.reference_points) {
    const Vec2 at = placed.pixel(reference.at);
    canvas.disc(at, 11.0 * u, palette::kPaper);
    canvas.ring(at, 10.0 * u, {3.0 * u, reference.color, 0.0});
    canvas.text(at + Vec2{0.0, 30.0 * u}, reference.label,
                {19.0 * u, reference.color, false, Align::kCenter, 0.0, palette::kPaper.with_alpha(230)});
  }
}

/// One row above the plot, at its right end.
void draw_chart_legend(Canvas& canvas, const LineChart& chart, const Chart& placed, double u) {
  const TextStyle style{22.0 * u, palette::kInk};
  const double y = placed.plot.y - 28.0 * u;
  double x = placed.plot.right();
  const auto item = [&](const std::string& name, const auto& swatch) {
    x -= canvas.width_of(name, style);
    canvas.text({x, y}, name, style);
    x -= 12.0 * u + 36.0 * u;
    swatch(Vec2{x, y});
    x -= 30.0 * u;
  };
  if (!chart.references_name.empty() && !chart.reference_points.empty()) {
    item(chart.references_name, [&](const Vec2& at) {
      canvas.ring(at + Vec2{18.0 * u, 0.0}, 9.0 * u, {3.0 * u, palette::kSoftInk, 0.0});
    });
  }
  for (auto series = chart.series.rbegin(); series != chart.series.rend(); ++series) {
    if (series->name.empty()) {
      continue;
    }
    item(series->name, [&](const Vec2& at) {
      if (series->style == SeriesStyle::kMarkers) {
        canvas.disc(at + Vec2{18.0 * u, 0.0}, 6.0 * u, series->color);
      } else {
        canvas.line(at, at + Vec2{36.0 * u, 0.0}, {5.0 * u, series->color, series->dashed ? 10.0 * u : 0.0});
      }
    });
  }
}

[[nodiscard]] Chart paint(Canvas& canvas, const LineChart& chart) {
  const double u = chart_unit_px(chart.frame);
  Chart placed = ranged(chart);
  draw_chart_heading(canvas, chart.frame);
  draw_axis_labels(canvas, chart.frame, placed.plot);
  draw_axes(canvas, chart.frame, placed.plot, placed.x, placed.y);
  draw_reference_lines(canvas, chart.frame, placed, chart.reference_lines);
  // Lines may touch the frame, but not leave it.
  canvas.clip({placed.plot.x - 4.0 * u, placed.plot.y - 4.0 * u, placed.plot.width + 8.0 * u,
               placed.plot.height + 8.0 * u});
  for (const Series& series : chart.series) {
    draw_series(canvas, placed, series, u);
  }
  canvas.unclip();
  draw_reference_points(canvas, chart, placed, u);
  draw_end_labels(canvas, chart, placed, u);
  draw_chart_legend(canvas, chart, placed, u);
  return placed;
}

[[nodiscard]] std::optional<RenderError> fault_of(const Histogram& chart) {
  if (auto fault = frame_fault(chart.frame)) {
    return fault;
  }
  if (chart.bins < 1 || chart.bins > 1000) {
    return RenderError{RenderError::Kind::kBadView,
                       fmt::format("a histogram of {} bins cannot be drawn", chart.bins)};
  }
  for (const double value : chart.values) {
    if (auto fault = value_fault(value, false, "histogram")) {
      return fault;
    }
  }
  for (const ReferenceLine& line : chart.reference_lines) {
    if (auto fault = value_fault(line.value, false, "reference line " + line.label)) {
      return fault;
    }
  }
  return std::nullopt;
}

[[nodiscard]] std::vector<std::size_t> counts_of(const Histogram& chart, const ChartRange& range) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(chart.bins), 0);
  for (const double value : chart.values) {
    const double share = (value - range.low) / (range.high - range.low);
    if (share >= 0.0 && share <= 1.0) {
      const auto bin = static_cast<std::size_t>(share * chart.bins);
      ++counts[std::min(bin, counts.size() - 1)];
    }
  }
  return counts;
}

[[nodiscard]] Chart paint(Canvas& canvas, const Histogram& chart) {
  const double u = chart_unit_px(chart.frame);
  Chart placed;
  placed.plot = chart_plot(chart.frame, kRightUnits);
  placed.x = {chart.frame.x.label, false, chart.frame.x.range};
  if (!placed.x.range) {
    const auto [low, high] = std::minmax_element(chart.values.begin(), chart.values.end());
    ChartRange range = chart.values.empty() ? ChartRange{0.0, 1.0} : ChartRange{*low, *high};
    placed.x.range = range.high > range.low ? range : padded(range, false);
  }
  const std::vector<std::size_t> counts = counts_of(chart, *placed.x.range);
  const auto most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  placed.y = {chart.frame.y.label, false,
              chart.frame.y.range.value_or(ChartRange{0.0, std::max(1.0, most * 1.08)})};
  draw_chart_heading(canvas, chart.frame);
  draw_axis_labels(canvas, chart.frame, placed.plot);
  draw_axes(canvas, chart.frame, placed.plot, placed.x, placed.y);
  canvas.clip(placed.plot);
  const double width = placed.plot.width / chart.bins;
  const double gap = std::min(3.0 * u, 0.2 * width);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double height = share_along(placed.y, static_cast<double>(counts[i])) * placed.plot.height;
    canvas.fill(RectPx{placed.plot.x + static_cast<double>(i) * width + gap / 2.0,
                       placed.plot.bottom() - height, width - gap, height},
                chart.color);
  }
  canvas.unclip();
  draw_reference_lines(canvas, chart.frame, placed, chart.reference_lines);
  return placed;
}

}  // namespace

Rendered<Chart> draw(const LineChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_image(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

Rendered<std::string> draw_svg(const LineChart& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_svg(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

Rendered<Chart> draw(const Histogram& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_image(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

Rendered<std::string> draw_svg(const Histogram& chart) {
  if (auto fault = fault_of(chart)) {
    return Unexpected{*fault};
  }
  return painted_svg(chart.frame, [&](Canvas& canvas) { return paint(canvas, chart); });
}

}  // namespace sensotwin::render
