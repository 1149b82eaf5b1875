// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Of each compass reading. Chosen: at 10 Hz the heading follows within five seconds, and a reading's degree
/// of noise shrinks to a tenth.
constexpr double kCompassGain = 0.02;
/// A compass so far off is disturbed. Chosen: 20 times its noise.
constexpr double kDisturbed_rad = rad_from_deg(20.0);
/// Of each slope; a slope over 0.5 m with 1 cm of noise is good to 1.5 degrees, and neighbours share
/// readings.
constexpr double kWallGain = 0.06;
constexpr double kSlopeWay_m = 0.5;
/// A wall does not jump; a doorway's edge does. Chosen: five times the noise of a reading.
constexpr double kJump_m = 0.06;
/// Walls are believed while the robot goes along them. Chosen: cosines differ from 1 by 3 %.
constexpr double kAlong_rad = rad_from_deg(15.0);
/// Farther than this beyond where the wall should be, there is an opening. Chosen.
constexpr double kOpening_m = 0.5;
/// Readings without a jump that make a wall, and a wall that the width may be measured by. Chosen: 0.1 and
/// 0.25 m of way.
constexpr std::size_t kWall = 3;
constexpr std::size_t kFirm = 8;
/// Of the measured width. Chosen: a second's readings.
constexpr double kWidthGain = 0.1;

}  // namespace

HallwayTracker::HallwayTracker(const HallwayConfig& config)
    : config_(config), width_m_(config.hallway_width_m) {}

void HallwayTracker::enter(CompassPoint axis) {
  axis_ = axis;
  way_m_ = 0.0;
  width_m_ = config_.hallway_width_m;
  sides_ = {};
  trails_ = {};
  seen_at_m_ = {};
}

void HallwayTracker::correct(int quarter_turns_right) {
  if (heading_rad_) {
    heading_rad_ = wrap_angle(*heading_rad_ - 0.5 * kPi * quarter_turns_right);
  }
}

double HallwayTracker::off_axis_rad() const {
  return wrap_angle(heading_rad_.value_or(0.0) - yaw_rad_of(*axis_));
}

void HallwayTracker::step(const HallwaySensed& sensed) {
  const double left_m = sensed.counts_left * config_.metres_per_count;
  const double right_m = sensed.counts_right * config_.metres_per_count;
  way_m_ += 0.5 * (left_m + right_m);
  if (heading_rad_) {
    heading_rad_ = wrap_angle(*heading_rad_ + (right_m - left_m) / config_.wheel_base_m);
  }
  if (sensed.compass_rad) {
    take_compass(*sensed.compass_rad);
  }
  if (sensed.ranges_m) {
    take_ranges(*sensed.ranges_m);
  }
}

void HallwayTracker::take_compass(double compass_rad) {
  const double measured_rad = wrap_angle(compass_rad - config_.plan_north_rad);
  if (!heading_rad_) {
    heading_rad_ = measured_rad;
    return;
  }
  const double off_rad = wrap_angle(measured_rad - *heading_rad_);
  if (std::abs(off_rad) < kDisturbed_rad) {
    heading_rad_ = wrap_angle(*heading_rad_ + kCompassGain * off_rad);
  }
}

void HallwayTracker::take_ranges(const SonarRanges& ranges_m) {
  ahead_m_.reset();
  for (std::size_t i = 0; i < kSonars; ++i) {
    // What the robot would touch if it went straight on: in a strip as wide as itself.
    const double bearing_rad = config_.sonar_bearings_rad[i];
    if (!ranges_m[i] || std::abs(bearing_rad) > 0.25 * kPi) {
      continue;
    }
    const double from_middle_m = *ranges_m[i] + config_.sonar_radius_m;
    if (from_middle_m * std::abs(std::sin(bearing_rad)) > config_.radius_m + 0.05) {
      continue;
    }
    const double free_m = from_middle_m * std::cos(bearing_rad) - config_.radius_m;
    ahead_m_ = std::max(0.0, std::min(ahead_m_.value_or(free_m), free_m));
  }
  if (axis_ && heading_rad_ && std::abs(off_axis_rad()) < kAlong_rad) {
    take_side(0, ranges_m.front());
    take_side(1, ranges_m.back());
    if (sides_[0].distance_m && sides_[1].distance_m && trails_[0].count > kFirm &&
        trails_[1].count > kFirm) {
      width_m_ += kWidthGain * (*sides_[0].distance_m + *sides_[1].distance_m - width_m_);
    }
  } else {
    for (std::size_t side = 0; side < sides_.size(); ++side) {
      sides_[side].distance_m.reset();
      trails_[side].count = 0;
    }
  }
}

void HallwayTracker::take_side(std::size_t side, const std::optional<double>& range_m) {
  WallSide& wall = sides_[side];
  Trail& trail = trails_[side];
  const double nearest_m = range_m ? *range_m + config_.sonar_radius_m : config_.sonar_range_m;
  const double expected_m = 0.5 * width_m_ + std::abs(left_of_middle_m().value_or(0.0));
  if (!range_m || nearest_m > expected_m + kOpening_m) {
    wall.distance_m.reset();
    wall.open_for_m = way_m_ - seen_at_m_[side];
    trail.count = 0;
    return;
  }
  if (wall.open_for_m > 0.0) {
    wall.opening_m = wall.open_for_m;
    wall.opening_middle_m = 0.5 * (seen_at_m_[side] + way_m_);
    wall.open_for_m = 0.0;
  }
  seen_at_m_[side] = way_m_;
  if (trail.count > 0 && std::abs(trail.at[trail.count - 1].distance_m - nearest_m) > kJump_m) {
    trail.count = 0;
  }
  if (trail.count == trail.at.size()) {
    std::copy(trail.at.begin() + 1, trail.at.end(), trail.at.begin());
    --trail.count;
  }
  trail.at[trail.count++] = {way_m_, nearest_m, off_axis_rad()};
  // The edge of a doorway, a box: seen for a moment, no wall.
  wall.distance_m = trail.count >= kWall ? std::optional{nearest_m} : std::nullopt;
  take_slope(side);
}

void HallwayTracker::take_slope(std::size_t side) {
  const Trail& trail = trails_[side];
  if (trail.count < 6 || trail.at[trail.count - 1].way_m - trail.at[0].way_m < kSlopeWay_m) {
    return;
  }
  double way = 0.0;
  double distance = 0.0;
  double headed = 0.0;
  for (std::size_t i = 0; i < trail.count; ++i) {
    way += trail.at[i].way_m;
    distance += trail.at[i].distance_m;
    headed += trail.at[i].off_axis_rad;
  }
  const auto n = static_cast<double>(trail.count);
  double both = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < trail.count; ++i) {
    const double off = trail.at[i].way_m - way / n;
    both += off * (trail.at[i].distance_m - distance / n);
    squares += off * off;
  }
  // Going to the left, the left wall comes nearer and the right one goes away.
  const double slope_rad = (side == 0 ? -1.0 : 1.0) * both / squares;
  heading_rad_ = wrap_angle(*heading_rad_ + kWallGain * (slope_rad - headed / n));
}

std::optional<double> HallwayTracker::left_of_middle_m() const {
  const std::optional<double>& left = sides_[0].distance_m;
  const std::optional<double>& right = sides_[1].distance_m;
  if (left && right) {
    return 0.5 * (*right - *left);
  }
  if (left) {
    return 0.5 * width_m_ - *left;
  }
  if (right) {
    return *right - 0.5 * width_m_;
  }
  return std::nullopt;
}

}  // namespace sensotwin::robot
