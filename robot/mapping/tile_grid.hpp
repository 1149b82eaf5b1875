// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "robot/mapping/tile.hpp"

namespace sensotwin::robot {

/// A rectangle of tiles, corners included; empty when max lies before min.
struct TileBounds {
  Tile min{0, 0};
  Tile max{-1, -1};

  [[nodiscard]] constexpr bool empty() const { return max.column < min.column || max.row < min.row; }
  [[nodiscard]] constexpr int columns() const { return max.column - min.column + 1; }
  [[nodiscard]] constexpr int rows() const { return max.row - min.row + 1; }
  [[nodiscard]] constexpr bool contains(Tile t) const {
    return t.column >= min.column && t.column <= max.column && t.row >= min.row && t.row <= max.row;
  }
  [[nodiscard]] constexpr TileBounds including(Tile t) const {
    if (empty()) return {t, t};
    return {{std::min(min.column, t.column), std::min(min.row, t.row)},
            {std::max(max.column, t.column), std::max(max.row, t.row)}};
  }
  [[nodiscard]] constexpr TileBounds grown(int tiles) const {
    return {{min.column - tiles, min.row - tiles}, {max.column + tiles, max.row + tiles}};
  }
  constexpr bool operator==(const TileBounds&) const = default;
};

/// One value for each tile of the plane: a dense rectangle that grows by itself, and a default value outside
/// it.
template <class T>
class TileGrid {
 public:
  explicit TileGrid(T outside = T{}) : outside_(std::move(outside)) {}
  TileGrid(const TileBounds& bounds, T outside)
      : bounds_(bounds),
        cells_(bounds.empty() ? 0 : area(bounds), Cell{outside}),
        outside_(std::move(outside)) {}

  [[nodiscard]] const T& at(Tile t) const { return bounds_.contains(t) ? cells_[index(t)].value : outside_; }
  /// Valid until the next ref(). The rectangle is made larger when it does not hold `t` yet.
  [[nodiscard]] T& ref(Tile t) {
    if (!bounds_.contains(t)) grow(t);
    return cells_[index(t)].value;
  }
  [[nodiscard]] const TileBounds& bounds() const { return bounds_; }

 private:
  struct Cell {
    T value;  // wrapped, since std::vector<bool> hands out no references
  };

  [[nodiscard]] static std::size_t area(const TileBounds& b) {
    return static_cast<std::size_t>(b.columns()) * static_cast<std::size_t>(b.rows());
  }
  [[nodiscard]] std::size_t index(Tile t) const {
    return static_cast<std::size_t>(t.row - bounds_.min.row) * static_cast<std::size_t>(bounds_.columns()) +
           static_cast<std::size_t>(t.column - bounds_.min.column);
  }
  void grow(Tile t) {
    // Eight tiles of margin (a room's side has some twenty) so that a drive outwards copies the grid seldom.
    TileGrid larger{bounds_.including(t).grown(8), outside_};
    for (int row = bounds_.min.row; row <= bounds_.max.row; ++row) {
      for (int column = bounds_.min.column; column <= bounds_.max.column; ++column) {
        larger.cells_[larger.index({column, row})] = std::move(cells_[index({column, row})]);
      }
    }
    *this = std::move(larger);
  }

  TileBounds bounds_{};
  std::vector<Cell> cells_;
  T outside_;
};

}  // namespace sensotwin::robot
