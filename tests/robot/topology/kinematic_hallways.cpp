// SPDX-License-Identifier: MIT
#include "tests/robot/topology/kinematic_hallways.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

constexpr double kBox_m = 0.25;
constexpr double kRayStep_m = 0.02;

/// W: x east, y north; a yaw of W is counter-clockwise from east, the plan's from north.
double yaw_W(double plan_rad) {
  return wrap_angle(plan_rad + 0.5 * kPi);
}

}  // namespace

KinematicHallways::KinematicHallways(const HallwayMap& map, double width_m, const Pose2& X_WR,
                                     HallwayFaults faults, RandomStream random)
    : X_WR_(X_WR), faults_(std::move(faults)), random_(random) {
  base_m_ = config_.wheel_base_m * (1.0 + faults_.wheel_base_error * random_.normal());
  const Vec2 half_m{0.5 * width_m, 0.5 * width_m};
  for (const HallwayNode& node : map.nodes()) {
    for (const CompassPoint point : kCompassPoints) {
      const Side& side = node.side(point);
      const Vec2 out{std::cos(yaw_W(yaw_rad_of(point))), std::sin(yaw_W(yaw_rad_of(point)))};
      if (side.hallway == Hallway::kLeadsTo) {
        const Vec2 a = *node.at_m;
        const Vec2 b = *map.node(side.to).at_m;
        strips_.push_back({a.cwiseMin(b) - half_m, a.cwiseMax(b) + half_m});
      }
      for (const TagNumber tag : side.tags) {
        spots_.push_back({*node.at_m + config_.tag_to_middle_m * out, tag});
      }
    }
  }
}

bool KinematicHallways::free(const Vec2& p_m) const {
  const bool inside = std::any_of(strips_.begin(), strips_.end(), [&](const Strip& strip) {
    return (p_m.array() >= strip.low_m.array()).all() && (p_m.array() <= strip.high_m.array()).all();
  });
  return inside && std::none_of(faults_.boxes_m.begin(), faults_.boxes_m.end(),
                                [&](const Vec2& box) { return (box - p_m).norm() < kBox_m; });
}

bool KinematicHallways::room_at(const Vec2& p_m) const {
  for (int i = 0; i < 16; ++i) {
    const double around = 2.0 * kPi * i / 16.0;
    if (!free(p_m + config_.radius_m * Vec2{std::cos(around), std::sin(around)})) {
      return false;
    }
  }
  return true;
}

std::optional<double> KinematicHallways::range_m(double bearing_rad) const {
  double nearest_m = config_.sonar_range_m;
  for (const double off_deg : {-14.0, -7.0, 0.0, 7.0, 14.0}) {
    const double yaw = X_WR_.yaw_rad + bearing_rad + rad_from_deg(off_deg);
    const Vec2 from_m = X_WR_ * Vec2{config_.sonar_radius_m * std::cos(bearing_rad),
                                     config_.sonar_radius_m * std::sin(bearing_rad)};
    for (double r = 0.0; r < nearest_m; r += kRayStep_m) {
      if (!free(from_m + r * Vec2{std::cos(yaw), std::sin(yaw)})) {
        nearest_m = r;
        break;
      }
    }
  }
  return nearest_m < config_.sonar_range_m ? std::optional{nearest_m} : std::nullopt;
}

HallwaySensed KinematicHallways::sense() {
  now_ += kTick;
  ++tick_;
  HallwaySensed sensed;
  sensed.stamp = now_;
  sensed.counts_left = static_cast<int>(std::floor(left_counts_));
  sensed.counts_right = static_cast<int>(std::floor(right_counts_));
  left_counts_ -= sensed.counts_left;
  right_counts_ -= sensed.counts_right;
  sensed.bump_left = bumped_;
  sensed.bump_right = bumped_;
  if (tick_ % 7 == 0) {
    sensed.compass_rad = wrap_angle(X_WR_.yaw_rad - 0.5 * kPi + compass_off_rad_ +
                                    faults_.compass_sigma_rad * random_.normal());
    SonarRanges ranges;
    for (std::size_t i = 0; i < kSonars; ++i) {
      ranges[i] = range_m(config_.sonar_bearings_rad[i]);
      if (ranges[i]) {
        ranges[i] = std::max(0.03, *ranges[i] + faults_.range_sigma_m * random_.normal());
      }
      if (random_.chance(faults_.ranges_lost)) {
        ranges[i].reset();
      }
    }
    sensed.ranges_m = ranges;
  }
  for (const Spot& spot : spots_) {
    if ((spot.at_m - X_WR_.p_m).norm() > config_.tag_reach_m) {
      over_.erase(spot.tag);
    } else if (over_.insert(spot.tag).second && !random_.chance(faults_.tags_missed)) {
      sensed.tag = spot.tag;
    }
  }
  return sensed;
}

void KinematicHallways::drive(const HallwayCommand& command) {
  const double dt = to_s(kTick);
  left_counts_ += command.wheels.left_mps * dt / config_.metres_per_count;
  right_counts_ += command.wheels.right_mps * dt / config_.metres_per_count;
  const double forward_m = 0.5 * (command.wheels.left_mps + command.wheels.right_mps) * dt;
  const double turn_rad = (command.wheels.right_mps - command.wheels.left_mps) * dt / base_m_;
  Pose2 next = X_WR_;
  next.yaw_rad = wrap_angle(next.yaw_rad + turn_rad);
  next.p_m += forward_m * Vec2{std::cos(next.yaw_rad), std::sin(next.yaw_rad)};
  bumped_ = !room_at(next.p_m);
  if (bumped_) {
    ++touches_;
    next.p_m = X_WR_.p_m;
  }
  way_m_ += (next.p_m - X_WR_.p_m).norm();
  X_WR_ = next;
}

}  // namespace sensotwin::robot
