// SPDX-License-Identifier: MIT
#include "robot/mapping/mapping_mission.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "robot/mapping/route.hpp"

namespace sensotwin::robot {
namespace {

/// Standing still on the first tag, so that what is seen is seen twice.
constexpr Duration kFirstLook = std::chrono::milliseconds{700};
/// A tile with so many visited neighbours that could not be entered is more likely a mistake than a pillar:
/// it is tried again at the end, from so many sides.
constexpr int kDoubtfulSides = 3;
constexpr int kDoubtfulTries = 2;
/// A way that was blocked against the look of things is tried all the same if nothing stands closer to it
/// than this: two centimetres less than what blocks it. Chosen: the error of range and pose together.
constexpr double kNarrow_m = 0.115;
/// Cells of the floor grid that something stood in, in a tile that holds a pillar: a side of it, half a
/// metre. Chosen.
constexpr int kSolidCells = 16;

bool direct_neighbours(Tile a, Tile b) {
  return std::abs(a.column - b.column) + std::abs(a.row - b.row) == 1;
}

}  // namespace

MappingMission::MappingMission(const MappingConfig& config, std::unique_ptr<Explorer> explorer)
    : config_(config),
      explorer_(std::move(explorer)),
      navigator_(config_, map_),
      pilot_(config_, navigator_, io_),
      mover_(config_, navigator_, map_, pilot_, io_, log_),
      script_(run()) {}

Command MappingMission::step(const Sensed& sensed) {
  io_.sensed = sensed;
  io_.command.write.reset();
  navigator_.sense(sensed);
  if (sensed.write_ended) {
    mover_.write_ended(*sensed.write_ended);
  }
  if (!started_) {
    started_ = true;
    script_.start();
  } else {
    io_.next.resume();
  }
  return io_.command;
}

Task<> MappingMission::dwell(Instant begun, bool new_tag) {
  const double slot_s = config_.pace.tile_s + (new_tag ? config_.pace.tag_s : 0.0);
  if (slot_s > 0.0) {
    co_await mover_.settle();
    co_await pilot_.wait_until(begun + from_s(slot_s));
  }
}

void MappingMission::give_up(Tile tile) {
  log_.counts.tiles_given_up += map_.unreachable(tile) ? 0 : 1;
  map_.mark_unreachable(tile);
}

Task<bool> MappingMission::perform(Move move, Squeeze squeeze) {
  const Instant begun = io_.sensed.stamp;
  const std::size_t before = map_.visited_count();
  const Tile from = mover_.at();
  MoveEnd end = MoveEnd::kLost;
  if (move.detour) {
    end = co_await mover_.detour(move.target, squeeze);
  } else {
    end = co_await mover_.go(move.target);
    if (end == MoveEnd::kBlocked && map_.visited(move.target)) {
      // It has been there before: if not straight, then round.
      end = co_await mover_.detour(move.target, Squeeze::kNo);
    }
  }
  if (end == MoveEnd::kBlocked && !move.detour) {
    touched_.insert({from, move.target});
    map_.mark_passage(from, direction_between(from, move.target), Passage::kBlocked);
  } else if (end == MoveEnd::kBlocked) {
    no_way_.insert(move.target);
    give_up(move.target);
  } else if (end == MoveEnd::kNoTag) {
    no_tag_.insert(move.target);
    give_up(move.target);
  } else if (end == MoveEnd::kLost) {
    const bool found = co_await mover_.recover();
    if (!found) {
      log_.add(io_.sensed.stamp, MissionEventKind::kLost, mover_.at());
      co_return false;
    }
  }
  if (map_.visited_count() > before) {
    reconsider_round(mover_.at());
  }
  // A detour that found no way has not moved, and costs no slot of the pace.
  if (!move.detour || end == MoveEnd::kArrived) {
    co_await dwell(begun, map_.visited_count() > before);
  }
  co_return true;
}

void MappingMission::reconsider_round(Tile tile) {
  // What could not be reached from beyond a wall may be reached from here.
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Tile next{tile.column + dx, tile.row + dy};
      if (!no_tag_.contains(next)) {
        map_.reconsider(next);
      }
    }
  }
}

std::optional<Tile> MappingMission::next_doubtful() {
  std::optional<Tile> nearest;
  int best = std::numeric_limits<int>::max();
  for (const auto& [tile, tag] : map_.tiles()) {
    for (const Direction side : kDirections) {
      const Tile next = neighbour(tile, side);
      if (map_.visited(next) || tried_again_.contains(next)) {
        continue;
      }
      const auto sides = std::count_if(kDirections.begin(), kDirections.end(),
                                       [&](Direction d) { return map_.visited(neighbour(next, d)); });
      const int way = std::abs(next.column - mover_.at().column) + std::abs(next.row - mover_.at().row);
      const bool odd = sides >= kDoubtfulSides && !looks_solid(next);
      const bool narrow =
          map_.passage(tile, side) == Passage::kBlocked && !touched_.contains({tile, next}) &&
          !navigator_.floor().blocks(navigator_.centre_m(tile), navigator_.centre_m(next), kNarrow_m);
      if ((odd || narrow || no_tag_.contains(next)) && way < best) {
        best = way;
        nearest = next;
      }
    }
  }
  return nearest;
}

