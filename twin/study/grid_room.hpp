// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "robot/mapping/tile.hpp"
#include "robot/mapping/tile_grid.hpp"

namespace sensotwin::twin {

/// A room of the grid model (SensoBot, section V): tags that are free or blocked, and walls between them.
/// Tile (0, 0) is the south-west corner of the picture.
class GridRoom {
 public:
  GridRoom(int columns, int rows);
  /// Rows from north to south as lines; '#' is blocked, 'S' is where the robot starts, all else is free.
  /// Short lines are filled with blocked tags.
  [[nodiscard]] static GridRoom from_picture(std::string_view picture);

  void block(robot::Tile tile) { cells_.ref(tile).free = false; }
  void set_free(robot::Tile tile) { cells_.ref(tile).free = true; }
  /// A wall on the edge of two tags, both of which may be free.
  void build_wall(robot::Tile tile, robot::Direction side);
  void set_start(robot::Tile tile) { start_ = tile; }

  [[nodiscard]] bool free(robot::Tile tile) const { return cells_.at(tile).free; }
  /// A straight drive from `tile` through `side` gets through.
  [[nodiscard]] bool open(robot::Tile tile, robot::Direction side) const {
    return free(robot::neighbour(tile, side)) && !cells_.at(tile).walls[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] robot::Tile start() const { return start_; }
  [[nodiscard]] const robot::TileBounds& bounds() const { return bounds_; }
  /// Tags connected to the start by straight drives, in (column, row) order; the paper's V is their number.
  [[nodiscard]] std::vector<robot::Tile> reachable() const;
  [[nodiscard]] std::string picture() const;

 private:
  struct Cell {
    bool free{false};
    std::array<bool, 4> walls{};
  };
  robot::TileBounds bounds_;
  robot::TileGrid<Cell> cells_;
  robot::Tile start_{0, 0};
};

}  // namespace sensotwin::twin
