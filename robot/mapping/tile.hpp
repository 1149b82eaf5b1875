// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace sensotwin::robot {

/// A tile of the robot's own map: column along +x, row along +y of M, the first tag found is (0, 0).
struct Tile {
  int column{0};
  int row{0};
  auto operator<=>(const Tile&) const = default;
};

/// A side of a tile, counter-clockwise from +x of M, so that yaw = direction * 90 degrees.
enum class Direction : std::uint8_t { kEast, kNorth, kWest, kSouth };

inline constexpr std::array<Direction, 4> kDirections{Direction::kEast, Direction::kNorth, Direction::kWest,
                                                      Direction::kSouth};

[[nodiscard]] constexpr Direction turned(Direction d, int quarter_turns_left) {
  return static_cast<Direction>((static_cast<int>(d) + quarter_turns_left) & 3);
}
[[nodiscard]] constexpr Direction opposite(Direction d) {
  return turned(d, 2);
}
/// Quarter turns on the spot from one heading to another, the shorter way: 0, 1 or 2.
[[nodiscard]] constexpr int quarter_turns(Direction from, Direction to) {
  const int left = (static_cast<int>(to) - static_cast<int>(from)) & 3;
  return left == 3 ? 1 : left;
}
[[nodiscard]] constexpr Tile neighbour(Tile t, Direction d) {
  switch (d) {
    case Direction::kEast:
      return {t.column + 1, t.row};
    case Direction::kNorth:
      return {t.column, t.row + 1};
    case Direction::kWest:
      return {t.column - 1, t.row};
    case Direction::kSouth:
      break;
  }
  return {t.column, t.row - 1};
}

/// The side of `from` that it shares with `to`. \pre the two are neighbours
[[nodiscard]] constexpr Direction direction_between(Tile from, Tile to) {
  for (const Direction d : kDirections) {
    if (neighbour(from, d) == to) {
      return d;
    }
  }
  return Direction::kEast;
}

}  // namespace sensotwin::robot
