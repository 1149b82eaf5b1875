// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/mapping/floor_planner.hpp"
#include "robot/mapping/nudges.hpp"
#include "robot/mapping/route.hpp"
#include "robot/mapping/tile_mover.hpp"

namespace sensotwin::robot {
namespace {

/// The centre keeps this far from what the light bumper saw: the body less the error of pose and range, so
/// that a gap that might do is tried, and touch decides.
constexpr double kClearance_m = 0.150;
/// And at last, where nothing else is left to try.
constexpr double kTightClearance_m = 0.130;
constexpr double kTouchClearance_m = 0.115;
/// How far within its zone's rim the antenna should come to a tag; at last, hardly: something may stand
/// there.
constexpr double kInside_m = 0.03;
constexpr double kTightInside_m = 0.02;
constexpr double kTouchInside_m = 0.005;
/// What was touched this near the target is forgotten then, and what was seen from places known badly.
constexpr double kForget_m = 0.35;
constexpr double kComfort_m = 0.205;
/// The box searched for a way: round robot and target by these, one after the other.
constexpr double kNear_m = 0.8;
constexpr double kFar_m = 3.0;
/// A detour ends after so many plans; each one is spoilt by something newly felt.
constexpr int kPlansMax = 60;
constexpr int kPlansHome = 20;
constexpr int kPlansSqueezed = 12;
constexpr int kPlansByTouch = 5;
/// Where the target's tag should be, the pose better than this, or it is found out anew, so often; then
/// rings, 11 cm apart, of a search.
constexpr double kArrivedSigma_m = 0.04;
constexpr int kFixesMax = 2;
constexpr int kArrivedRings = 2;
/// Visited tiles near a target from which a way to it is looked for.
constexpr std::size_t kBases = 3;
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

std::vector<Vec2> TileMover::way(const Vec2& start_M_m, Tile target) const {
  const Vec2 goal = navigator_.centre_m(target);
  for (const double margin_m : {kNear_m, kFar_m}) {
    auto corners = plan_over_floor(
        navigator_.floor(),
        request_for(start_M_m, goal, config_.read_radius_m - inside_m_, margin_m, clearance_m_));
    if (!corners.empty()) {
      return corners;
    }
  }
  return {};
}

int TileMover::dare(Squeeze squeeze) {
  clearance_m_ = kClearance_m;
  inside_m_ = kInside_m;
  if (squeeze == Squeeze::kTight) {
    clearance_m_ = kTightClearance_m;
    inside_m_ = kTightInside_m;
    return kPlansSqueezed;
  }
  if (squeeze == Squeeze::kByTouch) {
    clearance_m_ = kTouchClearance_m;
    inside_m_ = kTouchInside_m;
    return kPlansByTouch;
  }
  return kPlansMax;
}

std::optional<Tile> TileMover::base_for(Tile target) const {
  const std::vector<Tile> known = visited_by_distance(navigator_.centre_m(target));
  for (std::size_t i = 0; i < std::min(known.size(), kBases); ++i) {
    if (!way(navigator_.centre_m(known[i]), target).empty()) {
      return known[i];
    }
  }
  return std::nullopt;
}

bool TileMover::way_seems_open(Tile target) {
  dare(Squeeze::kNo);
  return base_for(target).has_value();
}

Task<MoveEnd> TileMover::detour(Tile target, Squeeze squeeze) {
  const int plans_max = dare(squeeze);
  if (squeeze == Squeeze::kByTouch) {
    navigator_.floor().forget_doubtful(navigator_.centre_m(target), kForget_m);
  }
  ++log_.counts.detours;
  log_.add(io_.sensed.stamp, MissionEventKind::kDetourBegun, target);
  co_await settle();
  const bool direct = !way(navigator_.pose().p_m, target).empty();
  const std::optional<Tile> base = direct ? std::optional{at_} : base_for(target);
  MoveEnd end = MoveEnd::kBlocked;
  if (base) {
    co_await travel(*base);
    end = co_await approach(target, plans_max);
  }
  if (end == MoveEnd::kArrived) {
    log_.add(io_.sensed.stamp, MissionEventKind::kDetourDone, target);
    co_return end;
  }
  log_.add(io_.sensed.stamp, MissionEventKind::kUnreachable, target);
  if (base) {
    const bool home = co_await relocalise();
    if (!home) {
      co_return MoveEnd::kLost;
    }
  }
  co_return end == MoveEnd::kNoTag ? MoveEnd::kNoTag : MoveEnd::kBlocked;
}

Task<> TileMover::travel(Tile to) {
  for (const Tile step : shortest_route(map_, at_, heading_, {to})) {
    const Tile from = at_;
    if (std::abs(step.column - from.column) + std::abs(step.row - from.row) != 1) {
      co_return;  // carried off the route
    }
    const MoveEnd end = co_await go(step);
    if (end != MoveEnd::kArrived) {
      co_return;
    }
  }
  co_await settle();
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
  int fixes = 0;
  for (int plans = 0; plans < plans_max; ++plans) {
    if (navigator_.tag_in_field() && map_.tile_of(*navigator_.tag_in_field()) == target) {
      co_return MoveEnd::kArrived;
    }
    if ((navigator_.uncertain() || astray_) && !map_.visited(target)) {
      astray_ = false;
      const bool sure = co_await relocalise();
      if (!sure) {
        co_return MoveEnd::kLost;
      }
    }
    const std::vector<Vec2> corners = way(navigator_.pose().p_m, target);
    if (corners.empty()) {
      co_return MoveEnd::kBlocked;
    }
    const std::optional<MoveEnd> end = co_await walk(target, corners);
    if (end && *end != MoveEnd::kDisplaced) {
      co_return *end;
    }
    if (end || (navigator_.pose().p_m - goal).norm() > config_.read_radius_m - inside_m_ + kCorner_m) {
      continue;
    }
    // There, and nothing to read.
    if (!map_.visited(target) && navigator_.filter().position_sigma_m() > kArrivedSigma_m &&
        fixes++ < kFixesMax) {
      const bool sure = co_await relocalise();
      if (sure) {
        continue;
      }
      co_return MoveEnd::kLost;
    }
    const std::optional<MoveEnd> found =
        co_await search(std::nullopt, target, kArrivedRings, TrustFloor::kNo);
    co_return found.value_or(MoveEnd::kNoTag);
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
    Nudges nudges;
    for (;;) {
      const double along_m = line.along_m(navigator_.pose().p_m);
      const double left_to_go = way.norm() - along_m;
      if (left_to_go < kCorner_m / 2.0) {
        break;
      }
      if (const auto tag = navigator_.identified()) {
        const auto end = pass_tag(*tag, target);
        if (astray_) {
          co_await pilot_.brake();
          co_return std::nullopt;
        }
        if (end) {
          co_await pilot_.brake();
          co_await hold_for_write(at_);
          co_return end;
        }
      }
      if (pilot_.bumped() || pilot_.hazard()) {
        ++log_.counts.bumps;
        const int side = pilot_.bump_side();
        const bool hopeless = pilot_.hazard() || !nudges.away_from(side, along_m);
        if (hopeless) {
          navigator_.remember_bump(side, io_.sensed);
        }
        co_await pilot_.back_along(line, along_m - config_.back_off_m, nudges.aim_left_m());
        if (hopeless) {
          co_return std::nullopt;
        }
        continue;
      }
      if (navigator_.floor().revision() != revision &&
          navigator_.floor().blocks(navigator_.pose().p_m, corner, clearance_m_ - 0.01)) {
        co_await pilot_.brake();
        co_return std::nullopt;
      }
      pilot_.follow(line, std::min(config_.careful_speed_mps, pilot_.stopping_speed_mps(left_to_go) + 0.02),
                    nudges.aim_left_m());
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
  if (!map_.tile_of(tag) && misplaced(navigator_.nearest_tile(navigator_.pose().p_m))) {
    astray_ = true;
    return std::nullopt;
  }
  const auto end = judge_tag(tag, std::nullopt, target);
  // Known tags on the way are passed by; a new one is written first.
  return end == MoveEnd::kDisplaced && !write_pending_ ? std::nullopt : end;
}

}  // namespace sensotwin::robot
