// SPDX-License-Identifier: MIT
#include "render/mapping_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace sensotwin::render {
namespace {

[[nodiscard]] std::string upper(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

struct PaperRun {
  std::string_view name;
  Rgba color;
  double minutes;
};
// SensoBot, section V: "The pink line represents BFM ... about 69 minutes"; green, DFM, 42; brown, IDFM, 26.
constexpr std::array kPaperRuns{PaperRun{"BFM", palette::kPink, 69.0}, PaperRun{"DFM", palette::kGreen, 42.0},
                                PaperRun{"IDFM", palette::kBrown, 26.0}};
constexpr double kPaperTags = 207.0;

[[nodiscard]] const PaperRun* paper_run(const std::string& name) {
  const auto* found = std::find_if(kPaperRuns.begin(), kPaperRuns.end(),
                                   [&](const PaperRun& run) { return run.name == upper(name); });
  return found == kPaperRuns.end() ? nullptr : found;
}

[[nodiscard]] Extent united(const std::vector<ProgressFrame>& frames) {
  Extent all = extent_of(frames.front().plan);
  for (const ProgressFrame& frame : frames) {
    const Extent one = extent_of(frame.plan);
    all.min_m = all.min_m.cwiseMin(one.min_m);
    all.max_m = all.max_m.cwiseMax(one.max_m);
  }
  return all;
}

/// All states that any frame shows, for one legend.
[[nodiscard]] std::vector<LegendItem> legend_of_all(const std::vector<ProgressFrame>& frames) {
  SceneView all;
  for (const ProgressFrame& frame : frames) {
    const SceneView& plan = frame.plan;
    all.tiles.insert(all.tiles.end(), plan.tiles.begin(), plan.tiles.end());
    all.walls.insert(all.walls.end(), plan.walls.begin(), plan.walls.end());
    all.furniture.insert(all.furniture.end(), plan.furniture.begin(), plan.furniture.end());
    all.robot = plan.robot ? plan.robot : all.robot;
    all.start = plan.start ? plan.start : all.start;
  }
  std::vector<LegendItem> items = legend_of(all, TileStyle::kStates);
  for (LegendItem& item : items) {
    // Counts of tiles added up over the times would mean nothing.
    item.text = item.text.substr(0, item.text.find(" ("));
  }
  return items;
}

struct SheetGrid {
  int columns{1};
  int rows{1};
  double unit_px{1.0};
  double cell_width_px{0.0};
  double plan_height_px{0.0};
  double cell_height_px{0.0};
  int height_px{0};
};

constexpr double kMargin = 48.0;
constexpr double kGap = 36.0;
constexpr double kCaption = 52.0;
constexpr double kTop = 132.0;
constexpr double kFoot = 84.0;

[[nodiscard]] SheetGrid grid_for(const ProgressSheet& sheet, const Extent& extent) {
  SheetGrid grid;
  const auto n = static_cast<int>(sheet.frames.size());
  grid.columns = std::min(n, 3);
  grid.rows = (n + grid.columns - 1) / grid.columns;
  grid.unit_px = sheet.width_px / 1600.0;
  const double u = grid.unit_px;
  grid.cell_width_px =
      std::floor((sheet.width_px - 2.0 * kMargin * u - (grid.columns - 1) * kGap * u) / grid.columns);
  const double aspect = std::clamp(extent.size_m().x() / extent.size_m().y(), 0.5, 3.0);
  grid.plan_height_px = std::floor(grid.cell_width_px / aspect);
  // A single tall plan must not make a picture of several screens.
  grid.plan_height_px = std::min(grid.plan_height_px, std::floor(0.8 * sheet.width_px));
  grid.cell_height_px = grid.plan_height_px + (kCaption + kGap) * u;
  grid.height_px = static_cast<int>(std::lround(grid.rows * grid.cell_height_px + (kTop + kFoot - kGap) * u));
  return grid;
}

/// The last frame's clock and count above each plan.
void draw_caption(Canvas& canvas, const ProgressFrame& frame, const Vec2& corner, double u) {
  const auto visited = std::count_if(
      frame.plan.tiles.begin(), frame.plan.tiles.end(),
      [](const TileView& tile) { return tile.state == TileState::kGrey || tile.state == TileState::kBlack; });
  const TextStyle bold{25.0 * u, palette::kInk, true};
  const std::string time = time_text(frame.t_s);
  canvas.text(corner, time, bold);
  canvas.text(corner + Vec2{canvas.width_of(time, bold) + 16.0 * u, 0.0}, fmt::format("{} tags", visited),
              {22.0 * u, palette::kSoftInk});
}

/// The legend in one row at the foot, right of the scale bar.
void draw_foot_legend(Canvas& canvas, const std::vector<LegendItem>& items, double left, double right,
                      double y, double u) {
  const TextStyle style{20.0 * u, palette::kInk};
  double x = left;
  for (const LegendItem& item : items) {
    if (item.swatch != LegendItem::Swatch::kTile) {
      continue;
    }
    const double width = canvas.width_of(item.text, style) + 72.0 * u;
    if (x + width > right) {
      break;
    }
    Sheet line;
    line.unit_px = u;
    line.width_px = static_cast<int>(right);
    line.legend = {x, y - 14.0 * u, width, 40.0 * u};
    draw_legend(canvas, line, SceneView{}, {item}, TileStyle::kStates);
    x += width;
  }
}

}  // namespace

Rgba explorer_color(const std::string& name, int ours_before) {
  if (const PaperRun* run = paper_run(name)) {
    return run->color;
  }
  static constexpr std::array kOurs{palette::kBlue, palette::kSky, palette::kOrange, palette::kPurple};
  return kOurs[static_cast<std::size_t>(std::max(0, ours_before)) % kOurs.size()];
}

LineChart tags_over_time_chart(const TagsOverTime& view) {
  LineChart chart;
  chart.frame.title = "Tags found over time";
  chart.frame.subtitle = fmt::format("{} · seed {}", view.scene, view.seed);
  if (!view.subtitle.empty()) {
    chart.frame.subtitle += " · " + view.subtitle;
  }
  chart.frame.x.label = "time (min)";
  chart.frame.y.label = "tags found";
  int ours = 0;
  double most = view.tags_total;
  for (const ExplorerRun& run : view.runs) {
    Series series;
    const bool known = paper_run(run.name) != nullptr;
    series.name = known ? upper(run.name) : run.name;
    series.color = explorer_color(run.name, ours);
    series.points = run.found;
    series.style = SeriesStyle::kStep;
    series.width_px = known ? 4.0 : 5.0;
    if (!run.found.empty()) {
      series.end_label = fmt::format("{:.1f} min", run.found.back().x);
      series.end_label_above = true;
    }
    for (const ChartPoint& p : run.found) {
      most = std::max(most, p.y);
    }
    ours += known ? 0 : 1;
    chart.series.push_back(std::move(series));
  }
  if (view.tags_total > 0) {
    chart.reference_lines.push_back({static_cast<double>(view.tags_total), false,
                                     fmt::format("{} tags", view.tags_total), palette::kSoftInk});
  }
  if (view.paper_marks) {
    chart.references_name = "paper";
    most = std::max(most, kPaperTags);
    for (const PaperRun& run : kPaperRuns) {
      chart.reference_points.push_back(
          {{run.minutes, kPaperTags}, run.color, fmt::format("{:.0f}", run.minutes)});
    }
  }
  if (most > 0.0 && std::isfinite(most)) {
    chart.frame.y.range = ChartRange{0.0, most * 1.2};
  }
  return chart;
}

Rendered<Picture> draw_progress_sheet(OffscreenContext& context, const ProgressSheet& sheet) {
  if (sheet.frames.empty() || sheet.frames.size() > 24) {
    return Unexpected{
        RenderError{RenderError::Kind::kBadView,
                    fmt::format("a progress sheet shows 1 to 24 plans, not {}", sheet.frames.size())}};
  }
  for (const ProgressFrame& frame : sheet.frames) {
    if (auto fault = first_fault(frame.plan)) {
      return Unexpected{*fault};
    }
  }
  const Extent extent = united(sheet.frames);
  const SheetGrid grid = grid_for(sheet, extent);
  if (auto fault = size_fault(sheet.width_px, grid.height_px)) {
    return Unexpected{*fault};
  }
  const double u = grid.unit_px;
  Canvas canvas = Canvas::pixels(sheet.width_px, grid.height_px);
  Sheet paper;
  paper.width_px = sheet.width_px;
  paper.height_px = grid.height_px;
  paper.unit_px = u;
  SceneView heading;
  heading.title = sheet.title;
  heading.subtitle = sheet.subtitle;
  heading.scene = sheet.scene;
  heading.seed = sheet.seed;
  draw_heading(canvas, paper, heading);

  Picture picture;
  for (std::size_t i = 0; i < sheet.frames.size(); ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(grid.columns));
    const std::size_t rows_above = i / static_cast<std::size_t>(grid.columns);
    const auto row = static_cast<double>(rows_above);
    const Vec2 corner{std::round(kMargin * u + column * (grid.cell_width_px + kGap * u)),
                      std::round(kTop * u + row * grid.cell_height_px)};
    draw_caption(canvas, sheet.frames[i], corner + Vec2{0.0, 20.0 * u}, u);
    auto plan = draw_plan(context, sheet.frames[i].plan, extent, static_cast<int>(grid.cell_width_px),
                          static_cast<int>(grid.plan_height_px), 0.6 * u, TileStyle::kStates);
    if (!plan) {
      return plan;
    }
    const Vec2 at = corner + Vec2{0.0, std::round(kCaption * u)};
    canvas.image(plan->image, at);
    // The last plan tells tests and readers where things are.
    picture.pixel_from_W = plan->pixel_from_W.scaled_and_moved(1.0, at);
    picture.plot = {at.x(), at.y(), grid.cell_width_px, grid.plan_height_px};
  }
  paper.plot = {kMargin * u, kTop * u, grid.cell_width_px, grid.height_px - (kTop + kFoot) * u};
  picture.scale_bar = scale_bar_for(paper, picture.pixel_from_W.px_per_m(Vec3::Zero()));
  draw_scale_bar(canvas, paper, picture.scale_bar);
  draw_foot_legend(canvas, legend_of_all(sheet.frames), kMargin * u + grid.cell_width_px + kGap * u,
                   sheet.width_px - 24.0 * u, picture.scale_bar.from_px.y(), u);
  auto image = canvas.take_image();
  if (!image) {
    return Unexpected{image.error()};
  }
  picture.image = std::move(*image);
  return picture;
}

Rendered<Picture> draw_recovered_plan(OffscreenContext& context, const SceneView& view, int width_px) {
  PictureOptions options;
  options.width_px = width_px;
  options.tiles = TileStyle::kRecovered;
  return draw_top_view(context, view, options);
}

}  // namespace sensotwin::render
