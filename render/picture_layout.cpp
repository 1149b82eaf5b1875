// SPDX-License-Identifier: MIT
#include "render/picture_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/plane_geometry.hpp"
#include "render/ticks.hpp"

namespace sensotwin::render {
namespace {

// All in units (1 = a pixel of a 1600 pixels wide picture), chosen by looking at the pictures at 1000 pixels
// width.
constexpr double kMargin = 48.0;
constexpr double kHeading = 130.0;
constexpr double kFoot = 84.0;
constexpr double kLegendWidth = 300.0;
constexpr double kLegendGap = 48.0;
constexpr double kLegendLine = 40.0;
constexpr double kTextSize = 22.0;

using Swatch = LegendItem::Swatch;

void draw_tile_swatch(Canvas& canvas, const RectPx& box, double u, TileState state, TileStyle style) {
  canvas.fill(box, fill_of(state, style));
  const bool alarming = state == TileState::kMissed || state == TileState::kWrong;
  const Rgba edge = state == TileState::kMissed  ? palette::kVermilion
                    : state == TileState::kWrong ? palette::kPurple
                                                 : palette::kHairline;
  for (const TileMark& mark : marks_of(state)) {
    const auto on_box = [&box](const Vec2& p) -> Vec2 {
      return box.center() + box.width * Vec2{p.x(), -p.y()};
    };
    canvas.line(on_box(mark.from), on_box(mark.to),
                {std::max(mark.width * box.width, 1.2 * u), mark.color, 0.0});
  }
  if (alarming || state == TileState::kUnvisited) {
    canvas.outline(box, {(alarming ? 2.5 : 1.5) * u, edge, 0.0});
  }
}

void draw_furniture_swatch(Canvas& canvas, const RectPx& box, double u, Swatch kind) {
  const bool solid = kind == Swatch::kSolid;
  canvas.fill(box, solid ? palette::kFurniture : palette::kFurniture.with_alpha(110));
  canvas.outline(box, {2.0 * u, palette::kFurnitureEdge, solid ? 0.0 : 5.0 * u});
  if (kind == Swatch::kLegs) {
    for (const Vec2& corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
      canvas.disc(box.center() + 0.30 * box.width * corner, 3.2 * u, palette::kFurnitureEdge);
    }
  }
}

void draw_mark_swatch(Canvas& canvas, const RectPx& box, double u, Swatch kind) {
  const Vec2 c = box.center();
  const auto diamond = [&c](double r) {
    return std::array{Vec2(c + Vec2{r, 0}), Vec2(c + Vec2{0, r}), Vec2(c - Vec2{r, 0}), Vec2(c - Vec2{0, r})};
  };
  switch (kind) {
    case Swatch::kWall:
      canvas.line({box.x, c.y()}, {box.right(), c.y()}, {6.0 * u, palette::kWall, 0.0});
      break;
    case Swatch::kRobot:
      canvas.disc(c, 14.0 * u, palette::kRobot);
      canvas.fill(std::array{Vec2(c + Vec2{10, 0} * u), Vec2(c + Vec2{-5, 7} * u), Vec2(c + Vec2{-2, 0} * u),
                             Vec2(c + Vec2{-5, -7} * u)},
                  palette::kOrange);
      break;
    case Swatch::kStart:
      canvas.ring(c, 11.0 * u, {3.5 * u, palette::kBlue, 0.0});
      canvas.disc(c, 4.5 * u, palette::kBlue);
      break;
    case Swatch::kHomeBase:
      canvas.fill(RectPx{c.x() - 8.0 * u, c.y() - 13.0 * u, 16.0 * u, 26.0 * u}, palette::kGreen);
      break;
    case Swatch::kLandmark:
      canvas.fill(diamond(11.0 * u), palette::kGreen);
      break;
    case Swatch::kTag:
      canvas.disc(c, 3.4 * u, palette::kSoftInk);
      break;
    case Swatch::kDeadTag:
      canvas.ring(c, 5.0 * u, {2.0 * u, palette::kVermilion, 0.0});
      break;
    case Swatch::kCliff:
      canvas.fill(box, rgb(0x5B4A68));
      canvas.outline(box, {3.0 * u, palette::kOrange, 6.0 * u});
      break;
    case Swatch::kVirtualWall:
      canvas.fill(box, palette::kPink.with_alpha(90));
      break;
    case Swatch::kCeilingTag:
      canvas.fill(diamond(9.0 * u), palette::kCeilingTag);
      break;
    case Swatch::kIdealPath:
      canvas.line({box.x, c.y()}, {box.right(), c.y()}, {2.4 * u, palette::kInk, 6.0 * u});
      break;
    case Swatch::kEstimate: {
      const Polygon rim = ellipse_outline(c, {14.0 * u, 9.0 * u, 0.0});
      canvas.fill(rim, palette::kCeilingTag.with_alpha(38));
      canvas.line(rim, {2.4 * u, palette::kCeilingTag, 0.0});
      break;
    }
    case Swatch::kRay:
      canvas.line({box.x, box.bottom() - 6.0 * u}, {box.right(), box.y + 6.0 * u},
                  {3.0 * u, palette::kVermilion, 0.0});
      break;
    case Swatch::kAntenna:
      canvas.fill(RectPx{c.x() - 8.0 * u, c.y() - 8.0 * u, 16.0 * u, 16.0 * u}, palette::kInk);
      canvas.fill(RectPx{c.x() - 6.0 * u, c.y() - 6.0 * u, 12.0 * u, 12.0 * u}, palette::kSky);
      break;
    default:
      break;
  }
}

void draw_time_scale(Canvas& canvas, const Sheet& sheet, double top, double end_s) {
  const double u = sheet.unit_px;
  const double height = 22.0 * u;
  canvas.text({sheet.legend.x, top}, "time along the path", {kTextSize * u, palette::kInk, true});
  const RectPx bar{sheet.legend.x, top + 28.0 * u, sheet.legend.width - 24.0 * u, height};
  const int steps = 128;
  for (int i = 0; i < steps; ++i) {
    const double left = bar.x + bar.width * i / steps;
    // One pixel of overlap, so that no seam shows between neighbours.
    canvas.fill(RectPx{left, bar.y, std::min(bar.width / steps + 1.0, bar.right() - left), height},
                time_color((i + 0.5) / steps));
  }
  const bool in_minutes = end_s >= 120.0;
  const double unit_s = in_minutes ? 60.0 : 1.0;
  for (const Tick& tick : linear_ticks(0.0, end_s / unit_s, 4)) {
    const double x = bar.x + bar.width * (tick.value * unit_s / end_s);
    canvas.line({x, bar.bottom()}, {x, bar.bottom() + 7.0 * u}, {1.5 * u, palette::kSoftInk, 0.0});
    canvas.text({x, bar.bottom() + 22.0 * u}, tick.label,
                {19.0 * u, palette::kSoftInk, false, Align::kCenter});
  }
  canvas.text({bar.x, bar.bottom() + 50.0 * u}, in_minutes ? "minutes" : "seconds",
              {19.0 * u, palette::kSoftInk, false});
}

}  // namespace

Sheet sheet_for(int width_px, int height_px, double aspect) {
  Sheet sheet;
  sheet.width_px = width_px;
  sheet.unit_px = width_px / 1600.0;
  if (height_px > 0) {
    // A flat picture must not let its letters eat the plot.
    sheet.unit_px = std::min(sheet.unit_px, height_px / 760.0);
  }
  const double u = sheet.unit_px;
  const double plot_width = width_px - (2.0 * kMargin + kLegendWidth + kLegendGap) * u;
  const double wanted = plot_width / aspect + (kHeading + kFoot) * u;
  const double least = width_px * 9.0 / 16.0;
  const double most = width_px * 5.0 / 4.0;
  sheet.height_px =
      height_px > 0 ? height_px : static_cast<int>(std::lround(std::clamp(wanted, least, most)));
  sheet.plot = {kMargin * u, kHeading * u, plot_width, sheet.height_px - (kHeading + kFoot) * u};
  sheet.legend = {sheet.plot.right() + kLegendGap * u, kHeading * u, kLegendWidth * u, sheet.plot.height};
  return sheet;
}

/// Whether rays run from antennas to a tag.
[[nodiscard]] static bool rays_of_sight(const SceneView& view) {
  return view.robot && view.target_tag && *view.target_tag < view.ceiling_tags.size() &&
         !view.robot->antennas.empty();
}

std::vector<LegendItem> legend_of(const SceneView& view, TileStyle style) {
  std::vector<LegendItem> items;
  const auto tile_line = [&](TileState state, const char* text) {
    const auto n = std::count_if(view.tiles.begin(), view.tiles.end(),
                                 [state](const TileView& tile) { return tile.state == state; });
    if (n > 0) {
      items.push_back({Swatch::kTile, state, fmt::format("{} ({})", text, n)});
    }
  };
  const auto line = [&](bool shown, Swatch swatch, const char* text) {
    if (shown) {
      items.push_back({swatch, TileState::kUnvisited, text});
    }
  };
  const auto has = [&](FurnitureKind kind) {
    return std::any_of(view.furniture.begin(), view.furniture.end(),
                       [kind](const FurnitureView& piece) { return piece.kind == kind; });
  };
  const bool recovered = style == TileStyle::kRecovered;
  if (!recovered) {
    tile_line(TileState::kUnvisited, "not visited");
  }
  tile_line(TileState::kGrey, recovered ? "mapped, open" : "visited, open");
  tile_line(TileState::kBlack, recovered ? "mapped" : "visited, closed");
  tile_line(TileState::kBlocked, "blocked");
  tile_line(TileState::kUnreachable, "unreachable");
  tile_line(TileState::kMissed, "missed");
  tile_line(TileState::kWrong, "wrong place");
  const bool any_dead =
      std::any_of(view.tags.begin(), view.tags.end(), [](const TagView& t) { return t.dead; });
  const bool any_live =
      std::any_of(view.tags.begin(), view.tags.end(), [](const TagView& t) { return !t.dead; });
  line(any_live, Swatch::kTag, "floor tag");
  line(any_dead, Swatch::kDeadTag, "dead tag");
  line(!view.ceiling_tags.empty(), Swatch::kCeilingTag, "ceiling tag");
  line(!view.estimates.empty(), Swatch::kEstimate, "its estimate");
  line(!view.ideal_path_m.empty(), Swatch::kIdealPath, "ideal path");
  line(!view.walls.empty(), Swatch::kWall, "wall");
  line(has(FurnitureKind::kSolid), Swatch::kSolid, "furniture");
  line(has(FurnitureKind::kLegs), Swatch::kLegs, "table: legs block");
  line(has(FurnitureKind::kRaised), Swatch::kRaised, "robot fits below");
  line(!view.cliffs_m.empty(), Swatch::kCliff, "stairs down");
  line(!view.virtual_walls.empty(), Swatch::kVirtualWall, "virtual wall");
  line(!view.landmarks.empty(), Swatch::kLandmark, "landmark tag");
  line(view.home_base.has_value(), Swatch::kHomeBase, "home base");
  line(view.start.has_value(), Swatch::kStart, "start");
  line(view.robot.has_value(), Swatch::kRobot, "robot");
  line(view.robot && !view.robot->antennas.empty(), Swatch::kAntenna, "antenna");
  line(rays_of_sight(view), Swatch::kRay, "to the tag ahead");
  return items;
}

void draw_heading(Canvas& canvas, const Sheet& sheet, const SceneView& view) {
  const double u = sheet.unit_px;
  const double width = sheet.width_px - 2.0 * kMargin * u;
  const std::string scene =
      fmt::format("{} · seed {}", view.scene.empty() ? "unnamed scene" : view.scene, view.seed);
  const TextStyle title = canvas.fitted(view.title, {38.0 * u, palette::kInk, true}, width);
  canvas.text({kMargin * u, 50.0 * u}, canvas.cut(view.title, title, width), title);
  const std::string second = view.subtitle.empty() ? scene : scene + " · " + view.subtitle;
  const TextStyle small = canvas.fitted(second, {24.0 * u, palette::kSoftInk, false}, width, 0.8);
  canvas.text({kMargin * u, 94.0 * u}, canvas.cut(second, small, width), small);
}

void draw_legend(Canvas& canvas, const Sheet& sheet, const SceneView& view,
                 const std::vector<LegendItem>& items, TileStyle style) {
  const double u = sheet.unit_px;
  const double time_height = view.trajectory.empty() ? 0.0 : 130.0 * u;
  // A flat sheet with a long legend closes its lines up rather than running over.
  const double room = sheet.legend.height - time_height;
  const double step =
      std::min(kLegendLine * u, room / std::max<double>(1.0, static_cast<double>(items.size())));
  const double side = std::min(28.0 * u, 0.72 * step);
  const double swatch_unit = u * side / (28.0 * u);
  double y = sheet.legend.y + side / 2.0;
  for (const LegendItem& item : items) {
    const RectPx box{sheet.legend.x, y - side / 2.0, side, side};
    if (item.swatch == Swatch::kTile) {
      draw_tile_swatch(canvas, box, swatch_unit * u, item.tile, style);
    } else if (item.swatch == Swatch::kSolid || item.swatch == Swatch::kRaised ||
               item.swatch == Swatch::kLegs) {
      draw_furniture_swatch(canvas, box, swatch_unit * u, item.swatch);
    } else {
      draw_mark_swatch(canvas, box, swatch_unit * u, item.swatch);
    }
    const double text_x = box.right() + 14.0 * u;
    const TextStyle text =
        canvas.fitted(item.text, {std::min(kTextSize * u, 0.8 * step), palette::kInk, false},
                      sheet.width_px - 12.0 * u - text_x);
    canvas.text({text_x, y}, item.text, text);
    y += step;
  }
  if (!view.trajectory.empty() && time_end_s(view) > 0.0) {
    draw_time_scale(canvas, sheet, y + 14.0 * u, time_end_s(view));
  }
}

ScaleBar scale_bar_for(const Sheet& sheet, double px_per_m) {
  ScaleBar bar;
  bar.length_m = round_length_below(sheet.plot.width / 4.0 / px_per_m);
  const double y = sheet.plot.bottom() + 44.0 * sheet.unit_px;
  bar.from_px = {sheet.plot.x, y};
  bar.to_px = {sheet.plot.x + bar.length_m * px_per_m, y};
  return bar;
}

void draw_scale_bar(Canvas& canvas, const Sheet& sheet, const ScaleBar& bar) {
  const double u = sheet.unit_px;
  const double half = (bar.to_px.x() - bar.from_px.x()) / 2.0;
  const double thick = 9.0 * u;
  const RectPx whole{bar.from_px.x(), bar.from_px.y() - thick / 2.0, 2.0 * half, thick};
  canvas.fill(whole, palette::kInk);
  canvas.fill(RectPx{whole.x + half, whole.y + 2.0 * u, half - 2.0 * u, thick - 4.0 * u}, palette::kPaper);
  const std::string text = bar.length_m < 0.01  ? plain_number(bar.length_m * 1000.0) + " mm"
                           : bar.length_m < 1.0 ? plain_number(bar.length_m * 100.0) + " cm"
                                                : plain_number(bar.length_m) + " m";
  canvas.text({bar.to_px.x() + 14.0 * u, bar.to_px.y()}, text, {kTextSize * u, palette::kInk, false});
}

void draw_north(Canvas& canvas, const Sheet& sheet, const Vec2& toward_px) {
  const double u = sheet.unit_px;
  const Vec2 along = toward_px.normalized();
  const Vec2 aside{-along.y(), along.x()};
  const Vec2 middle{sheet.plot.right() - 60.0 * u, sheet.plot.bottom() + 44.0 * u};
  const Vec2 tip = middle + 24.0 * u * along;
  const Vec2 tail = middle - 14.0 * u * along;
  const Vec2 notch = middle - 5.0 * u * along;
  canvas.fill(std::array{tip, Vec2(tail + 13.0 * u * aside), notch}, palette::kInk);
  canvas.fill(std::array{tip, Vec2(tail - 13.0 * u * aside), notch}, palette::kSoftInk);
  canvas.text(middle + Vec2{34.0 * u, 0.0}, "N", {kTextSize * u, palette::kInk, true});
}

std::string time_text(double t_s) {
  if (t_s < 120.0) {
    return fmt::format("{:.0f} s", t_s);
  }
  return t_s < 7200.0 ? fmt::format("{:.1f} min", t_s / 60.0) : fmt::format("{:.1f} h", t_s / 3600.0);
}

}  // namespace sensotwin::render
