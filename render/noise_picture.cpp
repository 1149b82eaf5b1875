// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "render/chart_style.hpp"
#include "render/phase_charts.hpp"

namespace sensotwin::render {
namespace {

constexpr double kDot = 2.3;   ///< units: a single read
constexpr double kMark = 6.5;  ///< units: a measured deviation

/// Laws are told apart by dash as well as by colour.
[[nodiscard]] LineStyle law_style(std::size_t index, double u) {
  static constexpr std::array kColors{palette::kInk, palette::kVermilion, palette::kPurple};
  return {3.4 * u, kColors[index % kColors.size()], index == 0 ? 0.0 : 12.0 * u};
}

[[nodiscard]] Rgba set_color(std::size_t index) {
  static constexpr std::array kColors{palette::kBlue, palette::kOrange, palette::kGreen, palette::kPink};
  return kColors[index % kColors.size()];
}

/// Every other set has squares: it can be told without colour too.
void paint_mark(Canvas& canvas, const Vec2& at, std::size_t set, double u) {
  const double r = kMark * u;
  if (set % 2 == 0) {
    canvas.disc(at, r + 1.5 * u, palette::kPaper);
    canvas.disc(at, r, set_color(set));
    return;
  }
  const auto box = [&at](double half) {
    return RectPx{at.x() - half, at.y() - half, 2.0 * half, 2.0 * half};
  };
  canvas.fill(box(0.9 * r + 1.5 * u), palette::kPaper);
  canvas.fill(box(0.9 * r), set_color(set));
}

/// Collects a range; empty until something is added.
struct Span {
  double low{1e300};
  double high{-1e300};
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return high < low; }
};

/// A little air on both sides; from 0 when the data begin near it.
[[nodiscard]] ChartRange range_of(const Span& span) {
  return span.empty() ? ChartRange{0.0, 1.0} : padded({span.low, span.high}, false);
}

[[nodiscard]] Axis x_axis(const NoiseView& view) {
  Span x;
  for (const ChartPoint& read : view.reads) {
    x.add(read.x);
  }
  for (const NoiseSet& set : view.measured) {
    for (const NoisePoint& point : set.points) {
      x.add(point.x);
    }
  }
  const bool measured = !x.empty();
  for (const NoiseLawView& law : view.laws) {
    for (const ChartPoint& point : law.curve) {
      // A law may reach far beyond what was measured: it does not widen the chart.
      if (!measured) {
        x.add(point.x);
      }
    }
  }
  return {view.x_label, false, range_of(x)};
}

[[nodiscard]] Axis sigma_axis(const NoiseView& view, const ChartRange& x) {
  Span sigma;
  sigma.add(0.0);
  for (const NoiseSet& set : view.measured) {
    for (const NoisePoint& point : set.points) {
      sigma.add(point.interval_rad ? std::max(point.sigma_rad, point.interval_rad->high) : point.sigma_rad);
    }
  }
  const double measured = sigma.high;
  for (const NoiseLawView& law : view.laws) {
    for (const ChartPoint& point : law.curve) {
      // A law that leaves the measurements is shown leaving them, not shrinking them.
      if (point.x >= x.low && point.x <= x.high && (measured <= 0.0 || point.y <= 1.25 * measured)) {
        sigma.add(point.y);
      }
    }
  }
  const double high = sigma.high > 0.0 ? 1.12 * sigma.high : 1.0;
  return {"standard deviation (rad)", false, ChartRange{0.0, high}};
}

[[nodiscard]] Axis read_axis(const NoiseView& view) {
  double most = 0.0;
  for (const ChartPoint& read : view.reads) {
    most = std::max(most, std::abs(read.y));
  }
  most = most > 0.0 ? 1.08 * most : 1.0;
  return {"phase error of single reads (rad)", false, ChartRange{-most, most}};
}

void paint_reads(Canvas& canvas, const NoiseView& view, const Panel& panel) {
  const double u = panel.unit_px;
  draw_panel(canvas, panel, false);
  canvas.clip(panel.plot);
  if (!view.laws.empty()) {
    std::vector<Vec2> band;
    for (const ChartPoint& point : view.laws.front().curve) {
      band.push_back(panel.pixel({point.x, 2.0 * point.y}));
    }
    for (auto point = view.laws.front().curve.rbegin(); point != view.laws.front().curve.rend(); ++point) {
      band.push_back(panel.pixel({point->x, -2.0 * point->y}));
    }
    canvas.fill(band, palette::kInk.with_alpha(20));
  }
  // The more dots, the fainter: 3000 still show their density.
  const double share =
      std::clamp(600.0 / std::max<double>(1.0, static_cast<double>(view.reads.size())), 0.2, 1.0);
  const Rgba ink = palette::kBlue.with_alpha(static_cast<std::uint8_t>(60.0 + 160.0 * share));
  for (const ChartPoint& read : view.reads) {
    canvas.disc(panel.pixel(read), kDot * u, ink);
  }
  if (!view.laws.empty()) {
    for (const double sign : {-2.0, 2.0}) {
      std::vector<Vec2> rim;
      for (const ChartPoint& point : view.laws.front().curve) {
        rim.push_back(panel.pixel({point.x, sign * point.y}));
      }
      canvas.line(rim, {2.2 * u, palette::kInk, 0.0});
    }
  }
  canvas.unclip();
  const double zero = panel.pixel({panel.x.range->low, 0.0}).y();
  canvas.line({panel.plot.x, zero}, {panel.plot.right(), zero}, {1.6 * u, palette::kSoftInk, 0.0});
}

void paint_deviations(Canvas& canvas, const NoiseView& view, const Panel& panel) {
  const double u = panel.unit_px;
  draw_panel(canvas, panel);
  canvas.clip({panel.plot.x, panel.plot.y, panel.plot.width, panel.plot.height + 3.0 * u});
  for (std::size_t i = 0; i < view.laws.size(); ++i) {
    std::vector<Vec2> line;
    for (const ChartPoint& point : view.laws[i].curve) {
      line.push_back(panel.pixel(point));
    }
    canvas.line(line, law_style(i, u));
  }
  canvas.unclip();
  for (std::size_t set = 0; set < view.measured.size(); ++set) {
    for (const NoisePoint& point : view.measured[set].points) {
      // Sets measured at the same places stand beside each other.
      const double shift =
          9.0 * u * (static_cast<double>(set) - 0.5 * static_cast<double>(view.measured.size() - 1));
      const Vec2 aside{shift, 0.0};
      if (point.interval_rad) {
        canvas.line(panel.pixel({point.x, point.interval_rad->low}) + aside,
                    panel.pixel({point.x, point.interval_rad->high}) + aside, {2.4 * u, set_color(set), 0.0});
      }
      paint_mark(canvas, panel.pixel({point.x, point.sigma_rad}) + aside, set, u);
    }
  }
}

[[nodiscard]] std::vector<FlowItem> legend_of(const NoiseView& view) {
  std::vector<FlowItem> items;
  const bool intervals = std::any_of(view.measured.begin(), view.measured.end(), [](const NoiseSet& set) {
    return std::any_of(set.points.begin(), set.points.end(),
                       [](const NoisePoint& point) { return point.interval_rad.has_value(); });
  });
  for (std::size_t i = 0; i < view.measured.size(); ++i) {
    items.push_back(
        {view.measured[i].name, [i, intervals](Canvas& canvas, const Vec2& c, double u) {
           if (intervals) {
             canvas.line(c - Vec2{0.0, 14.0} * u, c + Vec2{0.0, 14.0} * u, {2.4 * u, set_color(i), 0.0});
           }
           paint_mark(canvas, c, i, u);
         }});
  }
  for (std::size_t i = 0; i < view.laws.size(); ++i) {
    items.push_back({view.laws[i].name, [i](Canvas& canvas, const Vec2& c, double u) {
                       LineStyle style = law_style(i, u);
                       style.dash_px = std::min(style.dash_px, 7.0 * u);
                       canvas.line(c - Vec2{18.0, 0.0} * u, c + Vec2{18.0, 0.0} * u, style);
                     }});
  }
  if (!view.reads.empty() && !view.laws.empty()) {
    items.push_back({"± 2 σ of " + view.laws.front().name, [](Canvas& canvas, const Vec2& c, double u) {
                       const RectPx box{c.x() - 18.0 * u, c.y() - 10.0 * u, 36.0 * u, 20.0 * u};
                       canvas.fill(box, palette::kInk.with_alpha(20));
                       for (const double y : {box.y, box.bottom()}) {
                         canvas.line({box.x, y}, {box.right(), y}, {2.2 * u, palette::kInk, 0.0});
                       }
                     }});
  }
  return items;
}

}  // namespace

