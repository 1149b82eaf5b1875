// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/mapping/tile.hpp"
#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// The next thing to do on the carpet.
struct Move {
  Tile target;
  /// False: `target` shares a side with the tile under the robot; drive straight. True: go there by any way
  /// that free floor may offer (round a door jamb, between legs).
  bool detour{false};
};

/// Decides in which order tiles are visited. Knows tiles and passages only: neither metres nor bumpers.
///
/// The caller performs the move, writes the outcome into the map (visited, or passage blocked, or tile
/// unreachable) and asks again; after a failed move the robot is on the tile it was on before.
class Explorer {
 public:
  virtual ~Explorer() = default;
  /// \param map      all that is known
  /// \param at       the tile under the robot: visited
  /// \param heading  the way the robot faces
  /// \returns the next move, or nothing when the map is complete for this explorer
  [[nodiscard]] std::optional<Move> next(const TileMap& map, Tile at, Direction heading) {
    return do_next(map, at, heading);
  }
  /// S_T as the paper counts it (Algorithm 1: one for each first visit, one for each backtrack, however
  /// long).
  [[nodiscard]] int paper_visits() const { return do_paper_visits(); }

 private:
  virtual std::optional<Move> do_next(const TileMap& map, Tile at, Direction heading) = 0;
  [[nodiscard]] virtual int do_paper_visits() const = 0;
};

}  // namespace sensotwin::robot
