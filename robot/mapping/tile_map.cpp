// SPDX-License-Identifier: MIT
#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

bool TileMap::mark_visited(Tile tile, TagUid tag) {
  const auto known_tile = tile_by_tag_.find(tag);
  if (known_tile != tile_by_tag_.end()) return known_tile->second == tile;
  if (!tag_by_tile_.emplace(tile, tag).second) return false;
  tile_by_tag_.emplace(tag, tile);
  Cell& cell = cells_.ref(tile);
  cell.visited = true;
  cell.unreachable = false;  // the antenna is over it: whoever gave it up was wrong
  visited_bounds_ = visited_bounds_.including(tile);
  return true;
}

void TileMap::mark_passage(Tile tile, Direction side, Passage passage) {
  cells_.ref(tile).passages[static_cast<std::size_t>(side)] = passage;
  cells_.ref(neighbour(tile, side)).passages[static_cast<std::size_t>(opposite(side))] = passage;
}

void TileMap::mark_unreachable(Tile tile) {
  if (!visited(tile)) cells_.ref(tile).unreachable = true;
}

void TileMap::reconsider(Tile tile) {
  if (unreachable(tile)) cells_.ref(tile).unreachable = false;
}

TileColor TileMap::color(Tile tile) const {
  if (!visited(tile)) return TileColor::kWhite;
  for (const Direction side : kDirections) {
    if (untried(tile, side)) return TileColor::kGrey;
  }
  return TileColor::kBlack;
}

std::optional<TagUid> TileMap::tag_on(Tile tile) const {
  const auto found = tag_by_tile_.find(tile);
  if (found == tag_by_tile_.end()) return std::nullopt;
  return found->second;
}

std::optional<Tile> TileMap::tile_of(TagUid tag) const {
  const auto found = tile_by_tag_.find(tag);
  if (found == tile_by_tag_.end()) return std::nullopt;
  return found->second;
}

}  // namespace sensotwin::robot
