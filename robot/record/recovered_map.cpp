// SPDX-License-Identifier: MIT
#include "robot/record/recovered_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

constexpr double kResolution_m = 0.05;
/// Fine cells of the robot's floor grid in one cell of the map, along a side.
constexpr int kFine = 2;

GridCell cell_of(const MappingMission& mission, int x, int y, double tile_m) {
  const FloorGrid& floor = mission.navigator().floor();
  bool swept = false;
  for (int dy = 0; dy < kFine; ++dy) {
    for (int dx = 0; dx < kFine; ++dx) {
      const FloorGrid::Cell fine{kFine * x + dx, kFine * y + dy};
      if (floor.occupied(fine)) {
        return GridCell::kOccupied;
      }
      swept = swept || floor.swept(fine);
    }
  }
  const Tile tile{static_cast<int>(std::lround((x + 0.5) * kResolution_m / tile_m)),
                  static_cast<int>(std::lround((y + 0.5) * kResolution_m / tile_m))};
  return swept || mission.map().visited(tile) ? GridCell::kFree : GridCell::kUnknown;
}

}  // namespace

OccupancyGrid recovered_grid(const MappingMission& mission, double tile_m) {
  Tile low{0, 0};
  Tile high{0, 0};
  for (const auto& [tile, tag] : mission.map().tiles()) {
    low = {std::min(low.column, tile.column), std::min(low.row, tile.row)};
    high = {std::max(high.column, tile.column), std::max(high.row, tile.row)};
  }
  // A tile beyond what was visited: room for the walls round it.
  const int first_x = static_cast<int>(std::floor((low.column - 1) * tile_m / kResolution_m));
  const int first_y = static_cast<int>(std::floor((low.row - 1) * tile_m / kResolution_m));
  OccupancyGrid grid;
  grid.resolution_m = kResolution_m;
  grid.width = static_cast<int>(std::ceil((high.column + 1) * tile_m / kResolution_m)) - first_x;
  grid.height = static_cast<int>(std::ceil((high.row + 1) * tile_m / kResolution_m)) - first_y;
  grid.X_MG.p_m = kResolution_m * Vec2{first_x, first_y};
  grid.cells.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      grid.cells.push_back(cell_of(mission, first_x + x, first_y + y, tile_m));
    }
  }
  return grid;
}

std::string tiles_csv(const TileMap& map) {
  std::string text = "column,row,state,tag\n";
  for (const auto& [tile, tag] : map.tiles()) {
    const char* const state = map.color(tile) == TileColor::kBlack ? "black" : "grey";
    text += fmt::format("{},{},{},{:016X}\n", tile.column, tile.row, state, tag);
  }
  return text;
}

void write_recovered_map(RunFolder& folder, const MappingMission& mission, double tile_m) {
  write_map(folder, recovered_grid(mission, tile_m));
  folder.write("tiles.csv", tiles_csv(mission.map()));
}

}  // namespace sensotwin::robot
