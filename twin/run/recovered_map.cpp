// SPDX-License-Identifier: MIT
#include "twin/run/recovered_map.hpp"

#include <cmath>

namespace sensotwin::twin {
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
