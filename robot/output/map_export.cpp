// SPDX-License-Identifier: MIT
#include "robot/output/map_export.hpp"

#include <fmt/format.h>

#include <cassert>

namespace sensotwin::robot {
namespace {

char pixel_of(GridCell cell) {
  switch (cell) {
    case GridCell::kFree:
      return static_cast<char>(254);
    case GridCell::kOccupied:
      return 0;
    case GridCell::kUnknown:
      break;
  }
  return static_cast<char>(205);
}

}  // namespace

std::string pgm_text(const OccupancyGrid& grid) {
  assert(grid.width > 0 && grid.height > 0);
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  assert(grid.cells.size() == width * height);
  std::string text = fmt::format("P5\n{} {}\n255\n", width, height);
  text.reserve(text.size() + width * height);
  for (std::size_t row = height; row-- > 0;) {
    for (std::size_t column = 0; column < width; ++column) {
      text += pixel_of(grid.cells[row * width + column]);
    }
  }
  return text;
}

std::string map_yaml_text(const OccupancyGrid& grid, std::string_view image) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {:.6f}\norigin: [{:.6f}, {:.6f}, {:.6f}]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
      image, grid.resolution_m, grid.X_MG.p_m.x(), grid.X_MG.p_m.y(), grid.X_MG.yaw_rad);
}

void write_map(RunFolder& folder, const OccupancyGrid& grid) {
  folder.write("map.pgm", pgm_text(grid));
  folder.write("map.yaml", map_yaml_text(grid, "map.pgm"));
}

}  // namespace sensotwin::robot
