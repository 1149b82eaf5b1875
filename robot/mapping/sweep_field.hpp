// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// Tiles that some passage was found blocked to and none open. In a room of blocked tiles they are obstacles;
/// in one with walls between free tiles they may be reached from another side, and are worth trying when all
/// else is done.
enum class DoubtfulTiles : std::uint8_t { kLeftOut, kWanted };

[[nodiscard]] bool doubtful(const TileMap& map, Tile t);

/// The room as a plan presumes it: what is known, and the unknown taken for free floor.
///
/// The room's size is not known. Presumed is the rectangle round all tiles that are visited or that an open
/// passage leads to, and `tiles_beyond` more on each side where no wall or obstacle has been met; it grows as
/// tiles are found.
///
/// Cells are numbered row by row in a rectangle with a rim of absent cells, so that every neighbour has a
/// number.
class SweepField {
 public:
  using Cell = std::int32_t;

  explicit SweepField(int tiles_beyond) : tiles_beyond_(tiles_beyond) {}

  void build(const TileMap& map, DoubtfulTiles doubtful_tiles);

  [[nodiscard]] Cell cell(Tile t) const {
    return static_cast<Cell>((t.row - corner_.row) * stride_ + t.column - corner_.column);
  }
  [[nodiscard]] Tile tile(Cell c) const { return {corner_.column + c % stride_, corner_.row + c / stride_}; }
  [[nodiscard]] bool contains(Tile t) const { return presumed_.contains(t); }
  /// Number of the neighbour minus number of the cell.
  [[nodiscard]] Cell step(int side) const { return step_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] std::size_t size() const { return sides_.size(); }
  /// Bit s: the robot can drive through side s into a cell of this field, as far as is known.
  [[nodiscard]] const std::vector<std::uint8_t>& sides() const { return sides_; }
  /// 1 for cells that a plan has yet to visit.
  [[nodiscard]] const std::vector<std::uint8_t>& wanted() const { return wanted_; }
  [[nodiscard]] bool wanted_beyond(Cell c, int side) const {
    return (sides_[static_cast<std::size_t>(c)] >> side & 1) != 0 &&
           wanted_[static_cast<std::size_t>(c + step(side))] != 0;
  }
  [[nodiscard]] int wanted_count() const { return wanted_count_; }

 private:
  [[nodiscard]] TileBounds presumed_bounds(const TileMap& map) const;
  [[nodiscard]] TileBounds with_margin(const TileMap& map, const TileBounds& bounds) const;

  int tiles_beyond_;
  TileBounds presumed_{};
  Tile corner_{};
  Cell stride_{1};
  std::array<Cell, 4> step_{};
  std::vector<std::uint8_t> sides_;
  std::vector<std::uint8_t> wanted_;
  int wanted_count_{0};
};

}  // namespace sensotwin::robot
