// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/mapping/explorer.hpp"
#include "robot/mapping/way_back.hpp"

namespace sensotwin::robot {

/// What DFM and IDFM do differently: which tag they drive back to.
enum class Backtracking : std::uint8_t {
  kRetraceAll,       ///< DFM: "pops a tag from the stack and backtracks to that tag and tries to find an open
                     ///< path"
  kToOpenPathDirect  ///< IDFM: "each time SensoBot pops a tag, it checks for an open path before driving to
                     ///< that tag"; then by the shortest way over visited tags
};

/// Depth First Mapping (SensoBot, section IV.2) and its improvement (section IV.3, Algorithm 1).
///
/// Moves in one direction and pushes each visited tag; when blocked, changes direction: left, then right,
/// then back (the paper: "choosing the one that might lead outwards"; which side comes first changes its
/// epsilon by less than 3 %). When no side is open it pops. Ends when the stack is empty.
class Dfm : public Explorer {
 public:
  explicit Dfm(Backtracking backtracking = Backtracking::kRetraceAll) : backtracking_(backtracking) {}

 private:
  std::optional<Move> do_next(const TileMap& map, Tile at, Direction heading) override;
  /// Algorithm 1 increases S_T at each push and at each backtrack.
  [[nodiscard]] int do_paper_visits() const override { return first_visits_ + backtracks_; }

  void push(const TileMap& map, Tile at);
  [[nodiscard]] std::optional<Move> backtrack(const TileMap& map, Tile at, Direction heading);

  Backtracking backtracking_;
  std::vector<Tile> stack_;
  bool started_{false};
  WayBack way_;
  int first_visits_{0};
  int backtracks_{0};
};

}  // namespace sensotwin::robot
