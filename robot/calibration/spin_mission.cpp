// SPDX-License-Identifier: MIT
#include "robot/calibration/spin_mission.hpp"

#include <cmath>
#include <cstddef>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {
namespace {

/// Two minutes of a reader's thousand reads a second. Chosen: a drive takes less.
constexpr std::size_t kMostReads = 120000;

}  // namespace

SpinMission::SpinMission(const WheelModel& wheels, const Epc& tag, const SpinPlan& plan)
    : wheels_(wheels), tag_(tag), plan_(plan), task_(run()) {}

WheelSpeeds SpinMission::step(const Sensed& sensed, std::span<const UhfRead> reads) {
  moved_ = wheel_step(wheels_, sensed.counts_left, sensed.counts_right);
  reckoning_.drive(sensed.stamp, moved_);
  if (!done() && (sensed.wheel_drop || sensed.cliff)) {
    fault_ = SpinFault::kLifted;
  } else if (!done() && (sensed.bump_left || sensed.bump_right)) {
    fault_ = SpinFault::kBumped;
  }
  if (done()) {
    return {};
  }
  keep(reads);
  if (!started_) {
    started_ = true;
    task_.start();
  } else {
    next_step_.resume();
  }
  return done() ? WheelSpeeds{} : command_;
}

void SpinMission::keep(std::span<const UhfRead> reads) {
  for (const UhfRead& read : reads) {
    if (turning_ && read.epc == tag_ && reads_.size() < kMostReads) {
      reads_.push_back({read, reckoning_.pose_at(read.at), spot_});
    }
  }
}

Task<> SpinMission::turn(double turns) {
  const double sign = turns > 0.0 ? 1.0 : -1.0;
  const double wheel_mps = sign * plan_.turn_radps * wheels_.wheel_base_m / 2.0;
  command_ = {.left_mps = -wheel_mps, .right_mps = wheel_mps};
  turning_ = true;
  for (double turned_rad = 0.0; turned_rad < std::abs(turns) * 2.0 * kPi;) {
    co_await next_step_;
    turned_rad += sign * moved_.turn_rad;
  }
  turning_ = false;
  command_ = {};
}

Task<> SpinMission::roll(double way_m) {
  const double sign = way_m > 0.0 ? 1.0 : -1.0;
  command_ = {.left_mps = sign * plan_.speed_mps, .right_mps = sign * plan_.speed_mps};
  for (double rolled_m = 0.0; rolled_m < std::abs(way_m);) {
    co_await next_step_;
    rolled_m += sign * moved_.forward_m;
  }
  command_ = {};
}

Task<> SpinMission::run() {
  const auto spots = static_cast<std::size_t>(plan_.spots);
  for (spot_ = 0; spot_ < spots; ++spot_) {
    const double half = 0.5 * plan_.turns;
    co_await turn(half);
    if (reads_.empty()) {
      fault_ = SpinFault::kNotHeard;
      co_return;
    }
    co_await turn(-half);
    co_await roll(spot_ + 1 < spots ? plan_.step_m : -(plan_.spots - 1) * plan_.step_m);
  }
}

}  // namespace sensotwin::robot
