// SPDX-License-Identifier: MIT
#include "twin/run/recovered_map.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::twin {
namespace {

constexpr double kResolution_m = 0.05;
/// Fine cells of the robot's floor grid in one cell of the map, along a side.
constexpr int kFine = 2;

GridCell cell_of(const robot::MappingMission& mission, int x, int y, double tile_m) {
  const robot::FloorGrid& floor = mission.navigator().floor();
  bool swept = false;
  for (int dy = 0; dy < kFine; ++dy) {
    for (int dx = 0; dx < kFine; ++dx) {
      const robot::FloorGrid::Cell fine{kFine * x + dx, kFine * y + dy};
      if (floor.occupied(fine)) {
        return GridCell::kOccupied;
      }
      swept = swept || floor.swept(fine);
    }
  }
  const robot::Tile tile{static_cast<int>(std::lround((x + 0.5) * kResolution_m / tile_m)),
                         static_cast<int>(std::lround((y + 0.5) * kResolution_m / tile_m))};
  return swept || mission.map().visited(tile) ? GridCell::kFree : GridCell::kUnknown;
}

}  // namespace

OccupancyGrid recovered_grid(const robot::MappingMission& mission, double tile_m) {
  robot::Tile low{0, 0};
  robot::Tile high{0, 0};
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
  grid.X_MG.p_m = kResolution_m * robot::Vec2{first_x, first_y};
  grid.cells.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      grid.cells.push_back(cell_of(mission, first_x + x, first_y + y, tile_m));
    }
  }
  return grid;
}

std::optional<MapPlacement> placement_of(const Scene& scene, const MappingTwin& twin) {
  const auto origin = twin.program().mission().map().tag_on({0, 0});
  if (!origin) {
    return std::nullopt;
  }
  for (const world::Tag& tag : twin.world().tags()) {
    if (tag.memory.uid == *origin && tag.place == world::TagPlace::kCarpet) {
      const long turns = std::lround(scene.robot.X_WR_start.yaw_rad / (robot::kPi / 2.0));
      return MapPlacement{{tag.column, tag.row}, static_cast<int>(turns & 3)};
    }
  }
  return std::nullopt;
}

robot::Tile tile_in_map(const MapPlacement& placement, int column, int row) {
  int x = column - placement.origin.first;
  int y = row - placement.origin.second;
  for (int i = 0; i < (placement.quarter_turns & 3); ++i) {
    const int turned_x = y;
    y = -x;
    x = turned_x;
  }
  return {x, y};
}

}  // namespace sensotwin::twin
