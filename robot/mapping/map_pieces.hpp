// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// Takes a tile of one piece of the map to a tile of another: quarter turns about (0, 0), then a shift.
struct TileTransform {
  int quarter_turns_left{0};
  Tile shift{};

  [[nodiscard]] Tile operator()(Tile t) const;
  [[nodiscard]] Direction operator()(Direction d) const { return turned(d, quarter_turns_left); }
  /// The transform with `quarter_turns_left` that takes `from` to `to`.
  [[nodiscard]] static TileTransform matching(int quarter_turns_left, Tile from, Tile to);
  [[nodiscard]] TileTransform inverse() const;
  bool operator==(const TileTransform&) const = default;
};

/// SensoBot, section IV.3: "If lost, save old data and restart. When old tag is found, merge two grids and
/// continue."
///
/// The old map and the new one are rigid pieces: nothing is known about how they lie to each other but what
/// the tags that both hold say. One common tag leaves four transforms (the compass may have been 90 degrees
/// off in either); each is dropped as soon as it would put two tags on one tile, one tag on two tiles, or a
/// visited tile behind a blocked passage that was driven through. Only when one is left are the grids merged.
/// When two common tags disagree with every transform, the pieces are not rigid to each other: the merge is
/// refused, or undone.
class MapPieces {
 public:
  enum class State : std::uint8_t {
    kNoCommonTag,   ///< go on mapping the new piece
    kAmbiguous,     ///< several transforms are possible: probe
    kCommitted,     ///< one is left: merged() is the whole map
    kContradiction  ///< none is left: the two pieces disagree; keep them apart and start a third
  };

  /// \param old_piece         the map until the loss
  /// \param compass_trusted   both pieces' headings are known to be right, so that they differ by a shift
  /// only
  explicit MapPieces(TileMap old_piece, bool compass_trusted = false);

  /// Call after each change of the new piece. Starts from all four rotations each time, so that what was
  /// committed is undone when a later tag contradicts it. Time: O(tiles of the new piece).
  State update(const TileMap& new_piece);
  [[nodiscard]] State state() const { return state_; }
  /// Transforms from the new piece to the old one that nothing speaks against.
  [[nodiscard]] const std::vector<TileTransform>& candidates() const { return candidates_; }
  /// Which straight move from the tile under the robot tells most candidates apart: the side (in the new
  /// piece's frame) beyond which some candidate expects an old tag. Three such moves always suffice: the old
  /// robot drove to the common tag, or from it, over a neighbour that holds a tag. \returns nothing when
  /// state() is not kAmbiguous
  ///         or no side tells anything
  [[nodiscard]] std::optional<Direction> probe(const TileMap& new_piece, Tile at) const;
  /// Both pieces in the old one's frame. \pre state() == kCommitted
  [[nodiscard]] TileMap merged(const TileMap& new_piece) const;
  [[nodiscard]] const TileMap& old_piece() const { return old_; }

 private:
  [[nodiscard]] bool consistent(const TileMap& new_piece, const TileTransform& to_old) const;

  TileMap old_;
  bool compass_trusted_;
  State state_{State::kNoCommonTag};
  std::vector<TileTransform> candidates_;
};

}  // namespace sensotwin::robot
