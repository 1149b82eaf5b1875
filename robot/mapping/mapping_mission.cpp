// SPDX-License-Identifier: MIT
#include "robot/mapping/mapping_mission.hpp"

#include <utility>

namespace sensotwin::robot {
namespace {

/// Standing still on the first tag, so that what is seen is seen twice.
constexpr Duration kFirstLook = std::chrono::milliseconds{700};

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
  map_.mark_unreachable(tile);
  ++log_.counts.tiles_given_up;
}

Task<> MappingMission::run() {
  const Instant begun = io_.sensed.stamp;
  if (!co_await mover_.find_origin()) {
    finished_ = true;
    co_return;
  }
  co_await pilot_.wait_until(io_.sensed.stamp + kFirstLook);
  co_await mover_.look_round();
  co_await dwell(begun, true);
  succeeded_ = true;
  for (;;) {
    mover_.see_passages();
    const std::optional<Move> move = explorer_->next(map_, mover_.at(), mover_.heading());
    if (!move) {
      break;
    }
    const Instant move_begun = io_.sensed.stamp;
    const std::size_t before = map_.visited_count();
    const Tile from = mover_.at();
    const Direction side = move->detour ? mover_.heading() : direction_between(from, move->target);
    MoveEnd end = MoveEnd::kLost;
    if (move->detour) {
      end = co_await mover_.detour(move->target);
    } else {
      end = co_await mover_.go(move->target);
    }
    if (end == MoveEnd::kBlocked) {
      if (move->detour) {
        give_up(move->target);
      } else {
        map_.mark_passage(from, side, Passage::kBlocked);
      }
    } else if (end == MoveEnd::kNoTag) {
      give_up(move->target);
      map_.mark_passage(from, side, Passage::kBlocked);
    } else if (end == MoveEnd::kLost) {
      succeeded_ = false;
      break;
    }
    // A detour that found no way has not moved, and costs no slot of the pace.
    if (!move->detour || end == MoveEnd::kArrived) {
      co_await dwell(move_begun, map_.visited_count() > before);
    }
  }
  co_await mover_.settle();
  log_.add(io_.sensed.stamp, MissionEventKind::kDone, mover_.at());
  finished_ = true;
}

}  // namespace sensotwin::robot
