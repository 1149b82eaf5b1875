// SPDX-License-Identifier: MIT
#include "robot/mapping/tile_mover.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/mapping/nudges.hpp"

namespace sensotwin::robot {
namespace {

/// Room beside the body that a straight way should have.
constexpr double kEasyClearance_m = 0.185;
/// The antenna must stay this far inside the zone's rim to be sure of a read.
constexpr double kAimMargin_m = 0.02;
/// A tag further than this from where the robot thinks it is cannot be the one it was driving to.
constexpr double kBelieve_m = 0.25;
/// A new tag read this much farther from the middle of its tile than its zone reaches belongs to nobody knows
/// which: the robot has gone astray and must find itself first. Chosen: errors from here to a quarter of a
/// metre are noticed, before they are large enough to take one tile for the next.
constexpr double kMisplaced_m = 0.12;
constexpr int kWriteAttempts = 4;
/// Rings of a search, 11 cm apart: as far as a tag may be from where it was expected; and, when nothing was
/// found, as far as the next tile's.
constexpr int kSearchRings = 3;
/// Stopped by something when the tag is nearly in reach, the robot feels for it along what stopped it.
constexpr double kNearly_m = 0.05;
constexpr int kFeelRings = 1;
constexpr int kLostRings = 5;

double yaw_of(Direction d) {
  return wrap_angle(static_cast<int>(d) * kPi / 2.0);
}

}  // namespace

Line TileMover::line_of(Tile from, Direction d) const {
  return {navigator_.centre_m(from), yaw_of(d)};
}

void TileMover::see_passages() {
  // Driving on, the beams have swept sides of the last tile that were still dark on arrival.
  see_passages_of(at_);
  for (const Direction d : kDirections) {
    if (map_.visited(neighbour(at_, d))) {
      see_passages_of(neighbour(at_, d));
    }
  }
}

void TileMover::see_passages_of(Tile tile) {
  for (const Direction d : kDirections) {
    const Tile next = neighbour(tile, d);
    if (map_.passage(tile, d) == Passage::kBlocked || map_.visited(next)) {
      continue;
    }
    const Line line = line_of(tile, d);
    const double reach = config_.tile_m - config_.read_radius_m;
    if (navigator_.floor().blocks(line.from_M_m, line.from_M_m + reach * line.along(),
                                  config_.sure_clearance_m)) {
      map_.mark_passage(tile, d, Passage::kBlocked);
      log_.add(io_.sensed.stamp, MissionEventKind::kPassageSeen, next);
    } else {
      // The beams reach as far as a wall at the tile's border; what stands farther off is found by driving
      // there.
      map_.mark_passage(tile, d, Passage::kOpen);
    }
  }
}

double TileMover::clearest_aim(const Line& line, double length_m) const {
  const Vec2 left{-line.along().y(), line.along().x()};
  for (const double aim : {config_.aim_left_m, 0.0, -config_.aim_left_m, 0.05, -0.05}) {
    const Vec2 from = line.from_M_m + aim * left;
    if (!navigator_.floor().blocks(from, from + length_m * line.along(), kEasyClearance_m)) {
      return aim;
    }
  }
  return 0.0;
}

void TileMover::arrive(Tile tile, TagUid tag, bool first) {
  at_ = tile;
  ++log_.counts.visits;
  if (first) {
    log_.add(io_.sensed.stamp, MissionEventKind::kTileFound, tile, tag);
    navigator_.use_tag_in_field();
    write_attempts_ = 0;
    begin_write(tile, tag);
  }
}

void TileMover::begin_write(Tile tile, TagUid tag) {
  write_pending_ = true;
  write_in_flight_ = true;
  ++write_attempts_;
  io_.command.write = TileWrite{tag, tile};
}

void TileMover::write_ended(const TileWriteEnded& ended) {
  if (!write_pending_ || map_.tag_on(at_) != ended.tag) {
    return;
  }
  write_in_flight_ = false;
  if (ended.verified) {
    write_pending_ = false;
    ++log_.counts.writes_verified;
    log_.add(io_.sensed.stamp, MissionEventKind::kTileWritten, at_, ended.tag);
  } else if (write_attempts_ >= kWriteAttempts) {
    write_pending_ = false;
    ++log_.counts.writes_failed;
    log_.add(io_.sensed.stamp, MissionEventKind::kWriteFailed, at_, ended.tag);
  }
}

bool TileMover::misplaced(Tile tile) const {
  return (navigator_.pose().p_m - navigator_.centre_m(tile)).norm() > config_.read_radius_m + kMisplaced_m;
}

std::optional<MoveEnd> TileMover::judge_tag(TagUid tag, std::optional<Tile> from, Tile target) {
  if (const auto known = map_.tile_of(tag)) {
    if (*known == from) {
      return std::nullopt;
    }
    arrive(*known, tag, false);
    if (*known == target) {
      return MoveEnd::kArrived;
    }
    if (navigator_.relocated()) {
      log_.add(io_.sensed.stamp, MissionEventKind::kDisplaced, *known, tag);
    }
    return MoveEnd::kDisplaced;
  }
  const Tile nearest = navigator_.nearest_tile(navigator_.pose().p_m);
  const bool near_target = (navigator_.pose().p_m - navigator_.centre_m(target)).norm() < kBelieve_m;
  const Tile tile = near_target ? target : nearest;
  if (misplaced(tile)) {
    return MoveEnd::kLost;
  }
  if (!map_.mark_visited(tile, tag)) {
    log_.add(io_.sensed.stamp, MissionEventKind::kDisplaced, tile, tag);
    return MoveEnd::kLost;
  }
  arrive(tile, tag, true);
  return tile == target ? MoveEnd::kArrived : MoveEnd::kDisplaced;
}

Task<bool> TileMover::find_origin() {
  // Wait for the reader's first look at the floor, then go and find a tag.
  const Line ahead{navigator_.pose().p_m, navigator_.pose().yaw_rad};
  constexpr double kAhead_m = 1.0;
  const Instant look_until = io_.sensed.stamp + std::chrono::milliseconds{500};
  while (!navigator_.tag_in_field()) {
    const double s = ahead.along_m(navigator_.pose().p_m);
    if (io_.sensed.stamp > look_until) {
      if (s > kAhead_m || pilot_.bumped() || pilot_.hazard()) {
        co_await pilot_.brake();
        co_return false;
      }
      pilot_.follow(ahead, config_.careful_speed_mps, 0.0);
    }
    co_await io_.next;
  }
  const TagUid tag = *navigator_.tag_in_field();
  // The first tag found is the origin (SensoBot, III.A), wherever in its zone the antenna is.
  const double s = ahead.along_m(navigator_.pose().p_m);
  const bool moving = s > 0.02;
  navigator_.filter().reset({moving ? Vec2{-(config_.read_radius_m - 0.02), 0.0} : Vec2{0.0, 0.0}, 0.0}, 0.03,
                            0.05);
  map_.mark_visited(Tile{}, tag);
  heading_ = Direction::kEast;
  arrive(Tile{}, tag, true);
  co_return true;
}

Task<> TileMover::look_round() {
  // The outer beams look 65 degrees aside: turns of 120 to either side show them all that is behind, corners
  // included. As far left as right, so that what the wheels get wrong in turning cancels.
  const double ahead = navigator_.pose().yaw_rad;
  for (const double aside_deg : {120.0, 0.0, -120.0, 0.0}) {
    co_await pilot_.turn_to(wrap_angle(ahead + rad_from_deg(aside_deg)));
  }
}

Task<> TileMover::rest_at(double stop_m, double slowest_mps) {
  const Line line = line_of(at_, heading_);
  for (;;) {
    const double left_to_go = stop_m - line.along_m(navigator_.pose().p_m);
    const double speed = std::min(config_.pace.speed_mps, pilot_.stopping_speed_mps(left_to_go));
    if (speed < slowest_mps || pilot_.bumped()) {
      break;
    }
    pilot_.follow(line, speed, config_.aim_left_m);
    co_await io_.next;
  }
  co_await pilot_.brake();
  co_await hold_for_write(at_);
}

Task<> TileMover::settle() {
  co_await rest_at(0.0, 0.02);
}

Task<> TileMover::face(Direction d) {
  if (d != heading_) {
    // Stop where the new line wants the robot: its lateral offset is the present line's position along.
    const bool left = d == turned(heading_, 1);
    const double stop_m = d == opposite(heading_) ? 0.0 : (left ? -config_.aim_left_m : config_.aim_left_m);
    co_await rest_at(stop_m, 0.03);
  }
  const double off = wrap_angle(yaw_of(d) - navigator_.pose().yaw_rad);
  if (std::abs(off) > rad_from_deg(20)) {
    log_.counts.quarter_turns += static_cast<int>(std::lround(std::abs(off) / (kPi / 2.0)));
    co_await pilot_.turn_to(yaw_of(d));
  }
  heading_ = d;
}

Task<MoveEnd> TileMover::go(Tile target) {
  ++log_.counts.moves;
  const Tile from = at_;
  const Direction d = direction_between(from, target);
  co_await face(d);
  MoveEnd end = co_await roll(from, target, d);
  if (end == MoveEnd::kNoTag) {
    ++log_.counts.moves_missed;
    log_.add(io_.sensed.stamp, MissionEventKind::kTagMissed, target);
    const std::optional<MoveEnd> found = co_await search(from, target, kSearchRings, TrustFloor::kYes);
    if (found) {
      ++log_.counts.misses_recovered;
      log_.add(io_.sensed.stamp, MissionEventKind::kTagRecovered, at_);
      co_return *found;
    }
    log_.add(io_.sensed.stamp, MissionEventKind::kTagGivenUp, target);
    const std::optional<MoveEnd> back = co_await search(std::nullopt, from, kLostRings, TrustFloor::kNo);
    if (!back) {
      end = MoveEnd::kLost;
    } else if (*back != MoveEnd::kArrived) {
      end = *back;
    }
  }
  co_return end;
}

Task<MoveEnd> TileMover::roll(Tile from, Tile target, Direction d) {
  const Line line = line_of(from, d);
  Nudges nudges(clearest_aim(line, config_.tile_m), config_.read_radius_m - kAimMargin_m);
  const double give_up_m = config_.tile_m + config_.read_radius_m + 0.04;
  for (;;) {
    if (const auto tag = navigator_.identified()) {
      if (const auto end = judge_tag(*tag, from, target)) {
        map_.mark_passage(from, d, Passage::kOpen);
        co_return *end;
      }
    }
    const double s = line.along_m(navigator_.pose().p_m);
    if (pilot_.hazard()) {
      const MoveEnd end = co_await give_way(from, line);
      co_return end;
    }
    if (pilot_.bumped()) {
      ++log_.counts.bumps;
      const int side = pilot_.bump_side();
      navigator_.remember_bump(side, io_.sensed);
      if (s > config_.tile_m && !navigator_.anything_in_field()) {
        // A wall behind the tag's place, and the tag was not read on the way to it.
        co_await pilot_.brake();
        navigator_.miss(target, line.yaw_rad);
        co_return MoveEnd::kNoTag;
      }
      if (!nudges.away_from(side, s)) {
        if (s > config_.tile_m - config_.read_radius_m - kNearly_m) {
          const std::optional<MoveEnd> felt = co_await feel_for(from, target);
          if (felt) {
            co_return *felt;
          }
        }
        co_return co_await give_way(from, line);
      }
      co_await pilot_.back_along(line, s - config_.back_off_m, nudges.aim_left_m());
      continue;
    }
    if (s > give_up_m) {
      co_await pilot_.brake();
      navigator_.miss(target, line.yaw_rad);
      co_return MoveEnd::kNoTag;
    }
    if (write_pending_ && s > config_.read_radius_m / 2.0) {
      co_await hold_for_write(from);
    }
    pilot_.follow(line, nudges.any() ? config_.careful_speed_mps : config_.pace.speed_mps,
                  nudges.aim_left_m());
    co_await io_.next;
  }
}

Task<std::optional<MoveEnd>> TileMover::feel_for(Tile from, Tile target) {
  std::optional<MoveEnd> end = co_await search(from, target, kFeelRings, TrustFloor::kNo);
  if (!end) {
    const TagWanted known_ones{.ignored = std::nullopt, .new_ones = false};
    co_await creep_to(navigator_.centre_m(from), known_ones);
  }
  co_return end;
}

Task<MoveEnd> TileMover::give_way(Tile from, Line line) {
  log_.add(io_.sensed.stamp, MissionEventKind::kPassageBumped, neighbour(from, heading_));
  co_await pilot_.back_along(line, 0.0, 0.0);
  co_await hold_for_write(from);
  co_return MoveEnd::kBlocked;
}

}  // namespace sensotwin::robot
