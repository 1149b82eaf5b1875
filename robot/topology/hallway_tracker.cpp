// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "robot/base/rolled_wheels.hpp"

namespace sensotwin::robot {
namespace {

/// Of each compass reading. Chosen: at 10 Hz the heading follows within five seconds, and a reading's degree
/// of noise shrinks to a tenth.
constexpr double kCompassGain = 0.02;
/// A compass so far off is disturbed. Chosen: 20 times its noise.
constexpr double kDisturbed_rad = rad_from_deg(20.0);
/// Nobody drives between two readings who has moved less: at 0.3 m/s it is 3 cm. Chosen: below that, above
/// what it does while somebody lets go of it.
constexpr double kStood_m = 0.02;
/// So many readings that agree to so much are a direction, within so much way, and a hand turns by more than
/// so much. Chosen: half a second; ten times the noise; a second's way; half of a quarter turn.
constexpr std::size_t kSteadyReadings = 5;
constexpr double kSteady_rad = rad_from_deg(10.0);
constexpr double kSteadyWay_m = 0.6;
constexpr double kByHand_rad = rad_from_deg(45.0);
/// Of what the compass says beyond the heading, in the mean that walls are judged by. Chosen: two seconds.
constexpr double kCompassMean = 0.05;
/// Walls that converge by more say nothing of the hallway's direction. Chosen: twice the slope's noise.
constexpr double kParallel_rad = rad_from_deg(5.0);
/// Farther than this walls do not lead the heading away from what the compass says: they are aslant. Chosen:
/// buildings are drawn to the degree, and a compass on a robot is good to some.
constexpr double kAslant_rad = rad_from_deg(5.0);
/// Of each slope; a slope over 0.5 m with 1 cm of noise is good to 1.5 degrees, and neighbours share
/// readings.
constexpr double kWallGain = 0.06;
constexpr double kSlopeWay_m = 0.5;
/// A wall does not jump; a doorway's edge does. Chosen: five times the noise of a reading.
constexpr double kJump_m = 0.05;
/// Of each sight of a wall. Chosen: noise of 1 cm shrinks to 4 mm.
constexpr double kSightGain = 0.3;
/// A wall that is not seen for less is still there: echoes get lost. Chosen: three readings.
constexpr double kBlink_m = 0.10;
/// Walls are believed while the robot goes along them. Chosen: cosines differ from 1 by 3 %.
constexpr double kAlong_rad = rad_from_deg(15.0);
/// Farther than this beyond where the wall was, there is an opening; what is less deep is a recess. Chosen.
constexpr double kOpening_m = 1.2;
/// A first wall is looked for within this: half of the widest hallway that sonars of 5 m see both walls of
/// from anywhere in it.
constexpr double kFarthestWall_m = 2.75;
/// Where it was open for so long, the hallway has become wider on that side, and any wall will do. Chosen:
/// wider than the hallways that cross.
constexpr double kWidened_m = 3.5;
/// Sonars that look forward.
constexpr std::size_t kForward = 3;
/// The end of a hallway is flat to this, as the three forward sonars see it. Chosen: 10 degrees askew at half
/// a metre, and noise.
constexpr double kFlat_m = 0.15;
/// Readings without a jump that make a wall, and a wall that the width may be measured by. Chosen: 0.1 and
/// 0.25 m of way.
constexpr std::size_t kWall = 3;
constexpr std::size_t kFirm = 8;
/// Over so much way a wall is seen before anything is concluded from it: corners of a junction stand still
/// only while the robot does. Chosen.
constexpr double kFirmWay_m = 0.15;
/// Of the measured width. Chosen: a second's readings.
constexpr double kWidthGain = 0.1;

}  // namespace

HallwayTracker::HallwayTracker(const HallwayConfig& config)
    : config_(config), width_m_(config.hallway_width_m) {}

void HallwayTracker::enter(double axis_rad) {
  axis_rad_ = axis_rad;
  way_m_ = 0.0;
  along_m_ = 0.0;
  measured_ = false;
  flanks_ = {};
}

void HallwayTracker::correct(double left_rad) {
  if (heading_rad_) {
    heading_rad_ = wrap_angle(*heading_rad_ + left_rad);
    compass_ahead_rad_ = 0.0;
    agreed_m_.reset();
    stood_ = false;
  }
}

double HallwayTracker::off_axis_rad() const {
  return wrap_angle(heading_rad_.value_or(0.0) - *axis_rad_);
}

void HallwayTracker::step(const HallwaySensed& sensed) {
  const auto [left_m, right_m] = rolled_m(config_, sensed.counts_left, sensed.counts_right);
  const double driven_m = 0.5 * (left_m + right_m);
  way_m_ += driven_m;
  path_m_ += std::abs(driven_m);
  if (axis_rad_ && heading_rad_) {
    along_m_ += driven_m * std::cos(off_axis_rad());
    const double leftwards_m = driven_m * std::sin(off_axis_rad());
    flanks_[0].moved_m += leftwards_m;
    flanks_[1].moved_m -= leftwards_m;
  }
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
    agreed_m_ = path_m_;
    return;
  }
  const double off_rad = wrap_angle(measured_rad - *heading_rad_);
  if (std::abs(off_rad) < kDisturbed_rad) {
    heading_rad_ = wrap_angle(*heading_rad_ + kCompassGain * off_rad);
    compass_ahead_rad_ += kCompassMean * (off_rad - compass_ahead_rad_);
    agreed_m_ = path_m_;
    agreed_rad_ = off_rad;
    astray_readings_ = 0;
  } else {
    take_astray(off_rad);
  }
}

