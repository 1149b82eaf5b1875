// SPDX-License-Identifier: MIT
#include "robot/calibration/square_mission.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace sensotwin::robot {
namespace {

/// Standing on the first tag until the compass has spoken. Chosen, as a mapping mission's first look.
constexpr Duration kFirstLook = std::chrono::milliseconds{700};
/// Two hours of steps. Chosen: ten times what a patient person lets it drive.
constexpr std::size_t kMostSteps = 480000;

/// From tile to tile round the square, back to its first corner.
std::vector<Tile> ring(int side, bool clockwise) {
  std::vector<Tile> tiles;
  for (int i = 1; i <= side; ++i) {
    tiles.push_back({i, 0});
  }
  for (int i = 1; i <= side; ++i) {
    tiles.push_back({side, i});
  }
  for (int i = side - 1; i >= 0; --i) {
    tiles.push_back({i, side});
  }
  for (int i = side - 1; i >= 0; --i) {
    tiles.push_back({0, i});
  }
  if (clockwise) {
    for (Tile& tile : tiles) {
      std::swap(tile.column, tile.row);
    }
  }
  return tiles;
}

std::int16_t counts(int counted) {
  constexpr int kMost = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::clamp(counted, -kMost, kMost));
}

}  // namespace

SquareMission::SquareMission(const MappingConfig& config, const SquarePlan& plan)
    : config_(config),
      plan_(plan),
      navigator_(config_, map_),
      pilot_(config_, navigator_, io_),
      mover_(config_, navigator_, map_, pilot_, io_, mission_log_),
      script_(run()) {}

WheelSpeeds SquareMission::step(const Sensed& sensed) {
  io_.sensed = sensed;
  navigator_.sense(sensed);
  if (const std::optional<TileWrite> asked = std::exchange(io_.command.write, std::nullopt)) {
    // Tags keep what they hold: the mover hears that its coordinates are in.
    mover_.write_ended({asked->tag, true});
  }
  watch(sensed);
  if (!done_) {
    if (!started_) {
      started_ = true;
      script_.start();
    } else {
      io_.next.resume();
    }
    (void)mission_log_.take();
    log(sensed);
  }
  return done_ ? WheelSpeeds{} : io_.command.wheels;
}

void SquareMission::end(SquareFault fault) {
  fault_ = fault;
  done_ = true;
}

void SquareMission::watch(const Sensed& sensed) {
  if (done_) {
    return;
  }
  if (sensed.wheel_drop || sensed.cliff) {
    end(SquareFault::kLifted);
  } else if (sensed.bump_left || sensed.bump_right) {
    end(SquareFault::kBumped);
  } else if (log_of_wheels_.steps.size() >= kMostSteps) {
    end(SquareFault::kTooLong);
  }
}

void SquareMission::log(const Sensed& sensed) {
  std::vector<CountedStep>& steps = log_of_wheels_.steps;
  steps.push_back({counts(sensed.counts_left), counts(sensed.counts_right)});
  const std::size_t step = steps.size() - 1;
  const auto cross = [&](TagUid tag, const Entered& at, bool entered) {
    if (const std::optional<Tile> tile = map_.tile_of(tag)) {
      log_of_wheels_.crossings.push_back(
          {.step = at.step, .tile = *tile, .entered = entered, .X_MR = at.X_MR});
    }
  };
  if (sensed.tag_left) {
    if (in_field_) {
      cross(*in_field_, {step, navigator_.pose()}, false);
    }
    in_field_.reset();
    entered_.reset();
  }
  if (sensed.tag_entered) {
    in_field_.reset();
    entered_ = Entered{step, navigator_.pose()};
  }
  if (sensed.tag_identified) {
    in_field_ = sensed.tag_identified;
    // The one under the robot at the start was not come upon: it says nothing of where its rim is.
    if (entered_ && navigator_.filter().path_length_m() > config_.read_radius_m) {
      cross(*in_field_, *entered_, true);
    }
    entered_.reset();
  }
}

Task<bool> SquareMission::drive_lap(bool clockwise) {
  const std::size_t first = log_of_wheels_.crossings.size();
  for (const Tile tile : ring(plan_.side, clockwise)) {
    target_ = tile;
    const MoveEnd moved = co_await mover_.go(tile);
    if (moved != MoveEnd::kArrived) {
      end(moved == MoveEnd::kBlocked ? SquareFault::kInTheWay
          : moved == MoveEnd::kNoTag ? SquareFault::kTagMissing
                                     : SquareFault::kLost);
      co_return false;
    }
  }
  // The crossing that ended the lap is logged after this step's behaviours.
  co_await io_.next;
  log_of_wheels_.laps.push_back({first, log_of_wheels_.crossings.size() - 1, clockwise});
  co_return true;
}

Task<> SquareMission::run() {
  const bool found = co_await mover_.find_origin();
  if (!found) {
    end(SquareFault::kNoFirstTag);
    co_return;
  }
  co_await mover_.settle();
  co_await pilot_.wait_until(io_.sensed.stamp + kFirstLook);
  for (const bool clockwise : {false, true}) {
    for (int lap = 0; lap < plan_.laps; ++lap) {
      const bool round = co_await drive_lap(clockwise);
      if (!round) {
        co_return;
      }
    }
    co_await mover_.settle();
  }
  end(SquareFault::kNone);
}

}  // namespace sensotwin::robot
