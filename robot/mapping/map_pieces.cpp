// SPDX-License-Identifier: MIT
#include "robot/mapping/map_pieces.hpp"

#include <cassert>
#include <utility>

namespace sensotwin::robot {
namespace {

Tile rotated(Tile t, int quarter_turns_left) {
  switch (quarter_turns_left & 3) {
    case 1:
      return {-t.row, t.column};
    case 2:
      return {-t.column, -t.row};
    case 3:
      return {t.row, -t.column};
    default:
      return t;
  }
}

}  // namespace

Tile TileTransform::operator()(Tile t) const {
  const Tile r = rotated(t, quarter_turns_left);
  return {r.column + shift.column, r.row + shift.row};
}

TileTransform TileTransform::matching(int quarter_turns_left, Tile from, Tile to) {
  const Tile r = rotated(from, quarter_turns_left);
  return {quarter_turns_left & 3, {to.column - r.column, to.row - r.row}};
}

TileTransform TileTransform::inverse() const {
  const int back = (4 - quarter_turns_left) & 3;
  const Tile r = rotated(shift, back);
  return {back, {-r.column, -r.row}};
}

MapPieces::MapPieces(TileMap old_piece, bool compass_trusted)
    : old_(std::move(old_piece)), compass_trusted_(compass_trusted) {}

MapPieces::State MapPieces::update(const TileMap& new_piece) {
  candidates_.clear();
  bool common = false;
  for (const auto& [tile, tag] : new_piece.tiles()) {
    const auto old_tile = old_.tile_of(tag);
    if (!old_tile) continue;
    common = true;
    for (int turns = 0; turns < (compass_trusted_ ? 1 : 4); ++turns) {
      const auto to_old = TileTransform::matching(turns, tile, *old_tile);
      if (consistent(new_piece, to_old)) candidates_.push_back(to_old);
    }
    break;  // consistent() holds every other common tag against these four
  }
  if (!common) return state_ = State::kNoCommonTag;
  if (candidates_.empty()) return state_ = State::kContradiction;
  return state_ = candidates_.size() == 1 ? State::kCommitted : State::kAmbiguous;
}

bool MapPieces::consistent(const TileMap& new_piece, const TileTransform& to_old) const {
  for (const auto& [tile, tag] : new_piece.tiles()) {
    const Tile there = to_old(tile);
    const auto old_tag = old_.tag_on(there);
    if (old_tag && *old_tag != tag) return false;
    const auto old_tile = old_.tile_of(tag);
    if (old_tile && *old_tile != there) return false;
    for (const Direction side : kDirections) {
      const Passage now = new_piece.passage(tile, side);
      const Passage then = old_.passage(there, to_old(side));
      if ((now == Passage::kOpen && then == Passage::kBlocked) ||
          (now == Passage::kBlocked && then == Passage::kOpen)) {
        return false;
      }
    }
  }
  return true;
}

std::optional<Direction> MapPieces::probe(const TileMap& new_piece, Tile at) const {
  if (state_ != State::kAmbiguous) return std::nullopt;
  std::optional<Direction> best;
  std::size_t best_expected = 0;
  for (const Direction side : kDirections) {
    if (!new_piece.untried(at, side)) continue;
    // A tag read there keeps the candidates that expect this tag, and drops those that expect another.
    std::size_t expected = 0;
    for (const TileTransform& to_old : candidates_)
      expected += old_.visited(to_old(neighbour(at, side))) ? 1u : 0u;
    if (expected > best_expected) {
      best_expected = expected;
      best = side;
    }
  }
  return best;
}

TileMap MapPieces::merged(const TileMap& new_piece) const {
  assert(state_ == State::kCommitted);
  const TileTransform& to_old = candidates_.front();
  TileMap whole = old_;
  for (const auto& [tile, tag] : new_piece.tiles()) {
    [[maybe_unused]] const bool marked = whole.mark_visited(to_old(tile), tag);
    assert(marked);
    for (const Direction side : kDirections) {
      const Passage passage = new_piece.passage(tile, side);
      if (passage != Passage::kUnknown) whole.mark_passage(to_old(tile), to_old(side), passage);
    }
  }
  // Given up in the new piece: at most a ring round what it visited.
  for (const auto& [tile, tag] : new_piece.tiles()) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const Tile near{tile.column + dx, tile.row + dy};
        if (new_piece.unreachable(near)) whole.mark_unreachable(to_old(near));
      }
    }
  }
  return whole;
}

}  // namespace sensotwin::robot