void HallwayTracker::take_astray(double off_rad) {
  if (astray_readings_ == 0) {
    stood_ = agreed_m_ && path_m_ - *agreed_m_ < kStood_m;
  }
  const bool same = astray_readings_ > 0 && std::abs(wrap_angle(off_rad - astray_rad_)) < kSteady_rad;
  astray_readings_ = same ? astray_readings_ + 1 : 1;
  astray_rad_ = same ? astray_rad_ : off_rad;
  const double turned_rad = wrap_angle(off_rad - agreed_rad_);
  if (stood_ && astray_readings_ >= kSteadyReadings && path_m_ - *agreed_m_ < kSteadyWay_m &&
      std::abs(turned_rad) > kByHand_rad) {
    correct(turned_rad);
    astray_readings_ = 0;
    turned_rad_ = turned_rad;
  }
}

void HallwayTracker::take_ahead(const SonarRanges& ranges_m) {
  ahead_m_.reset();
  double nearest_m = config_.sonar_range_m;
  double farthest_m = 0.0;
  std::size_t forward = 0;
  for (std::size_t i = 0; i < kSonars; ++i) {
    // What the robot would touch if it went straight on: in a strip as wide as itself.
    const double bearing_rad = config_.sonar_bearings_rad[i];
    if (!ranges_m[i] || std::abs(bearing_rad) > 0.25 * kPi) {
      continue;
    }
    const double from_middle_m = *ranges_m[i] + config_.sonar_radius_m;
    nearest_m = std::min(nearest_m, from_middle_m * std::cos(bearing_rad));
    farthest_m = std::max(farthest_m, from_middle_m * std::cos(bearing_rad));
    ++forward;
    if (from_middle_m * std::abs(std::sin(bearing_rad)) > config_.radius_m + 0.05) {
      continue;
    }
    const double free_m = from_middle_m * std::cos(bearing_rad) - config_.radius_m;
    ahead_m_ = std::max(0.0, std::min(ahead_m_.value_or(free_m), free_m));
  }
  wall_ahead_ = forward >= kForward && farthest_m - nearest_m < kFlat_m;
}

void HallwayTracker::take_ranges(const SonarRanges& ranges_m) {
  take_ahead(ranges_m);
  if (axis_rad_ && heading_rad_ && std::abs(off_axis_rad()) < kAlong_rad) {
    take_side(flanks_[0], ranges_m.front());
    take_side(flanks_[1], ranges_m.back());
    take_slopes();
    measure_width();
  } else {
    for (Flank& flank : flanks_) {
      flank.wall.distance_m.reset();
      flank.sights = 0;
      flank.seen = 0;
    }
  }
}

bool HallwayTracker::firm(const Flank& flank) {
  return flank.sights > kFirm && flank.trail[flank.sights - 1].way_m - flank.trail[0].way_m > kFirmWay_m;
}

void HallwayTracker::measure_width() {
  for (Flank& flank : flanks_) {
    if (!flank.first_m && firm(flank)) {
      flank.first_m = flank.wall.distance_m;
    }
  }
  if (firm(flanks_[0]) && firm(flanks_[1])) {
    const double seen_m = *left().distance_m + *right().distance_m;
    width_m_ += (measured_ ? kWidthGain : 1.0) * (seen_m - width_m_);
    measured_ = true;
  }
}

void HallwayTracker::take_side(Flank& flank, const std::optional<double>& range_m) {
  const double moved_m = std::exchange(flank.moved_m, 0.0);
  std::optional<double> nearest_m;
  if (range_m) {
    nearest_m = *range_m + config_.sonar_radius_m;
  }
  WallSide& wall = flank.wall;
  if (wall.last_m) {
    *wall.last_m -= moved_m;
  }
  if (!wall.distance_m) {
    if (flank.candidate_m) {
      *flank.candidate_m -= moved_m;
    }
    look_for_wall(flank, nearest_m);
    return;
  }
  *wall.distance_m -= moved_m;
  if (nearest_m && std::abs(*nearest_m - *wall.distance_m) < kJump_m) {
    see_wall(flank, *nearest_m);
    return;
  }
  if (way_m_ - flank.seen_at_m > kBlink_m) {
    wall.distance_m.reset();
    flank.sights = 0;
    flank.seen = 0;
    look_for_wall(flank, nearest_m);
  }
}

