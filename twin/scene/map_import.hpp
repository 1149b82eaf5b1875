// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/config/problem.hpp"
#include "world/description.hpp"

namespace sensotwin::twin {

enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// A ROS map_server map: square cells in a frame O whose origin is the lower left corner of the picture.
struct OccupancyMap {
  int columns{0};
  int rows{0};
  double resolution_m{0.05};  ///< side of a cell
  robot::Pose2 X_WO;          ///< `origin:` of the map, yaw included
  std::vector<Cell> cells;    ///< row by row from the BOTTOM of the picture

  /// What lies beyond the picture is unknown.
  [[nodiscard]] Cell at(int column, int row) const;
  /// The cell that a point of the world lies in.
  [[nodiscard]] Cell at(const robot::Vec2& p_W) const;
  [[nodiscard]] std::size_t count(Cell kind) const;
};

/// Reads `map_yaml` and the picture it names (PGM P2 or P5, PNG of any kind).
///
/// Grey = mean of red, green and blue, scaled to 0..255; p = (255 - grey) / 255, or grey / 255 when `negate`;
/// p > occupied_thresh is occupied, p < free_thresh free, else unknown (map_server, mode trinary; mode scale
/// grades what lies between, which is no clear floor either and so unknown here; mode raw is refused). A
/// pixel more than half transparent is unknown: nothing was drawn there. \throws SceneError  kExitMissing
/// when a file is not there, kExitInvalid for everything else
[[nodiscard]] OccupancyMap read_map(const std::filesystem::path& map_yaml);

/// The border of free space as closed walls in the world, free space on the left: neighbouring cell sides
/// merged into straight runs, corners only where it bends. Nothing is smoothed and no speck is dropped.
[[nodiscard]] std::vector<world::Wall> outline(const OccupancyMap& map);

/// Figures for a report.
struct MapCounts {
  double free_m2{0.0};
  std::size_t occupied_cells{0};
  std::size_t unknown_cells{0};
  std::size_t outlines{0};
  std::size_t segments{0};
};
[[nodiscard]] MapCounts counts(const OccupancyMap& map, const std::vector<world::Wall>& walls);

}  // namespace sensotwin::twin
