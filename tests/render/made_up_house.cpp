// SPDX-License-Identifier: MIT
#include "made_up_house.hpp"

#include <algorithm>
#include <cmath>

#include "robot/base/random.hpp"

namespace sensotwin::render::testing {
namespace {

constexpr double kTile_m = 0.508;
constexpr double kBorder_m = 0.09;
constexpr double kMinutes = 26.0;

struct Cell {
  int column;
  int row;
};

/// 17 x 9 living room and 9 x 6 dining room above its left part: 153 + 54 = 207 tiles.
[[nodiscard]] bool in_house(const Cell& c) {
  return (c.row >= 0 && c.row < 9 && c.column >= 0 && c.column < 17) ||
         (c.row >= 9 && c.row < 15 && c.column >= 0 && c.column < 9);
}

[[nodiscard]] Vec2 center_of(const Cell& c) {
  return {kBorder_m + kTile_m * (c.column + 0.5), kBorder_m + kTile_m * (c.row + 0.5)};
}

[[nodiscard]] Polygon box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

[[nodiscard]] std::vector<FurnitureView> furniture() {
  const double t = kTile_m;
  const double o = kBorder_m;
  FurnitureView sofa{
      "sofa", FurnitureKind::kSolid, box(o + 12.1 * t, o + 1.1 * t, 1.8 * t, 3.8 * t), {}, 0.72, 0.0};
  FurnitureView bookcase{
      "bookcase", FurnitureKind::kSolid, box(o + 5.05 * t, o + 8.1 * t - 3.0 * t, 3.9 * t, 0.8 * t), {}, 1.6,
      0.0};
  FurnitureView table{
      "dining table", FurnitureKind::kLegs, box(o + 2.0 * t, o + 10.5 * t, 4.0 * t, 2.0 * t), {}, 0.74, 0.0};
  for (const Vec2& leg : box(o + 2.2 * t, o + 10.7 * t, 3.6 * t, 1.6 * t)) {
    table.circles.push_back({leg, 0.03});
  }
  return {sofa, bookcase, table};
}

[[nodiscard]] bool covered(const Cell& c, const std::vector<FurnitureView>& pieces) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const FurnitureView& piece) {
    return piece.kind == FurnitureKind::kSolid && inside(piece.outline_m, center_of(c));
  });
}