void HallwayTracker::see_wall(Flank& flank, double distance_m) {
  WallSide& wall = flank.wall;
  wall.distance_m = *wall.distance_m + kSightGain * (distance_m - *wall.distance_m);
  wall.open_for_m = 0.0;
  flank.seen_at_m = way_m_;
  if (flank.sights == flank.trail.size()) {
    std::copy(flank.trail.begin() + 1, flank.trail.end(), flank.trail.begin());
    --flank.sights;
  }
  flank.trail[flank.sights++] = {way_m_, distance_m, off_axis_rad()};
  if (wall.last_m || firm(flank)) {
    wall.last_m = wall.distance_m;
  }
}

void HallwayTracker::look_for_wall(Flank& flank, const std::optional<double>& nearest_m) {
  WallSide& wall = flank.wall;
  const bool known = wall.last_m && wall.open_for_m < kWidened_m;
  if (!nearest_m || *nearest_m > (known ? *wall.last_m + kOpening_m : kFarthestWall_m)) {
    wall.open_for_m = wall.last_m ? way_m_ - flank.seen_at_m : 0.0;
    flank.candidate_m.reset();
    return;
  }
  const bool same = flank.candidate_m && std::abs(*nearest_m - *flank.candidate_m) < kJump_m;
  flank.seen = same ? flank.seen + 1 : 1;
  flank.candidate_m = nearest_m;
  if (flank.seen >= kWall) {
    wall.distance_m = nearest_m;
    flank.candidate_m.reset();
    see_wall(flank, *nearest_m);
  }
}

std::optional<double> HallwayTracker::turn_by_wall_rad(std::size_t side) const {
  const Flank& flank = flanks_[side];
  const std::span<const Sight> trail{flank.trail.data(), flank.sights};
  if (trail.size() < kFirm || trail.back().way_m - trail.front().way_m < kSlopeWay_m) {
    return std::nullopt;
  }
  double way = 0.0;
  double distance = 0.0;
  double headed = 0.0;
  for (const Sight& sight : trail) {
    way += sight.way_m;
    distance += sight.distance_m;
    headed += sight.off_axis_rad;
  }
  const auto n = static_cast<double>(trail.size());
  double both = 0.0;
  double squares = 0.0;
  for (const Sight& sight : trail) {
    const double off = sight.way_m - way / n;
    both += off * (sight.distance_m - distance / n);
    squares += off * off;
  }
  // Going to the left, the left wall comes nearer and the right one goes away.
  return (side == 0 ? -1.0 : 1.0) * both / squares - headed / n;
}

void HallwayTracker::take_slopes() {
  const std::optional<double> by_left_rad = turn_by_wall_rad(0);
  const std::optional<double> by_right_rad = turn_by_wall_rad(1);
  if (by_left_rad && by_right_rad && std::abs(*by_left_rad - *by_right_rad) > kParallel_rad) {
    return;
  }
  for (const std::optional<double>& by_wall_rad : {by_left_rad, by_right_rad}) {
    const double turn_rad = kWallGain * by_wall_rad.value_or(0.0);
    const bool away = std::abs(compass_ahead_rad_ - turn_rad) > std::abs(compass_ahead_rad_);
    if (away && std::abs(compass_ahead_rad_) > kAslant_rad) {
      continue;
    }
    heading_rad_ = wrap_angle(*heading_rad_ + turn_rad);
    compass_ahead_rad_ -= turn_rad;
  }
}

std::optional<double> HallwayTracker::left_of_middle_m() const {
  const std::optional<double>& to_left_m = left().distance_m;
  const std::optional<double>& to_right_m = right().distance_m;
  if (to_left_m && to_right_m) {
    return 0.5 * (*to_right_m - *to_left_m);
  }
  // Half of a hallway whose other wall nobody has seen is as wide as the robot is off this one.
  if (to_left_m) {
    return (measured_ ? 0.5 * width_m_ : flanks_[0].first_m.value_or(*to_left_m)) - *to_left_m;
  }
  if (to_right_m) {
    return *to_right_m - (measured_ ? 0.5 * width_m_ : flanks_[1].first_m.value_or(*to_right_m));
  }
  return std::nullopt;
}

std::optional<double> HallwayTracker::left_of_line_m() const {
  const double off_m = std::min(config_.wall_m, 0.5 * width_m_);
  if (config_.follow == HallwayLine::kLeft && left().distance_m) {
    return off_m - *left().distance_m;
  }
  if (config_.follow == HallwayLine::kRight && right().distance_m) {
    return *right().distance_m - off_m;
  }
  const std::optional<double> left_m = left_of_middle_m();
  if (!left_m || config_.follow == HallwayLine::kMiddle || !measured_) {
    return left_m;
  }
  const double aside_m = 0.5 * width_m_ - off_m;
  return *left_m + (config_.follow == HallwayLine::kLeft ? -aside_m : aside_m);
}

}  // namespace sensotwin::robot
