// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/mapping/explorer.hpp"

namespace sensotwin::robot {

/// A carpet drawn with characters, for tests: lines from north to south, '#' no tag, 'S' the start, '.' a
/// tag. Thin walls may be put between tags. The south-west corner of the picture is tile (0, 0).
class Carpet {
 public:
  explicit Carpet(const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t column = 0; column < lines[i].size(); ++column) {
        const Tile t{static_cast<int>(column), static_cast<int>(lines.size() - 1 - i)};
        if (lines[i][column] != '#') tags_.insert(t);
        if (lines[i][column] == 'S') start_ = t;
      }
    }
  }
  /// Of the given size, each tag missing with `missing`, each passage walled up with `walled`; (0, 0) is the
  /// start.
  static Carpet random(int side, double missing, double walled, RandomStream& random) {
    Carpet carpet{{}};
    for (int column = 0; column < side; ++column) {
      for (int row = 0; row < side; ++row) {
        const Tile t{column, row};
        if (t == Tile{} || !random.chance(missing)) carpet.tags_.insert(t);
        if (random.chance(walled)) carpet.wall(t, Direction::kEast);
        if (random.chance(walled)) carpet.wall(t, Direction::kNorth);
      }
    }
    return carpet;
  }
  void wall(Tile t, Direction side) {
    walls_.insert({t, neighbour(t, side)});
    walls_.insert({neighbour(t, side), t});
  }
  [[nodiscard]] bool holds(Tile t) const { return tags_.contains(t); }
  [[nodiscard]] bool open(Tile t, Direction side) const {
    return holds(neighbour(t, side)) && !walls_.contains({t, neighbour(t, side)});
  }
  [[nodiscard]] Tile start() const { return start_; }
  [[nodiscard]] std::set<Tile> reachable() const {
    std::set<Tile> seen{start_};
    std::vector<Tile> queue{start_};
    while (!queue.empty()) {
      const Tile t = queue.back();
      queue.pop_back();
      for (const Direction side : kDirections) {
        if (open(t, side) && seen.insert(neighbour(t, side)).second) queue.push_back(neighbour(t, side));
      }
    }
    return seen;
  }

 private:
  std::set<Tile> tags_;
  std::set<std::pair<Tile, Tile>> walls_;
  Tile start_{};
};

inline TagUid uid_of(Tile t) {
  return (TagUid{static_cast<std::uint32_t>(t.column)} << 32) | static_cast<std::uint32_t>(t.row);
}

/// A robot on a carpet that does what an explorer says, and writes down what came of it.
struct Walk {
  const Carpet& carpet;
  bool knows_neighbours{true};  ///< all four passages are known on arrival
  TileMap map{};
  Tile at{carpet.start()};
  Direction heading{Direction::kEast};
  int moves{0};
  int bumps{0};
  int claimed_twice{0};  ///< moves announced as first visits of tiles that were visited
  bool illegal{false};   ///< a straight move to a tile that is no neighbour
  std::vector<Tile> drive{};
  std::vector<Move> detours{};

  void arrive() {
    map.mark_visited(at, uid_of(at));
    drive.push_back(at);
    if (!knows_neighbours) return;
    for (const Direction side : kDirections) {
      map.mark_passage(at, side, carpet.open(at, side) ? Passage::kOpen : Passage::kBlocked);
    }
  }
  void straight(Tile target) {
    const auto side = std::find_if(kDirections.begin(), kDirections.end(),
                                   [&](Direction d) { return neighbour(at, d) == target; });
    if (side == kDirections.end()) {
      illegal = true;
      return;
    }
    heading = *side;
    map.mark_passage(at, *side, carpet.open(at, *side) ? Passage::kOpen : Passage::kBlocked);
    if (!carpet.open(at, *side)) {
      ++bumps;
      return;
    }
    ++moves;
    at = target;
    arrive();
  }
  /// \returns whether the explorer came to an end within `limit` decisions.
  bool run(Explorer& explorer, int limit) {
    arrive();
    for (int i = 0; i < limit; ++i) {
      const auto move = explorer.next(map, at, heading);
      if (!move || illegal) return !illegal;
      if (!move->detour) {
        straight(move->target);
        continue;
      }
      detours.push_back(*move);
      if (map.visited(move->target)) ++claimed_twice;
      if (carpet.holds(move->target)) {
        at = move->target;
        arrive();
      } else {
        map.mark_unreachable(move->target);
      }
    }
    return false;
  }
};

}  // namespace sensotwin::robot