/// Up and down the columns, round what is covered.
[[nodiscard]] std::vector<Cell> serpentine(const std::vector<FurnitureView>& pieces) {
  std::vector<Cell> cells;
  for (int column = 0; column < 17; ++column) {
    for (int k = 0; k < 15; ++k) {
      const Cell cell{column, column % 2 == 0 ? k : 14 - k};
      if (in_house(cell) && !covered(cell, pieces)) {
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

}  // namespace

SceneView made_up_house(double progress) {
  SceneView view;
  view.title = "Made-up house mapped by IDFM";
  view.subtitle = "207 tiles";
  view.scene = "made-up-house";
  view.seed = 7;
  const double w = 17 * kTile_m + 2 * kBorder_m;
  const double h = 9 * kTile_m + 2 * kBorder_m;
  const double inner_w = 9 * kTile_m + 2 * kBorder_m;
  const double top = 15 * kTile_m + 2 * kBorder_m;
  view.walls.push_back({{{0, 0}, {w, 0}, {w, h}, {inner_w, h}, {inner_w, top}, {0, top}}, true});
  view.walls.push_back({{{0, h - 0.09}, {3 * kTile_m, h - 0.09}}, false});
  view.furniture = furniture();
  const std::vector<Cell> path = serpentine(view.furniture);
  const auto driven = static_cast<std::size_t>(std::lround(progress * static_cast<double>(path.size())));
  robot::RandomStream wobble = robot::RandomStream{7}.fork("wobble");
  for (std::size_t i = 0; i < driven; ++i) {
    const Vec2 aim = center_of(path[i]) + Vec2{wobble.normal(0.0, 0.02), wobble.normal(0.0, 0.02)};
    const Vec2 from = view.trajectory.empty() ? aim : view.trajectory.back().p_m;
    for (int k = 1; k <= 10; ++k) {
      const double t_s =
          60.0 * kMinutes * (static_cast<double>(i) + k / 10.0) / static_cast<double>(path.size());
      view.trajectory.push_back({from + (aim - from) * (k / 10.0), t_s});
    }
  }
  view.time_end_s = 60.0 * kMinutes;
  for (int row = 0; row < 15; ++row) {
    for (int column = 0; column < 17; ++column) {
      const Cell cell{column, row};
      if (!in_house(cell)) {
        continue;
      }
      const auto at = static_cast<std::size_t>(
          std::find_if(path.begin(), path.end(),
                       [&](const Cell& c) { return c.column == column && c.row == row; }) -
          path.begin());
      TileState state = TileState::kUnvisited;
      if (covered(cell, view.furniture)) {
        state = progress > 0.0 ? TileState::kBlocked : TileState::kUnvisited;
      } else if (at < driven) {
        state = at + 15 < driven || driven == path.size() ? TileState::kBlack : TileState::kGrey;
      }
      view.tiles.push_back({center_of(cell), kTile_m, 0.0, state, ""});
    }
  }
  view.start = Pose2{center_of(path.front()), robot::kPi / 2};
  if (!view.trajectory.empty()) {
    view.robot = RobotView{{view.trajectory.back().p_m, -0.6}, 0.17, 0.092};
  }
  return view;
}

SceneView house_with_everything() {
  SceneView view = made_up_house(0.8);
  view.title = "Everything a picture can show";
  view.subtitle = "one of each mark";
  view.furniture.push_back({"sideboard", FurnitureKind::kRaised, box(0.15, 1.2, 0.45, 1.9), {}, 0.8, 0.12});
  view.furniture.push_back({"", FurnitureKind::kSolid, {}, {{{4.2, 7.2}, 0.22}}, 0.5, 0.0});
  view.tiles[20].state = TileState::kUnreachable;
  view.tiles[21].state = TileState::kUnreachable;
  view.tiles[57].state = TileState::kMissed;
  view.tiles[95].state = TileState::kWrong;
  view.tiles[16].label = "16";
  for (const TileView& tile : view.tiles) {
    view.tags.push_back({tile.center_m, false});
  }
  view.tags[58].dead = true;
  view.landmarks = {{{4.71, 7.0}, "window left"}, {{0.0, 6.5}, "power outlet"}, {{8.82, 3.9}, "front door"}};
  view.cliffs_m.push_back(box(7.8, 0.1, 0.9, 0.6));
  view.virtual_walls.push_back({{{8.7, 2.5}, robot::kPi}, 1.2, 0.15});
  view.home_base = Pose2{{0.1, 3.9}, 0.0};
  view.ceiling_tags = {{{1.5, 1.5}, 3.0, "A"}, {{5.5, 3.2}, 2.8, "B"}, {{2.2, 6.4}, 3.0, "C"}};
  view.north_yaw_rad = 1.2;
  return view;
}

TagsOverTime made_up_runs() {
  TagsOverTime view;
  view.scene = "made-up-house";
  view.seed = 7;
  view.subtitle = "made-up numbers";
  view.tags_total = 207;
  view.paper_marks = true;
  for (const auto& [name, minutes, bend] : {std::tuple{"bfm", 70.2, 1.25}, std::tuple{"dfm", 38.7, 0.9},
                                            std::tuple{"idfm", 28.5, 1.0}, std::tuple{"sweep", 22.1, 1.0}}) {
    ExplorerRun run{name, {}};
    for (int k = 1; k <= 207; ++k) {
      run.found.push_back({minutes * std::pow(k / 207.0, bend), static_cast<double>(k)});
    }
    view.runs.push_back(std::move(run));
  }
  return view;
}

}  // namespace sensotwin::render::testing
