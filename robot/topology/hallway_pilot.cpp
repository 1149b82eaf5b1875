// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_pilot.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Line law w = -K (psi + atan(e / L)), as on carpets; L longer, for walls are known to centimetres only.
constexpr double kTurnGain_1ps = 2.0;
constexpr double kLookahead_m = 0.8;
/// Steeper it does not go for the middle: walls are seen while it goes along them.
constexpr double kApproach_rad = rad_from_deg(10.0);
constexpr double kFollowTurnMax_radps = 0.8;
/// A turn ends here; the line law takes the rest.
constexpr double kTurnDone_rad = 0.02;
/// Slowest useful turn: the wheels' speed steps of 28.5 mm/s (Open Interface, opcode 137) make 0.24 rad/s.
constexpr double kTurnMin_radps = 0.25;
constexpr double kTurnAcceleration_radps2 = 3.0;
/// Between the shell and a wall or a box. Chosen: three times what the middle is kept to.
constexpr double kClearance_m = 0.12;
/// Passing something: how slowly, how far back before, how far on beside it. Chosen: a box or a person.
constexpr double kPass_mps = 0.15;
constexpr double kPassBack_m = 0.45;
constexpr double kPassBeside_m = 1.6;
/// How steeply it swings out, and how far aside at first and when that was too little. Chosen: half a robot
/// and its clearance, and a hand more each time.
constexpr double kPassOut_rad = 0.25 * kPi;
/// The rest hardly brings it nearer.
constexpr double kFartherOut_rad = rad_from_deg(80.0);
constexpr double kFirstAside_m = 0.30;
constexpr double kNextAside_m = 0.15;
/// At most so far: there is room for more than a box or a person there.
constexpr double kAside_m = 1.5;
/// Where no wall has been seen on a side there is an opening, and it is not gone into. Chosen.
constexpr double kUnseenWall_m = 0.9;
/// It is beside what it passes where the way ahead is free for so much. Chosen: farther than that stood ahead
/// before it swung out.
constexpr double kPassClear_m = 0.75;
/// Nearer than this while it passes, and it has not swung out enough: what is beside it within 0.25 m of its
/// middle looks so near to the sonars 20 degrees off its bow.
constexpr double kPassStop_m = 0.25;

}  // namespace

void HallwayPilot::command(double speed_mps, double turn_radps) {
  speed_mps_ = speed_mps;
  const double half = turn_radps * config_.wheel_base_m / 2.0;
  step_.command.wheels = {.left_mps = speed_mps - half, .right_mps = speed_mps + half};
}

double HallwayPilot::ramped(double speed_mps) const {
  const double most = config_.acceleration_mps2 * to_s(kTick);
  return speed_mps_ + std::clamp(speed_mps - speed_mps_, -most, most);
}

void HallwayPilot::follow(double speed_mps, bool by_walls) {
  const double across_m = straight_on_ || !by_walls ? 0.0 : tracker_.left_of_line_m().value_or(0.0);
  const double astray_rad =
      tracker_.off_axis_rad() + std::clamp(std::atan(across_m / kLookahead_m), -kApproach_rad, kApproach_rad);
  command(ramped(speed_mps),
          std::clamp(-kTurnGain_1ps * astray_rad, -kFollowTurnMax_radps, kFollowTurnMax_radps));
}

Task<> HallwayPilot::brake() {
  if (bumped()) {
    command(0.0, 0.0);
  }
  while (std::abs(speed_mps_) > 1e-3) {
    command(ramped(0.0), 0.0);
    co_await step_.next;
  }
  command(0.0, 0.0);
  co_await step_.next;
}

Task<> HallwayPilot::turn_by_heading(double heading_rad) {
  double turn_radps = 0.0;
  for (;;) {
    const double left_rad = wrap_angle(heading_rad - tracker_.heading_rad().value_or(heading_rad));
    if (std::abs(left_rad) < kTurnDone_rad) {
      break;
    }
    const double fastest = std::sqrt(kTurnAcceleration_radps2 * std::abs(left_rad));
    const double wanted = std::copysign(std::clamp(fastest, kTurnMin_radps, config_.turn_radps), left_rad);
    const double most = kTurnAcceleration_radps2 * to_s(kTick);
    turn_radps += std::clamp(wanted - turn_radps, -most, most);
    command(0.0, turn_radps);
    co_await step_.next;
  }
  command(0.0, 0.0);
  co_await step_.next;
}

