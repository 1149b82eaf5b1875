// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "robot/mapping/tile_mover.hpp"

namespace sensotwin::robot {
namespace {

/// Places tried to find a tag again that the robot has just been on: its middle and six round it.
constexpr int kRegainPoints = 7;
/// Rings, 11 cm apart, of the search of a robot that is lost: as far as the next tile's tags.
constexpr int kRecoverRings = 5;
/// Then it wanders: straight until something stops it, each leg turned by the golden angle from the last,
/// which comes near every direction and repeats none.
constexpr int kWanderLegs = 120;
constexpr double kWanderTurn_rad = 2.399963;
constexpr double kWanderLeg_m = 2.0;
/// Before that: known tags nearby that a robot that is lost drives to, and the plans it gives each.
constexpr std::size_t kKnownTried = 8;
constexpr int kPlansToKnown = 8;

}  // namespace

bool TileMover::over_wanted(const TagWanted& wanted) const {
  const auto tag = navigator_.tag_in_field();
  const auto tile = tag ? map_.tile_of(*tag) : std::nullopt;
  return tag && (tile ? tile != wanted.ignored : wanted.new_ones);
}

Task<bool> TileMover::creep_to(Vec2 p_M_m, TagWanted wanted) {
  const Vec2 way = p_M_m - navigator_.pose().p_m;
  if (way.norm() < 0.01 || over_wanted(wanted)) {
    co_return true;
  }
  const Line line{navigator_.pose().p_m, std::atan2(way.y(), way.x())};
  co_await pilot_.turn_to(line.yaw_rad);
  for (;;) {
    const double left_to_go = way.norm() - line.along_m(navigator_.pose().p_m);
    if (left_to_go < 0.01 || over_wanted(wanted)) {
      co_return true;
    }
    if (pilot_.bumped() || pilot_.hazard()) {
      ++log_.counts.bumps;
      navigator_.remember_bump(pilot_.bump_side(), io_.sensed);
      co_await pilot_.back_along(line, line.along_m(navigator_.pose().p_m) - config_.back_off_m, 0.0);
      co_return false;
    }
    pilot_.follow(line, std::min(config_.careful_speed_mps, pilot_.stopping_speed_mps(left_to_go) + 0.02),
                  0.0);
    co_await io_.next;
  }
}

Task<bool> TileMover::regain(Tile tile) {
  // Rolled off the tag before it was written: back over its middle, then over a ring round it.
  const Vec2 centre = navigator_.centre_m(tile);
  const double yaw = navigator_.pose().yaw_rad;
  if ((centre - navigator_.pose().p_m).dot(navigator_.pose().direction()) < 0.0) {
    const Line line{centre, yaw};
    co_await pilot_.back_along(line, 0.0, 0.0);
  }
  const TagWanted any;
  for (int i = 0; i < kRegainPoints && !navigator_.anything_in_field(); ++i) {
    const double angle = yaw + kPi / 2.0 + 2.0 * kPi * i / (kRegainPoints - 1);
    const double radius_m = i == 0 ? 0.0 : 0.75 * config_.read_radius_m;
    const Vec2 place = centre + radius_m * Vec2{std::cos(angle), std::sin(angle)};
    co_await creep_to(place, any);
  }
  co_return navigator_.anything_in_field();
}

Task<> TileMover::hold_for_write(Tile tile) {
  if (!write_pending_) {
    co_return;
  }
  co_await pilot_.brake();
  while (write_pending_) {
    if (navigator_.tag_in_field() && navigator_.tag_in_field() != map_.tag_on(tile)) {
      break;  // over another tag: carried off
    }
    if (!navigator_.anything_in_field()) {
      const bool again = co_await regain(tile);
      if (!again) {
        break;
      }
    }
    if (!write_in_flight_ && navigator_.tag_in_field() == map_.tag_on(tile)) {
      begin_write(tile, *map_.tag_on(tile));
    }
    co_await io_.next;
  }
  if (write_pending_) {
    write_pending_ = false;
    ++log_.counts.writes_failed;
    log_.add(io_.sensed.stamp, MissionEventKind::kWriteFailed, tile, map_.tag_on(tile).value_or(0));
  }
}

Task<std::optional<MoveEnd>> TileMover::search(std::optional<Tile> from, Tile target, int rings,
                                               TrustFloor trust) {
  // Rings of points round the place, a little less than a zone's width apart, nearest first.
  const Vec2 around_M_m = navigator_.centre_m(target);
  // Where the place is known too badly, a new tag might be anyone's: only known ones help.
  const TagWanted wanted{.ignored = from, .new_ones = !navigator_.uncertain()};
  const double first_yaw = navigator_.pose().yaw_rad + kPi / 2.0;
  for (int ring = 0; ring <= rings; ++ring) {
    const int points = ring == 0 ? 1 : 6 * ring;
    const double radius_m = ring * config_.read_radius_m * 1.4;
    for (int i = 0; i < points; ++i) {
      const double angle = first_yaw + 2.0 * kPi * i / points;
      const Vec2 p = around_M_m + radius_m * Vec2{std::cos(angle), std::sin(angle)};
      if (trust == TrustFloor::kYes && navigator_.floor().blocks(p, p, config_.sure_clearance_m)) {
        continue;
      }
      co_await creep_to(p, wanted);
      if (over_wanted(wanted)) {
        const std::optional<MoveEnd> end = judge_tag(*navigator_.tag_in_field(), from, target);
        if (end && *end != MoveEnd::kLost) {
          co_await pilot_.brake();
          navigator_.relocate(at_);
          co_await hold_for_write(at_);
          co_return end;
        }
      }
    }
  }
  co_return std::nullopt;
}

std::vector<Tile> TileMover::visited_by_distance(const Vec2& from_M_m) const {
  std::vector<Tile> tiles;
  for (const auto& [tile, tag] : map_.tiles()) {
    tiles.push_back(tile);
  }
  std::stable_sort(tiles.begin(), tiles.end(), [&](Tile a, Tile b) {
    return (navigator_.centre_m(a) - from_M_m).squaredNorm() <
           (navigator_.centre_m(b) - from_M_m).squaredNorm();
  });
  return tiles;
}

Task<bool> TileMover::recover() {
  dare(Squeeze::kNo);
  std::vector<Tile> nearby = visited_by_distance(navigator_.pose().p_m);
  nearby.resize(std::min(nearby.size(), kKnownTried));
  for (const Tile tile : nearby) {
    const MoveEnd end = co_await approach(tile, kPlansToKnown);
    if (end == MoveEnd::kArrived) {
      co_return true;
    }
  }
  const auto found = co_await search(std::nullopt, at_, kRecoverRings, TrustFloor::kYes);
  if (found) {
    co_return true;
  }
  const bool met = co_await wander();
  co_return met;
}

Task<bool> TileMover::wander() {
  // What was felt from a wrong place may wall the robot in: at last only touch counts.
  const TagWanted known_ones{.ignored = std::nullopt, .new_ones = false};
  for (int leg = 0; leg < kWanderLegs; ++leg) {
    const double yaw = wrap_angle(navigator_.pose().yaw_rad + kWanderTurn_rad);
    const Vec2 there = navigator_.pose().p_m + kWanderLeg_m * Vec2{std::cos(yaw), std::sin(yaw)};
    co_await creep_to(there, known_ones);
    if (over_wanted(known_ones)) {
      arrive(*map_.tile_of(*navigator_.tag_in_field()), *navigator_.tag_in_field(), false);
      co_await pilot_.brake();
      co_return true;
    }
  }
  co_return false;
}

}  // namespace sensotwin::robot
