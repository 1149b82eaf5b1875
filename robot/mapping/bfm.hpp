// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>

#include "robot/mapping/explorer.hpp"
#include "robot/mapping/way_back.hpp"

namespace sensotwin::robot {

/// Three readings of one paragraph. "All unvisited tags adjacent from t are visited next" does not say
/// whether the robot returns to t in between, and "SensoBot has to visit all four tags" says that visited
/// ones count too.
enum class BfmReading : std::uint8_t {
  kLazy,        ///< to the next unvisited neighbour by the shortest way, over t only if that is the way; the
                ///< one reading whose ratio to DFM and IDFM agrees with the paper's minutes
  kOutAndBack,  ///< back to t after each unvisited neighbour
  kAllNeighbours  ///< back to t after each neighbour, visited or not
};

/// Breadth First Mapping (SensoBot, section IV.1). "The newly visited tags haven't been explored and are put
/// onto the end of a list of unexplored tags. The first tag on this list is the next to be explored.
/// Exploration continues until no unexplored tag is left."
class Bfm : public Explorer {
 public:
  explicit Bfm(BfmReading reading = BfmReading::kLazy) : reading_(reading) {}

 private:
  std::optional<Move> do_next(const TileMap& map, Tile at, Direction heading) override;
  [[nodiscard]] int do_paper_visits() const override { return first_visits_ + backtracks_; }

  void list_as_unexplored(const TileMap& map, Tile at);
  [[nodiscard]] bool wanted(const TileMap& map, Tile t, Direction side) const;
  [[nodiscard]] std::optional<Move> explore_directly(const TileMap& map, Tile t, Tile at, Direction heading);
  [[nodiscard]] std::optional<Move> explore_out_and_back(const TileMap& map, Tile t, Tile at,
                                                         Direction heading);
  [[nodiscard]] std::optional<Move> drive_to(const TileMap& map, Tile at, Direction heading,
                                             const std::vector<Tile>& goals);

  BfmReading reading_;
  std::deque<Tile> unexplored_;
  TileGrid<bool> listed_{false};
  unsigned sides_done_{0};  ///< of the first unexplored tag
  WayBack way_;
  int first_visits_{0};
  int backtracks_{0};
};

}  // namespace sensotwin::robot
