// SPDX-License-Identifier: MIT
#include "twin/study/grid_room.hpp"

#include <algorithm>
#include <cassert>

namespace sensotwin::twin {

using robot::Direction;
using robot::Tile;

GridRoom::GridRoom(int columns, int rows)
    : bounds_{{0, 0}, {columns - 1, rows - 1}}, cells_(bounds_, Cell{.free = true}) {
  assert(columns > 0 && rows > 0);
  // Outside the room nothing is free: the grid of cells above was filled with what lies inside.
  robot::TileGrid<Cell> inside{bounds_, Cell{}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) inside.ref({column, row}).free = true;
  }
  cells_ = inside;
}

GridRoom GridRoom::from_picture(std::string_view picture) {
  std::vector<std::string_view> lines;
  while (!picture.empty()) {
    const std::size_t end = std::min(picture.find('\n'), picture.size());
    if (end > 0) lines.push_back(picture.substr(0, end));
    picture.remove_prefix(std::min(end + 1, picture.size()));
  }
  assert(!lines.empty());
  std::size_t width = 0;
  for (const auto line : lines) width = std::max(width, line.size());
  GridRoom room{static_cast<int>(width), static_cast<int>(lines.size())};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int row = static_cast<int>(lines.size() - 1 - i);
    for (std::size_t column = 0; column < width; ++column) {
      const Tile tile{static_cast<int>(column), row};
      const char c = column < lines[i].size() ? lines[i][column] : '#';
      if (c == '#') room.block(tile);
      if (c == 'S') room.start_ = tile;
    }
  }
  return room;
}

void GridRoom::build_wall(Tile tile, Direction side) {
  const auto wall_of = [this](Tile t, Direction s) -> bool& {
    return cells_.ref(t).walls[static_cast<std::size_t>(s)];
  };
  wall_of(tile, side) = true;
  wall_of(neighbour(tile, side), opposite(side)) = true;
}

std::vector<Tile> GridRoom::reachable() const {
  std::vector<Tile> found;
  if (!free(start_)) return found;
  robot::TileGrid<bool> seen{bounds_, false};
  seen.ref(start_) = true;
  found.push_back(start_);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Tile tile = found[i];
    for (const Direction side : robot::kDirections) {
      const Tile next = neighbour(tile, side);
      if (!open(tile, side) || seen.at(next)) continue;
      seen.ref(next) = true;
      found.push_back(next);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string GridRoom::picture() const {
  std::string text;
  for (int row = bounds_.max.row; row >= bounds_.min.row; --row) {
    for (int column = bounds_.min.column; column <= bounds_.max.column; ++column) {
      const Tile tile{column, row};
      text += tile == start_ ? 'S' : free(tile) ? '.' : '#';
    }
    text += '\n';
  }
  return text;
}

}  // namespace sensotwin::twin
