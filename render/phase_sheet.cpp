// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/chart_style.hpp"
#include "render/phase_pictures.hpp"
#include "render/ticks.hpp"

namespace sensotwin::render {
namespace {

// Units, chosen by looking at the pictures at 1000 pixels width.
constexpr double kMargin = 48.0;
constexpr double kTop = 138.0;      ///< of the heading
constexpr double kAxisLeft = 60.0;  ///< numbers of the plan's axis
constexpr double kAxisBelow = 40.0;
constexpr double kScale = 46.0;      ///< the scale bar's row
constexpr double kPanelLeft = 72.0;  ///< numbers of a chart's axis
constexpr double kPanelBelow = 92.0;
/// Scenes wider than this are drawn over their error chart, others beside it.
constexpr double kWide = 1.55;

/// "cm" with as many digits as a reader needs: "3.4 cm", "17.5 cm", "0.92 cm".
[[nodiscard]] std::string cm_text(double value_m) {
  const double cm = 100.0 * value_m;
  return fmt::format("{:.{}f} cm", cm, cm < 1.0 ? 2 : 1);
}

[[nodiscard]] std::string second_line(const PhaseRunView& view) {
  const std::string scene =
      fmt::format("{} · seed {}", view.scene.empty() ? "unnamed scene" : view.scene, view.seed);
  return view.subtitle.empty() ? scene : scene + " · " + view.subtitle;
}

/// What the error adds up to, and what it is to be compared with. \returns the right end of the text
double paint_figures(Canvas& canvas, const PhaseRunView& view, const Vec2& left, double u) {
  double x = left.x();
  const auto put = [&](const std::string& text, const TextStyle& style) {
    canvas.text({x, left.y()}, text, style);
    x += canvas.width_of(text, style) + 22.0 * u;
  };
  if (view.rmse_m) {
    put("RMSE " + cm_text(*view.rmse_m), {30.0 * u, palette::kInk, true});
  }
  const TextStyle soft{23.0 * u, palette::kSoftInk};
  if (view.bound_m) {
    put("bound " + cm_text(*view.bound_m), soft);
  }
  if (view.paper_rmse_m) {
    put("paper " + cm_text(*view.paper_rmse_m), soft);
  }
  return x;
}

[[nodiscard]] bool has_figures(const PhaseRunView& view) {
  return view.rmse_m || view.bound_m || view.paper_rmse_m;
}

[[nodiscard]] std::ptrdiff_t counted_segments(const PhaseRunView& view) {
  return std::count_if(view.segments.begin(), view.segments.end(),
                       [](const SegmentView& segment) { return segment.counted; });
}

[[nodiscard]] Panel error_panel(const PhaseRunView& view, const RectPx& plot, double u) {
  Panel panel;
  panel.plot = plot;
  panel.unit_px = u;
  const ChartRange span = counted_span_s(view);
  panel.x = {"time (s)", false, span.high > span.low ? span : padded(span, false)};
  // From the error alone, but never so narrow that 2 mm fill the chart.
  double low = -0.2;
  double high = 0.2;
  for (const ErrorPoint& point : view.errors) {
    low = std::min(low, 100.0 * point.error_m);
    high = std::max(high, 100.0 * point.error_m);
  }
  if (view.rmse_m) {
    low = std::min(low, -100.0 * *view.rmse_m);
    high = std::max(high, 100.0 * *view.rmse_m);
  }
  const double air = 0.08 * (high - low);
  // Names of segments stand in the air above the curve: 40 units.
  const double names = counted_segments(view) > 0 ? 40.0 * u / plot.height * (high - low + 2.0 * air) : 0.0;
  panel.y = {"error (cm), left of travel positive", false, ChartRange{low - air, high + air + names}};
  return panel;
}

/// Lines where one segment gives way to the next, and names over their stretches where they fit.
void paint_segments(Canvas& canvas, const PhaseRunView& view, const Panel& panel) {
  const double u = panel.unit_px;
  const RunColors colors(view);
  const TextStyle style{20.0 * u, palette::kInk, false, Align::kCenter, 0.0, palette::kPaper.with_alpha(230)};
  // Many lines are drawn fainter.
  const Rgba ink = palette::kSoftInk.with_alpha(view.segments.size() > 15 ? 90 : 170);
  for (std::size_t i = 0; i < view.segments.size(); ++i) {
    const SegmentView& segment = view.segments[i];
    const double until = i + 1 < view.segments.size() ? view.segments[i + 1].from_s : panel.x.range->high;
    if (!segment.counted || until <= panel.x.range->low || segment.from_s >= panel.x.range->high) {
      continue;
    }
    const double left = std::max(panel.plot.x, panel.pixel({segment.from_s, 0.0}).x());
    const double right = std::min(panel.plot.right(), panel.pixel({until, 0.0}).x());
    if (left > panel.plot.x + 1.0) {
      canvas.line({left, panel.plot.y}, {left, panel.plot.bottom()}, {1.8 * u, ink, 7.0 * u});
    }
    if (view.coloring == PathColoring::kSegment) {
      canvas.fill(RectPx{left, panel.plot.y - 6.0 * u, right - left, 6.0 * u},
                  colors.at(0.5 * (segment.from_s + until)));
    }
    const TextStyle fitting = canvas.fitted(segment.name, style, right - left - 8.0 * u, 0.85);
    if (canvas.width_of(segment.name, fitting) <= right - left - 8.0 * u) {
      canvas.text({0.5 * (left + right), panel.plot.y + 18.0 * u}, segment.name, fitting);
    }
  }
}

void paint_error_line(Canvas& canvas, const PhaseRunView& view, const Panel& panel) {
  const double u = panel.unit_px;
  const RunColors colors(view);
  std::vector<Vec2> line;
  std::vector<double> times;
  for (const ErrorPoint& point : view.errors) {
    const Vec2 at = panel.pixel({point.t_s, 100.0 * point.error_m});
    // A third of a pixel: closer samples cannot be told apart.
    if (line.empty() || (at - line.back()).norm() > 0.33 || &point == &view.errors.back()) {
      line.push_back(at);
      times.push_back(point.t_s);
    }
  }
  canvas.line(line, {5.2 * u, palette::kInk, 0.0});
  for (std::size_t i = 0; i + 1 < line.size();) {
    const Rgba color = colors.at(times[i + 1]);
    std::size_t end = i + 1;
    while (end + 1 < line.size() && colors.at(times[end + 1]) == color) {
      ++end;
    }
    canvas.line(std::span(line).subspan(i, end - i + 1), {3.2 * u, color, 0.0});
    i = end;
  }
}

[[nodiscard]] std::vector<FlowItem> error_legend(const PhaseRunView& view) {
  std::vector<FlowItem> items;
  const Vec2 half{18.0, 0.0};
  if (view.rmse_m) {
    items.push_back(
        {"± RMSE", [half](Canvas& canvas, const Vec2& c, double u) {
           const RectPx box{c.x() - 18.0 * u, c.y() - 9.0 * u, 36.0 * u, 18.0 * u};
           canvas.fill(box, palette::kBlue.with_alpha(30));
           canvas.line({box.x, box.y}, {box.right(), box.y}, {1.6 * u, palette::kBlue, 0.0});
           canvas.line({box.x, box.bottom()}, {box.right(), box.bottom()}, {1.6 * u, palette::kBlue, 0.0});
         }});
  }
  if (counted_segments(view) > 1) {
    items.push_back({"next segment", [](Canvas& canvas, const Vec2& c, double u) {
                       canvas.line(c - Vec2{0.0, 15.0} * u, c + Vec2{0.0, 15.0} * u,
                                   {2.0 * u, palette::kSoftInk, 6.0 * u});
                     }});
  }
  return items;
}

/// Where the parts of a sheet lie, pixels.
struct SheetPlaces {
  double u{1.0};
  int height_px{0};
  RectPx plan;
  RectPx error;
  Vec2 figures{0.0, 0.0};
  RectPx legend;
  Vec2 scale{0.0, 0.0};
};

[[nodiscard]] std::vector<FlowItem> joined(std::vector<FlowItem> a, const std::vector<FlowItem>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Plan at the left; figures, chart and legend at the right.
[[nodiscard]] SheetPlaces beside(const Canvas& measure, int width_px, double aspect,
                                 const std::vector<FlowItem>& items) {
  SheetPlaces at;
  const double u = at.u = width_px / 1600.0;
  const double plan_width = 720.0 * u;
  const double plan_height = std::clamp(plan_width / aspect, 620.0 * u, 900.0 * u);
  at.plan = {(kMargin + kAxisLeft) * u, kTop * u, plan_width, plan_height};
  at.scale = {at.plan.x, at.plan.bottom() + (kAxisBelow + 26.0) * u};
  at.height_px = static_cast<int>(std::lround(at.plan.bottom() + (kAxisBelow + kScale + 24.0) * u));
  const double left = at.plan.right() + 48.0 * u;
  const double right = width_px - kMargin * u;
  const double legend_height = flow_height(measure, right - left, u, items);
  at.legend = {left, at.height_px - 30.0 * u - legend_height, right - left, legend_height};
  at.figures = {left + 8.0 * u, kTop * u + 14.0 * u};
  const double chart_top = kTop * u + 92.0 * u;
  at.error = {left + kPanelLeft * u, chart_top, right - left - kPanelLeft * u,
              at.legend.y - 26.0 * u - kPanelBelow * u - chart_top};
  return at;
}

/// Plan above, legend, figures and chart below.
[[nodiscard]] SheetPlaces stacked(const Canvas& measure, int width_px, double aspect,
                                  const std::vector<FlowItem>& items, bool with_error) {
  SheetPlaces at;
  const double u = at.u = width_px / 1600.0;
  const double plan_width = width_px - (2.0 * kMargin + kAxisLeft) * u;
  const double plan_height = std::clamp(plan_width / aspect + 30.0 * u, 260.0 * u, 1000.0 * u);
  at.plan = {(kMargin + kAxisLeft) * u, kTop * u, plan_width, plan_height};
  at.scale = {at.plan.x, at.plan.bottom() + (kAxisBelow + 26.0) * u};
  // The legend runs at the right of the scale bar.
  const double bar = 330.0 * u;
  at.legend = {at.plan.x + bar, at.plan.bottom() + (kAxisBelow + 8.0) * u, plan_width - bar, 0.0};
  at.legend.height = std::max(kScale * u, flow_height(measure, at.legend.width, u, items));
  if (!with_error) {
    at.height_px = static_cast<int>(std::lround(at.legend.bottom() + 26.0 * u));
    return at;
  }
  at.figures = {at.plan.x + (12.0 - 64.0) * u, at.legend.bottom() + 50.0 * u};
  at.error = {at.plan.x + 12.0 * u, at.figures.y() + 84.0 * u, plan_width - 12.0 * u, 330.0 * u};
  at.height_px = static_cast<int>(std::lround(at.error.bottom() + (kPanelBelow + 14.0) * u));
  return at;
}

void paint_scale(Canvas& canvas, PhasePicture& picture, const Vec2& from, double u) {
  Sheet sheet;
  sheet.unit_px = u;
  sheet.plot = {from.x(), 0.0, std::min(picture.plan.width, 760.0 * u), from.y() - 44.0 * u};
  picture.scale_bar = scale_bar_for(sheet, picture.pixel_from_W.px_per_m(Vec3::Zero()));
  draw_scale_bar(canvas, sheet, picture.scale_bar);
}

[[nodiscard]] double aspect_of(const PhaseRunView& view) {
  const Extent extent = extent_of(view);
  return extent.size_m().x() / extent.size_m().y();
}

[[nodiscard]] std::optional<RenderError> fault_of(const PhaseRunView& view, int width_px) {
  if (auto fault = size_fault(width_px, 0)) {
    return fault;
  }
  return first_fault(view);
}

[[nodiscard]] Rendered<PhasePicture> finished(Canvas& canvas, PhasePicture picture) {
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

[[nodiscard]] Rendered<PhasePicture> paint_sheet(const PhaseRunView& view, const SheetPlaces& at,
                                                 int width_px, const std::vector<FlowItem>& items,
                                                 bool with_error) {
  Canvas canvas = Canvas::pixels(width_px, at.height_px);
  PhasePicture picture;
  draw_sheet_heading(canvas, width_px, at.u, view.title, second_line(view));
  picture.plan = at.plan;
  picture.pixel_from_W = phase::paint_plan(canvas, view, at.plan, at.u);
  paint_scale(canvas, picture, at.scale, at.u);
  draw_flow_legend(canvas, at.legend, at.u, items);
  if (with_error) {
    paint_figures(canvas, view, at.figures, at.u);
    picture.error = phase::paint_error(canvas, view, at.error, at.u);
  }
  return finished(canvas, std::move(picture));
}

}  // namespace

namespace phase {

Panel paint_error(Canvas& canvas, const PhaseRunView& view, const RectPx& plot, double u) {
  Panel panel = error_panel(view, plot, u);
  if (view.rmse_m) {
    const double top = panel.pixel({0.0, 100.0 * *view.rmse_m}).y();
    const double bottom = panel.pixel({0.0, -100.0 * *view.rmse_m}).y();
    canvas.fill(RectPx{plot.x, top, plot.width, bottom - top}, palette::kBlue.with_alpha(22));
    for (const double y : {top, bottom}) {
      canvas.line({plot.x, y}, {plot.right(), y}, {1.6 * u, palette::kBlue.with_alpha(150), 0.0});
    }
  }
  draw_panel(canvas, panel);
  const double zero = panel.pixel({0.0, 0.0}).y();
  canvas.line({plot.x, zero}, {plot.right(), zero}, {2.2 * u, palette::kInk, 11.0 * u});
  paint_segments(canvas, view, panel);
  canvas.clip({plot.x - 3.0 * u, plot.y, plot.width + 6.0 * u, plot.height});
  paint_error_line(canvas, view, panel);
  canvas.unclip();
  return panel;
}

}  // namespace phase

Rendered<PhasePicture> draw_phase_plan(const PhaseRunView& view, int width_px) {
  if (auto fault = fault_of(view, width_px)) {
    return Unexpected{*fault};
  }
  const std::vector<FlowItem> items = phase::plan_legend(view);
  const Canvas measure = Canvas::pixels(8, 8);
  return paint_sheet(view, stacked(measure, width_px, aspect_of(view), items, false), width_px, items, false);
}

Rendered<PhasePicture> draw_phase_sheet(const PhaseRunView& view, int width_px) {
  if (auto fault = fault_of(view, width_px)) {
    return Unexpected{*fault};
  }
  const std::vector<FlowItem> items = joined(phase::plan_legend(view), error_legend(view));
  const Canvas measure = Canvas::pixels(8, 8);
  const double aspect = aspect_of(view);
  const SheetPlaces at = aspect > kWide ? stacked(measure, width_px, aspect, items, true)
                                        : beside(measure, width_px, aspect, items);
  return paint_sheet(view, at, width_px, items, true);
}

Rendered<PhasePicture> draw_tracking_error(const PhaseRunView& view, int width_px) {
  if (auto fault = fault_of(view, width_px)) {
    return Unexpected{*fault};
  }
  const double u = width_px / 1600.0;
  const double figures = has_figures(view) ? 46.0 * u : 0.0;
  Canvas canvas = Canvas::pixels(width_px, static_cast<int>(std::lround(800.0 * u + figures)));
  PhasePicture picture;
  draw_sheet_heading(canvas, width_px, u, view.title, second_line(view));
  const double left = (kMargin + kPanelLeft) * u;
  double right = paint_figures(canvas, view, {left - 64.0 * u, kTop * u + 14.0 * u}, u);
  const std::vector<FlowItem> items = error_legend(view);
  right += 30.0 * u;
  draw_flow_legend(canvas, {right, (kTop - 5.0) * u, width_px - kMargin * u - right, 0.0}, u, items);
  const RectPx plot{left, kTop * u + figures + 44.0 * u, width_px - left - kMargin * u, 510.0 * u};
  picture.error = phase::paint_error(canvas, view, plot, u);
  return finished(canvas, std::move(picture));
}

}  // namespace sensotwin::render
