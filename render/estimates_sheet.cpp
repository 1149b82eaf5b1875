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

constexpr std::size_t kMostTags = 60;

/// A tag with what was believed of it.
struct Believed {
  const PhaseTagView* tag{nullptr};
  std::vector<const TagEstimateView*> estimates;
};

[[nodiscard]] std::vector<Believed> believed_of(const PhaseRunView& view) {
  std::vector<Believed> all;
  for (const PhaseTagView& tag : view.tags) {
    Believed one{&tag, {}};
    for (const TagEstimateView& estimate : view.estimates) {
      if (estimate.name == tag.name) {
        one.estimates.push_back(&estimate);
      }
    }
    if (!one.estimates.empty()) {
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// Half a panel's side: room for the last ellipse and the last error of nine tags in ten; the tenth runs over
/// its panel's edge, and its number says where to.
[[nodiscard]] double half_side_m(const std::vector<Believed>& all) {
  std::vector<double> reach;
  for (const Believed& one : all) {
    const TagEstimateView& last = *one.estimates.back();
    reach.push_back((last.at_m - one.tag->at_m).norm() + ellipse_of(last.covariance_m2).major_m);
  }
  std::sort(reach.begin(), reach.end());
  const std::size_t ninth = std::min(reach.size() - 1, reach.size() * 9 / 10);
  const double wanted = 1.7 * reach[ninth];
  return std::max(wanted, 0.01);
}

void paint_tag(Canvas& canvas, const Believed& one, const RectPx& box, double px_per_m,
               const ChartRange& span_s, double u) {
  canvas.fill(box, rgb(0xF7F9FB));
  canvas.clip(box);
  const Vec2 c = box.center();
  canvas.line({box.x, c.y()}, {box.right(), c.y()}, {1.5 * u, palette::kHairline, 0.0});
  canvas.line({c.x(), box.y}, {c.x(), box.bottom()}, {1.5 * u, palette::kHairline, 0.0});
  const auto at = [&](const Vec2& p_m) -> Vec2 {
    const Vec2 off = px_per_m * (p_m - one.tag->at_m);
    return c + Vec2{off.x(), -off.y()};
  };
  std::vector<Vec2> track;
  double drawn_m = 1e300;
  for (const TagEstimateView* estimate : one.estimates) {
    track.push_back(at(estimate->at_m));
    const Ellipse ellipse = ellipse_of(estimate->covariance_m2);
    const bool last = estimate == one.estimates.back();
    // A fifth smaller than the ring before can be told from it.
    if (!last && ellipse.major_m > 0.8 * drawn_m) {
      continue;
    }
    drawn_m = ellipse.major_m;
    std::vector<Vec2> rim;
    for (const Vec2& p : ellipse_outline(estimate->at_m, ellipse)) {
      rim.push_back(at(p));
    }
    const double share =
        span_s.high > span_s.low ? (estimate->t_s - span_s.low) / (span_s.high - span_s.low) : 1.0;
    canvas.line(rim, {(last ? 5.0 : 3.4) * u, palette::kInk.with_alpha(last ? 255 : 120), 0.0});
    canvas.line(rim, {(last ? 3.4 : 2.2) * u, time_color(share), 0.0});
  }
  canvas.line(track, {1.8 * u, palette::kSoftInk, 0.0});
  canvas.disc(track.back(), 6.0 * u, palette::kPaper);
  canvas.disc(track.back(), 4.5 * u, palette::kInk);
  canvas.unclip();
  canvas.outline(box, {1.5 * u, palette::kHairline, 0.0});
}

void paint_caption(Canvas& canvas, const Believed& one, const RectPx& box, double u) {
  const double error_cm = 100.0 * (one.estimates.back()->at_m - one.tag->at_m).norm();
  const TextStyle name{22.0 * u, palette::kCeilingTag, true};
  const double y = box.y - 18.0 * u;
  const std::string off = fmt::format("{:.1f} cm off", error_cm);
  const TextStyle soft{20.0 * u, palette::kSoftInk, false, Align::kRight};
  const double left = box.width - canvas.width_of(off, soft) - 12.0 * u;
  canvas.text({box.x, y}, canvas.cut(one.tag->name, name, left), name);
  canvas.text({box.right(), y}, off, soft);
}

[[nodiscard]] std::vector<FlowItem> legend_of(const ChartRange& span_s) {
  const std::string times = fmt::format("95 % ellipse, {:.0f} to {:.0f} s", span_s.low, span_s.high);
  return {{times,
           [](Canvas& canvas, const Vec2& c, double u) {
             for (const auto& [share, grow] :
                  {std::pair{0.0, 1.0}, std::pair{0.35, 0.75}, std::pair{1.0, 0.45}}) {
               const std::vector<Vec2> rim = ellipse_outline(c, {19.0 * u * grow, 13.0 * u * grow, 0.0});
               canvas.line(rim, {3.6 * u, palette::kInk.with_alpha(120), 0.0});
               canvas.line(rim, {2.4 * u, time_color(share), 0.0});
             }
           }},
          {"last estimate",
           [](Canvas& canvas, const Vec2& c, double u) { canvas.disc(c, 4.5 * u, palette::kInk); }},
          {"below the tag, in truth", [](Canvas& canvas, const Vec2& c, double u) {
             canvas.line(c - Vec2{16.0, 0.0} * u, c + Vec2{16.0, 0.0} * u, {1.8 * u, palette::kSoftInk, 0.0});
             canvas.line(c - Vec2{0.0, 16.0} * u, c + Vec2{0.0, 16.0} * u, {1.8 * u, palette::kSoftInk, 0.0});
           }}};
}

}  // namespace

Rendered<PhasePicture> draw_estimates_sheet(const PhaseRunView& view, int width_px) {
  if (auto fault = size_fault(width_px, 0)) {
    return Unexpected{*fault};
  }
  if (auto fault = first_fault(view)) {
    return Unexpected{*fault};
  }
  const std::vector<Believed> all = believed_of(view);
  if (all.empty() || all.size() > kMostTags) {
    return Unexpected{
        RenderError{RenderError::Kind::kBadView,
                    fmt::format("a sheet of estimates shows 1 to {} tags, not {}", kMostTags, all.size())}};
  }
  const double u = width_px / 1600.0;
  const std::size_t columns = all.size() <= 4 ? all.size() : all.size() <= 8 ? 4 : all.size() <= 20 ? 5 : 8;
  const double gap = 28.0 * u;
  const auto wide = static_cast<double>(std::max<std::size_t>(columns, 3));
  const double side = std::floor((width_px - 96.0 * u - (wide - 1.0) * gap) / wide);
  const std::size_t rows = (all.size() + columns - 1) / columns;
  const double row_height = side + 56.0 * u;
  const double top = 132.0 * u;
  const double foot = top + static_cast<double>(rows) * row_height;
  Canvas canvas = Canvas::pixels(width_px, static_cast<int>(std::lround(foot + 84.0 * u)));
  const std::string scene =
      fmt::format("{} · seed {}", view.scene.empty() ? "unnamed scene" : view.scene, view.seed);
  draw_sheet_heading(canvas, width_px, u, view.title,
                     view.subtitle.empty() ? scene : scene + " · " + view.subtitle);
  const double px_per_m = 0.5 * side / half_side_m(all);
  ChartRange span{view.estimates.front().t_s, view.estimates.back().t_s};
  PhasePicture picture;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t row = i / columns;
    const RectPx box{48.0 * u + static_cast<double>(i % columns) * (side + gap),
                     top + static_cast<double>(row) * row_height + 38.0 * u, side, side};
    paint_tag(canvas, all[i], box, px_per_m, span, u);
    paint_caption(canvas, all[i], box, u);
    // The last panel tells where W is.
    picture.plan = box;
    picture.pixel_from_W = Projection::top(all[i].tag->at_m, box.center(), px_per_m);
  }
  Sheet sheet;
  sheet.unit_px = u;
  sheet.plot = {48.0 * u, 0.0, side * 2.0, foot - 2.0 * u};
  picture.scale_bar = scale_bar_for(sheet, px_per_m);
  draw_scale_bar(canvas, sheet, picture.scale_bar);
  const double left = picture.scale_bar.to_px.x() + 150.0 * u;
  draw_flow_legend(canvas, {left, picture.scale_bar.from_px.y() - 19.0 * u, width_px - 48.0 * u - left, 0.0},
                   u, legend_of(span));
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

}  // namespace sensotwin::render
