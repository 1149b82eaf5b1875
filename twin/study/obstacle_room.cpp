// SPDX-License-Identifier: MIT
#include "twin/study/obstacle_room.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace sensotwin::twin {
namespace {

using robot::Tile;

/// Logarithm of the widest aspect ratio (algorithms of section V, chosen because the paper's plane comes
/// out).
constexpr double kLogAspectMax = 0.8;

struct Chunk {
  int size{0};
  int width{0};
  [[nodiscard]] int height() const { return (size + width - 1) / width; }
  /// Cells of row `row`, the last of which may not be full.
  [[nodiscard]] int width_of(int row) const { return std::min(width, size - row * width); }
};

/// The room while it is being furnished: 1 = an obstacle may not lie here (obstacle, its rim, or the start).
class Furnishing {
 public:
  Furnishing() { closed_at({0, 0}) = true; }

  [[nodiscard]] bool fits(const Chunk& chunk, Tile corner) const {
    for (int row = 0; row < chunk.height(); ++row) {
      for (int column = 0; column < chunk.width_of(row); ++column) {
        if (closed_[index({corner.column + column, corner.row + row})]) return false;
      }
    }
    return true;
  }
  void place(const Chunk& chunk, Tile corner) {
    for (int row = 0; row < chunk.height(); ++row) {
      for (int column = 0; column < chunk.width_of(row); ++column) {
        const Tile tile{corner.column + column, corner.row + row};
        blocked_.push_back(tile);
        for (int dx = -1; dx <= 1; ++dx) {
          for (int dy = -1; dy <= 1; ++dy) closed_at({tile.column + dx, tile.row + dy}) = true;
        }
      }
    }
  }
  /// Everywhere it fits is equally likely; false when it fits nowhere.
  bool place_somewhere(const Chunk& chunk, robot::RandomStream& random) {
    std::array<Tile, kStudyRoomSide * kStudyRoomSide> places;
    std::uint32_t count = 0;
    for (int column = 0; column + chunk.width <= kStudyRoomSide; ++column) {
      for (int row = 0; row + chunk.height() <= kStudyRoomSide; ++row) {
        if (fits(chunk, {column, row})) places[count++] = {column, row};
      }
    }
    if (count == 0) return false;
    place(chunk, places[random.below(count)]);
    return true;
  }
  [[nodiscard]] const std::vector<Tile>& blocked() const { return blocked_; }

 private:
  // One more line of cells on every side spares the rim its checks.
  static constexpr int kSide = kStudyRoomSide + 2;
  [[nodiscard]] static std::size_t index(Tile t) {
    return static_cast<std::size_t>((t.row + 1) * kSide + t.column + 1);
  }
  [[nodiscard]] bool& closed_at(Tile t) { return closed_[index(t)]; }

  std::array<bool, static_cast<std::size_t>(kSide) * kSide> closed_{};
  std::vector<Tile> blocked_;
};

std::optional<Furnishing> try_to_furnish(const ObstacleCell& cell, robot::RandomStream& random) {
  const int tags = kStudyRoomSide * kStudyRoomSide;
  const int blocked = static_cast<int>(std::lround(tags * cell.blocked_percent / 100.0));
  Furnishing furnishing;
  for (int i = 0; i < cell.chunks; ++i) {
    Chunk chunk;
    chunk.size = blocked / cell.chunks + (i < blocked % cell.chunks ? 1 : 0);
    if (chunk.size == 0) continue;
    const double aspect = std::exp(random.uniform(-kLogAspectMax, kLogAspectMax));
    chunk.width = std::clamp(static_cast<int>(std::lround(std::sqrt(chunk.size * aspect))), 1,
                             std::min(chunk.size, kStudyRoomSide));
    if (!furnishing.place_somewhere(chunk, random)) return std::nullopt;
  }
  return furnishing;
}

}  // namespace

GridRoom obstacle_room(const ObstacleCell& cell, robot::RandomStream random) {
  assert(cell.blocked_percent >= 0 && cell.blocked_percent <= 30 && cell.chunks >= 1 && cell.chunks <= 16);
  // Where the room is too full for the last chunk, all are drawn again: correcting the last ones only would
  // make crowded rooms differ from what chance would make of them.
  auto furnishing = try_to_furnish(cell, random);
  while (!furnishing) furnishing = try_to_furnish(cell, random);
  GridRoom room{kStudyRoomSide, kStudyRoomSide};
  for (const Tile tile : furnishing->blocked()) room.block(tile);
  return room;
}

}  // namespace sensotwin::twin