Task<> HallwayPilot::turn_to(double heading_rad) {
  co_await brake();
  tracker_.leave();
  co_await turn_by_heading(heading_rad);
}

Task<> HallwayPilot::face_axis() {
  co_await brake();
  co_await turn_by_heading(*tracker_.axis_rad());
}

Task<> HallwayPilot::advance(double way_m) {
  const double end_m = tracker_.way_m() + way_m;
  for (;;) {
    const double left_m = end_m - tracker_.way_m();
    const double free_m = tracker_.ahead_m().value_or(config_.sonar_range_m) - kClearance_m;
    if (left_m <= 0.0 || free_m <= 0.0 || bumped()) {
      break;
    }
    const double stopping_mps = std::sqrt(2.0 * config_.acceleration_mps2 * std::min(left_m, free_m));
    follow(std::min(config_.speed_mps, stopping_mps + 0.01));
    co_await step_.next;
  }
  co_await brake();
}

Task<> HallwayPilot::back(double way_m) {
  co_await brake();
  const double end_m = tracker_.way_m() - way_m;
  while (tracker_.way_m() > end_m) {
    command(-std::min(kPass_mps, std::sqrt(config_.acceleration_mps2 * (tracker_.way_m() - end_m)) + 0.02),
            0.0);
    co_await step_.next;
  }
  co_await brake();
}

Task<> HallwayPilot::wait(Duration time) {
  const Instant until = step_.sensed.stamp + time;
  command(0.0, 0.0);
  while (step_.sensed.stamp < until && in_the_way()) {
    co_await step_.next;
  }
}

Task<bool> HallwayPilot::pass_on(bool left) {
  co_await back(kPassBack_m);
  const double axis_rad = *tracker_.axis_rad();
  const std::optional<double>& wall_m = (left ? tracker_.left() : tracker_.right()).last_m;
  const double room_m = std::min(wall_m.value_or(kUnseenWall_m) - config_.radius_m - kClearance_m, kAside_m);
  bool passed = false;
  double aside_m = 0.0;
  straight_on_ = true;
  for (double step_m = kFirstAside_m; !passed && aside_m + step_m < room_m; step_m = kNextAside_m) {
    const double out_rad = aside_m > 0.0 ? kFartherOut_rad : kPassOut_rad;
    const double heading_rad = wrap_angle(axis_rad + (left ? out_rad : -out_rad));
    co_await turn_by_heading(heading_rad);
    const double end_m = tracker_.way_m() + step_m / std::sin(out_rad);
    while (tracker_.way_m() < end_m && !bumped() &&
           tracker_.ahead_m().value_or(config_.sonar_range_m) > kClearance_m) {
      command(ramped(kPass_mps), 0.0);
      co_await step_.next;
    }
    aside_m += step_m;
    co_await brake();
    co_await turn_by_heading(axis_rad);
    if (bumped()) {
      break;
    }
    // What comes into the way after all asks for another step aside.
    passed = tracker_.ahead_m().value_or(config_.sonar_range_m) > kPassClear_m;
    const double beside_m = tracker_.way_m() + kPassBeside_m;
    while (passed && tracker_.way_m() < beside_m) {
      follow(kPass_mps);
      co_await step_.next;
      passed = tracker_.ahead_m().value_or(config_.sonar_range_m) > kPassStop_m && !bumped();
    }
    co_await brake();
    if (bumped()) {
      break;
    }
  }
  co_await brake();
  straight_on_ = false;
  if (!passed) {
    const double home_rad = wrap_angle(axis_rad + (left ? -0.5 : 0.5) * kPi);
    co_await turn_by_heading(home_rad);
    const double home_m = tracker_.way_m() + aside_m;
    while (tracker_.way_m() < home_m && !bumped()) {
      command(ramped(kPass_mps), 0.0);
      co_await step_.next;
    }
    co_await brake();
    co_await turn_by_heading(axis_rad);
  }
  co_return passed;
}

}  // namespace sensotwin::robot
