// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/output/run_folder.hpp"

namespace sensotwin::robot {

enum class GridCell : std::uint8_t { kFree, kOccupied, kUnknown };

/// A map as ROS knows it. `cells` are in rows from y lowest to y highest, each from x lowest to x highest
/// (nav_msgs/OccupancyGrid). \pre cells.size() == width * height, all above zero
struct OccupancyGrid {
  int width{0};
  int height{0};
  double resolution_m{0.05};  ///< side of a cell
  Pose2 X_MG;                 ///< lower left corner of cell (0, 0) in the map's frame
  std::vector<GridCell> cells;
};

/// Binary PGM (P5), first line of pixels = highest y; free 254, occupied 0, unknown 205, as map_saver writes.
[[nodiscard]] std::string pgm_text(const OccupancyGrid& grid);

/// The YAML beside it. `image` is relative to the YAML file. Thresholds are map_saver's (0.65, 0.196): 205 is
/// (255 - 205) / 255 = 0.1961 and so stays unknown under the trinary rule.
[[nodiscard]] std::string map_yaml_text(const OccupancyGrid& grid, std::string_view image);

/// map.pgm and map.yaml, in this order: a reader that finds the YAML finds the image. \throws OutputError
void write_map(RunFolder& folder, const OccupancyGrid& grid);

}  // namespace sensotwin::robot
