// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "robot/base/tag_uid.hpp"
#include "robot/mapping/tile.hpp"
#include "robot/mapping/tile_grid.hpp"

namespace sensotwin::robot {

/// The colours of SensoBot, section IV: white = not visited; grey = visited, some neighbour still open;
/// black = visited, all neighbours visited or closed off.
enum class TileColor : std::uint8_t { kWhite, kGrey, kBlack };

/// Whether the robot can drive straight from the middle of a tile to the middle of its neighbour.
enum class Passage : std::uint8_t { kUnknown, kOpen, kBlocked };

/// What the robot knows of the carpet: which tiles it has been on, which tag each holds, which passages
/// between neighbours are open or blocked, and which tiles it has given up on. Iteration is in (column, row)
/// order.
class TileMap {
 public:
  /// The robot's antenna read `tag` on `tile`. \returns false, changing nothing, when that tag is known on
  /// another tile or that tile holds another tag: the caller is not where it thinks it is.
  bool mark_visited(Tile tile, TagUid tag);
  /// A passage belongs to both its tiles: `side` of `tile` is the opposite side of that neighbour.
  void mark_passage(Tile tile, Direction side, Passage passage);
  /// Given up: no way for the robot's antenna to this tile (or no tag there).
  void mark_unreachable(Tile tile);
  /// Takes that back: something new is known beside it.
  void reconsider(Tile tile);

  [[nodiscard]] bool visited(Tile tile) const { return cells_.at(tile).visited; }
  [[nodiscard]] bool unreachable(Tile tile) const { return cells_.at(tile).unreachable; }
  [[nodiscard]] Passage passage(Tile tile, Direction side) const {
    return cells_.at(tile).passages[static_cast<std::size_t>(side)];
  }
  /// A straight move through `side` of `tile` may find a new tag: not blocked, and the neighbour is neither
  /// visited nor given up.
  [[nodiscard]] bool untried(Tile tile, Direction side) const {
    return passage(tile, side) != Passage::kBlocked && !visited(neighbour(tile, side)) &&
           !unreachable(neighbour(tile, side));
  }
  [[nodiscard]] TileColor color(Tile tile) const;
  [[nodiscard]] std::optional<TagUid> tag_on(Tile tile) const;
  [[nodiscard]] std::optional<Tile> tile_of(TagUid tag) const;
  [[nodiscard]] std::size_t visited_count() const { return tag_by_tile_.size(); }
  /// Visited tiles with their tags.
  [[nodiscard]] const std::map<Tile, TagUid>& tiles() const { return tag_by_tile_; }
  /// The rectangle round all visited tiles; empty before the first.
  [[nodiscard]] const TileBounds& visited_bounds() const { return visited_bounds_; }

 private:
  struct Cell {
    bool visited{false};
    bool unreachable{false};
    std::array<Passage, 4> passages{};
  };

  TileGrid<Cell> cells_;
  TileBounds visited_bounds_{};
  std::map<Tile, TagUid> tag_by_tile_;
  std::map<TagUid, Tile> tile_by_tag_;
};

}  // namespace sensotwin::robot
