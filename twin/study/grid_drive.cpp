// SPDX-License-Identifier: MIT
#include "twin/study/grid_drive.hpp"

#include <algorithm>

namespace sensotwin::twin {
namespace {

using robot::Direction;
using robot::Passage;
using robot::Tile;

/// No explorer needs more: BFM in its slowest reading drives some 12 moves per tag in the house; a hundred
/// mean that it goes round in circles.
constexpr int kMovesPerTagMax = 100;

Direction side_towards(Tile from, Tile to) {
  for (const Direction side : robot::kDirections) {
    if (neighbour(from, side) == to) return side;
  }
  return Direction::kEast;
}

/// A tag's number as the grid model needs one: different for different tiles.
robot::TagUid uid_of(Tile tile) {
  return (static_cast<robot::TagUid>(static_cast<std::uint32_t>(tile.column)) << 32) |
         static_cast<std::uint32_t>(tile.row);
}

class GridDrive {
 public:
  GridDrive(const GridRoom& room, const DriveOptions& options, std::vector<Tile>* order)
      : room_(room), options_(options), order_(order), at_(room.start()), heading_(options.heading) {
    tags_ = room.reachable();
    tally_.tags = static_cast<int>(tags_.size());
  }

  DriveTally run(robot::Explorer& explorer) {
    arrive();
    const int limit = kMovesPerTagMax * tally_.tags;
    for (;;) {
      // The explorer is told of the last tag too, so that it counts it.
      const auto move = explorer.next(map_, at_, heading_);
      if (!options_.to_the_end && tally_.tags_visited == tally_.tags) break;
      if (!move) {
        tally_.ended = true;
        break;
      }
      if (move->detour && !options_.answer_detours) {
        tally_.ended = true;
        break;
      }
      if (tally_.moves + tally_.bumps > limit) break;
      if (move->detour) {
        perform_detour(move->target);
      } else {
        perform(move->target);
      }
    }
    tally_.paper_visits = explorer.paper_visits();
    return tally_;
  }

 private:
  void arrive() {
    if (!map_.visited(at_)) {
      map_.mark_visited(at_, uid_of(at_));
      ++tally_.tags_visited;
      if (order_ != nullptr) order_->push_back(at_);
    }
    if (options_.knowledge == Knowledge::kBump) return;
    for (const Direction side : robot::kDirections) {
      map_.mark_passage(at_, side, room_.open(at_, side) ? Passage::kOpen : Passage::kBlocked);
    }
  }
  void perform(Tile target) {
    const Direction side = side_towards(at_, target);
    tally_.quarter_turns += quarter_turns(heading_, side);
    heading_ = side;
    const bool through = neighbour(at_, side) == target && room_.open(at_, side);
    map_.mark_passage(at_, side, through ? Passage::kOpen : Passage::kBlocked);
    if (!through) {
      ++tally_.bumps;
      return;
    }
    ++tally_.moves;
    at_ = target;
    arrive();
  }
  void perform_detour(Tile target) {
    ++tally_.moves;
    if (!room_.free(target)) {
      map_.mark_unreachable(target);
      return;
    }
    at_ = target;
    arrive();
  }

  const GridRoom& room_;
  const DriveOptions& options_;
  std::vector<Tile>* order_;
  std::vector<Tile> tags_;
  robot::TileMap map_;
  Tile at_;
  Direction heading_;
  DriveTally tally_;
};

}  // namespace

DriveTally drive(robot::Explorer& explorer, const GridRoom& room, const DriveOptions& options,
                 std::vector<Tile>* order) {
  return GridDrive{room, options, order}.run(explorer);
}

}  // namespace sensotwin::twin