bool MappingMission::looks_solid(Tile tile) const {
  // A pillar, seen from all round, leaves a closed outline; a mistake leaves a few specks.
  const FloorGrid::Cell middle = FloorGrid::cell_at(navigator_.centre_m(tile));
  const int half = static_cast<int>(config_.tile_m / 2.0 / FloorGrid::kCell_m) + 1;
  int cells = 0;
  for (int dy = -half; dy <= half; ++dy) {
    for (int dx = -half; dx <= half; ++dx) {
      cells += navigator_.floor().occupied({middle.x + dx, middle.y + dy}) ? 1 : 0;
    }
  }
  return cells >= kSolidCells;
}

Task<bool> MappingMission::try_doubtful() {
  while (const std::optional<Tile> tile = next_doubtful()) {
    tried_again_.insert(*tile);
    int tries = 0;
    for (const Direction side : kDirections) {
      const Tile next = neighbour(*tile, side);
      if (!map_.visited(next) || map_.visited(*tile) || ++tries > kDoubtfulTries) {
        continue;
      }
      std::vector<Tile> route = shortest_route(map_, mover_.at(), mover_.heading(), {next});
      for (const Tile step : route) {
        if (direct_neighbours(mover_.at(), step)) {
          const bool well = co_await perform({.target = step});
          if (!well) {
            co_return false;
          }
        }
      }
      if (mover_.at() == next) {
        const bool well = co_await perform({.target = *tile});
        if (!well) {
          co_return false;
        }
      }
    }
    if (map_.visited(*tile)) {
      co_return true;  // and there may be more behind it
    }
  }
  const bool squeezed = co_await squeeze();
  co_return squeezed;
}

Task<bool> MappingMission::squeeze() {
  for (const Squeeze how : {Squeeze::kTight, Squeeze::kByTouch}) {
    std::set<Tile>& tried = squeezed_[how];
    std::set<Tile> candidates = no_way_;
    candidates.insert(no_tag_.begin(), no_tag_.end());
    for (const Tile tile : candidates) {
      if (map_.visited(tile) || !tried.insert(tile).second) {
        continue;
      }
      const bool well = co_await perform({.target = tile, .detour = true}, how);
      if (!well) {
        co_return false;
      }
      if (map_.visited(tile)) {
        co_return true;
      }
    }
  }
  const bool leapt = co_await leap();
  co_return leapt;
}

std::set<Tile> MappingMission::beyond_neighbours() const {
  std::set<Tile> beyond;
  for (const auto& [tile, tag] : map_.tiles()) {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const Tile next{tile.column + dx, tile.row + dy};
        if (!map_.visited(next) && !no_way_.contains(next) && !no_tag_.contains(next)) {
          beyond.insert(next);
        }
      }
    }
  }
  return beyond;
}

Task<bool> MappingMission::leap() {
  if (no_way_.empty()) {
    co_return false;  // an explorer that goes straight only
  }
  for (const Tile tile : beyond_neighbours()) {
    if (leapt_.contains(tile) || !mover_.way_seems_open(tile)) {
      continue;
    }
    leapt_.insert(tile);
    const bool well = co_await perform({.target = tile, .detour = true});
    if (!well) {
      co_return false;
    }
    if (map_.visited(tile)) {
      co_return true;
    }
  }
  co_return false;
}

Task<> MappingMission::run() {
  const Instant begun = io_.sensed.stamp;
  const bool on_carpet = co_await mover_.find_origin();
  if (!on_carpet) {
    finished_ = true;
    co_return;
  }
  co_await pilot_.wait_until(io_.sensed.stamp + kFirstLook);
  co_await mover_.look_round();
  co_await dwell(begun, true);
  succeeded_ = true;
  bool more = true;
  while (more && succeeded_) {
    mover_.see_passages();
    std::optional<Move> move = explorer_->next(map_, mover_.at(), mover_.heading());
    while (move && succeeded_) {
      succeeded_ = co_await perform(*move);
      mover_.see_passages();
      move = explorer_->next(map_, mover_.at(), mover_.heading());
    }
    more = false;
    if (succeeded_) {
      more = co_await try_doubtful();
    }
  }
  co_await mover_.settle();
  log_.add(io_.sensed.stamp, MissionEventKind::kDone, mover_.at());
  finished_ = true;
}

}  // namespace sensotwin::robot