Rendered<PanelPicture> draw_noise(const NoiseView& view, int width_px) {
  if (auto fault = size_fault(width_px, 0)) {
    return Unexpected{*fault};
  }
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  const double u = width_px / 1600.0;
  const std::vector<FlowItem> items = legend_of(view);
  const double width = width_px - (120.0 + 56.0) * u;
  const double legend = flow_height(Canvas::pixels(8, 8), width, u, items);
  double y = 132.0 * u + legend + 70.0 * u;
  PanelPicture picture;
  const Axis x = x_axis(view);
  if (!view.reads.empty()) {
    picture.panels.push_back({{120.0 * u, y, width, 330.0 * u}, x, read_axis(view), u});
    y += (330.0 + 110.0) * u;
  }
  const double height = (view.reads.empty() ? 560.0 : 360.0) * u;
  picture.panels.push_back({{120.0 * u, y, width, height}, x, sigma_axis(view, *x.range), u});
  Canvas canvas = Canvas::pixels(width_px, static_cast<int>(std::lround(y + height + 112.0 * u)));
  draw_sheet_heading(canvas, width_px, u, view.title, view.subtitle);
  draw_flow_legend(canvas, {56.0 * u, 132.0 * u, width, legend}, u, items);
  if (!view.reads.empty()) {
    paint_reads(canvas, view, picture.panels.front());
  }
  paint_deviations(canvas, view, picture.panels.back());
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

}  // namespace sensotwin::render
