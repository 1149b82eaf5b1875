// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "robot/mapping/floor_planner.hpp"
#include "robot/mapping/tile_mover.hpp"

namespace sensotwin::robot {
namespace {

/// The centre keeps this far from what the light bumper saw: the body less the error of pose and range, so
/// that a gap that might do is tried, and touch decides.
constexpr double kClearance_m = 0.150;
/// And at last, where nothing else is left to try.
constexpr double kTightClearance_m = 0.130;
constexpr double kComfort_m = 0.205;
/// The box searched for a way: round robot and target by these, one after the other.
constexpr double kNear_m = 0.8;
constexpr double kFar_m = 3.0;
/// A detour ends after so many plans; each one is spoilt by something newly felt.
constexpr int kPlansMax = 60;
constexpr int kPlansHome = 20;
constexpr int kPlansSqueezed = 12;
/// A corner is rounded when the robot is this near.
constexpr double kCorner_m = 0.03;

PlanRequest request_for(const Vec2& start, const Vec2& goal, double goal_radius_m, double margin_m,
                        double clearance_m) {
  const Vec2 margin{margin_m, margin_m};
  return {.start_M_m = start,
          .goal_M_m = goal,
          .goal_radius_m = goal_radius_m,
          .clearance_m = clearance_m,
          .comfort_m = kComfort_m,
          .low_M_m = start.cwiseMin(goal) - margin,
          .high_M_m = start.cwiseMax(goal) + margin};
}

}  // namespace

std::vector<Vec2> TileMover::way_to(Tile target) const {
  const Vec2 goal = navigator_.centre_m(target);
  const double goal_radius_m = config_.read_radius_m - 0.03;
  for (const double margin_m : {kNear_m, kFar_m}) {
    const auto corners = plan_over_floor(
        navigator_.floor(), request_for(navigator_.pose().p_m, goal, goal_radius_m, margin_m, clearance_m_));
    if (!corners.empty()) {
      return corners;
    }
  }
  return {};
}

Task<MoveEnd> TileMover::detour(Tile target, Squeeze squeeze) {
  clearance_m_ = squeeze == Squeeze::kYes ? kTightClearance_m : kClearance_m;
  ++log_.counts.detours;
  log_.add(io_.sensed.stamp, MissionEventKind::kDetourBegun, target);
  co_await settle();
  const MoveEnd end = co_await approach(target, squeeze == Squeeze::kYes ? kPlansSqueezed : kPlansMax);
  if (end == MoveEnd::kArrived) {
    log_.add(io_.sensed.stamp, MissionEventKind::kDetourDone, target);
    co_return end;
  }
  log_.add(io_.sensed.stamp, MissionEventKind::kUnreachable, target);
  const bool home = co_await relocalise();
  if (!home) {
    co_return MoveEnd::kLost;
  }
  co_return end == MoveEnd::kNoTag ? MoveEnd::kNoTag : MoveEnd::kBlocked;
}

Task<bool> TileMover::relocalise() {
  const MoveEnd home = co_await approach(at_, kPlansHome);
  if (home == MoveEnd::kArrived) {
    co_return true;
  }
  const bool found = co_await recover();
  co_return found;
}

Task<MoveEnd> TileMover::approach(Tile target, int plans_max) {
  const Vec2 goal = navigator_.centre_m(target);
  for (int plans = 0; plans < plans_max; ++plans) {
    if (navigator_.tag_in_field() && map_.tile_of(*navigator_.tag_in_field()) == target) {
      co_return MoveEnd::kArrived;
    }
    if (navigator_.uncertain() && !map_.visited(target)) {
      const bool sure = co_await relocalise();
      if (!sure) {
        co_return MoveEnd::kLost;
      }
    }
    const std::vector<Vec2> corners = way_to(target);
    if (corners.empty()) {
      co_return MoveEnd::kBlocked;
    }
    const std::optional<MoveEnd> end = co_await walk(target, corners);
    if (end && *end != MoveEnd::kDisplaced) {
      co_return *end;
    }
    if (!end && (navigator_.pose().p_m - goal).norm() < config_.read_radius_m - 0.02) {
      co_return MoveEnd::kNoTag;  // there, and nothing to read
    }
  }
  co_return MoveEnd::kBlocked;
}

Task<std::optional<MoveEnd>> TileMover::walk(Tile target, std::vector<Vec2> corners) {
  const std::uint64_t revision = navigator_.floor().revision();
  for (const Vec2& corner : corners) {
    const Vec2 way = corner - navigator_.pose().p_m;
    if (way.norm() < kCorner_m) {
      continue;
    }
    const Line line{navigator_.pose().p_m, std::atan2(way.y(), way.x())};
    if (std::abs(wrap_angle(line.yaw_rad - navigator_.pose().yaw_rad)) > rad_from_deg(12)) {
      co_await pilot_.turn_to(line.yaw_rad);
    }
    for (;;) {
      const double left_to_go = way.norm() - line.along_m(navigator_.pose().p_m);
      if (left_to_go < kCorner_m / 2.0) {
        break;
      }
      if (const auto tag = navigator_.identified()) {
        if (const auto end = pass_tag(*tag, target)) {
          co_await pilot_.brake();
          co_await hold_for_write(at_);
          co_return end;
        }
      }
      if (pilot_.bumped() || pilot_.hazard()) {
        ++log_.counts.bumps;
        navigator_.remember_bump(pilot_.bump_side(), io_.sensed);
        co_await pilot_.back_along(line, line.along_m(navigator_.pose().p_m) - config_.back_off_m, 0.0);
        co_return std::nullopt;
      }
      if (navigator_.floor().revision() != revision &&
          navigator_.floor().blocks(navigator_.pose().p_m, corner, clearance_m_ - 0.01)) {
        co_await pilot_.brake();
        co_return std::nullopt;
      }
      pilot_.follow(line, std::min(config_.careful_speed_mps, pilot_.stopping_speed_mps(left_to_go) + 0.02),
                    0.0);
      co_await io_.next;
    }
  }
  co_await pilot_.brake();
  co_return std::nullopt;
}

std::optional<MoveEnd> TileMover::pass_tag(TagUid tag, Tile target) {
  if (map_.tile_of(tag) == at_ && at_ != target) {
    return std::nullopt;
  }
  if (!map_.tile_of(tag) && navigator_.uncertain()) {
    return std::nullopt;  // a new tag, but who knows which
  }
  const auto end = judge_tag(tag, std::nullopt, target);
  // Known tags on the way are passed by; a new one is written first.
  return end == MoveEnd::kDisplaced && !write_pending_ ? std::nullopt : end;
}

}  // namespace sensotwin::robot
