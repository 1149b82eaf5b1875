// SPDX-License-Identifier: MIT
#include "world/body_sensors.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::world {
namespace {

using robot::rad_from_deg;

constexpr double kBoth_rad = rad_from_deg(10.0);
constexpr double kBeamRange_m = 0.25;
constexpr double kBeamHalf_m = 0.05;
constexpr double kSignalMax = 4095.0;
/// Way after which the surroundings are looked up again. Chosen: twice in three seconds at 0.3 m/s; what lies
/// farther off than a beam reaches and this need not be listed.
constexpr double kLookAround_m = 0.25;
/// Guards comparisons of distances that were rounded differently.
constexpr double kRounding_m = 1e-9;
/// Left to right, as RoombaInputs lists them.
constexpr std::array<double, 6> kBeam_rad = {rad_from_deg(65.0),  rad_from_deg(38.0),  rad_from_deg(14.0),
                                             rad_from_deg(-14.0), rad_from_deg(-38.0), rad_from_deg(-65.0)};
constexpr std::array<double, 4> kCliff_rad = {rad_from_deg(60.0), rad_from_deg(15.0), rad_from_deg(-15.0),
                                              rad_from_deg(-60.0)};
constexpr double kCliffRadius_m = 0.16;
constexpr std::uint16_t kFloor_signal = 2800;  // chosen
constexpr std::uint16_t kHole_signal = 20;     // chosen

// Home base, all chosen after the Create 2's behaviour in a room: buoys reach across one, the force field
// keeps the robot half a metre off.
constexpr double kBuoyRange_m = 2.0;
constexpr double kBuoyHalf_rad = rad_from_deg(45.0);
constexpr double kBuoyOverlap_rad = rad_from_deg(5.0);
constexpr double kForceFieldRange_m = 0.5;
constexpr double kDockReach_m = 0.02;
constexpr double kDockHalf_rad = rad_from_deg(10.0);
// [CreateOI] packet 17: characters of the Roomba 600 drive-on charger and virtual wall.
constexpr std::uint8_t kDockBase = 160;
constexpr std::uint8_t kForceField = 1;
constexpr std::uint8_t kGreenBuoy = 4;
constexpr std::uint8_t kRedBuoy = 8;
constexpr std::uint8_t kVirtualWall = 162;
/// The left and right receivers look forward and to their side, a little past the middle. Chosen.
constexpr double kReceiverSide_rad = rad_from_deg(90.0);
constexpr double kReceiverPast_rad = rad_from_deg(20.0);

bool inside(const Cliff& cliff, const Vec2& at_m) {
  bool left = false;
  bool right = false;
  const auto& corners = cliff.corners_m;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
    const Vec2 to = at_m - corners[i];
    const double side = edge.x() * to.y() - edge.y() * to.x();
    left = left || side > 0.0;
    right = right || side < 0.0;
  }
  return corners.size() > 2 && !(left && right);
}

bool farther(const Vec2& way_m, double limit_m) {
  const double surely_m = limit_m + kRounding_m;
  return way_m.squaredNorm() > surely_m * surely_m;
}

double bearing_rad(const Vec2& p) {
  return std::atan2(p.y(), p.x());
}

}  // namespace

BumpSwitches switches_pressed(double bearing_rad) {
  const bool front = std::abs(bearing_rad) <= 0.5 * robot::kPi;
  return {.left = front && bearing_rad > -kBoth_rad, .right = front && bearing_rad < kBoth_rad};
}

BodySensors::BodySensors(const WorldDescription& world, const RoombaDescription& base)
    : cliffs_(world.cliffs),
      virtual_walls_(world.virtual_walls),
      home_base_(world.home_base),
      X_HW_(world.home_base ? world.home_base->X_WH.inverse() : Pose2{}),
      radius_m_(base.radius_m),
      arm_m_(0.5 * base.wheel_base_m) {}

bool BodySensors::over_hole(const Vec2& at_m) const {
  return std::any_of(cliffs_.begin(), cliffs_.end(), [&](const Cliff& c) { return inside(c, at_m); });
}

std::array<bool, 2> BodySensors::wheels_on_floor(const Pose2& X_WR) const {
  if (cliffs_.empty()) {
    return {true, true};
  }
  return {!over_hole(X_WR * Vec2{0.0, arm_m_}), !over_hole(X_WR * Vec2{0.0, -arm_m_})};
}

bool BodySensors::docked(const Pose2& X_WR) const {
  if (!home_base_ || farther(X_WR.p_m - home_base_->X_WH.p_m, radius_m_ + kDockReach_m)) {
    return false;
  }
  const Pose2 X_HR = X_HW_ * X_WR;
  return (X_HR * Vec2{radius_m_, 0.0}).norm() <= kDockReach_m &&
         std::abs(robot::wrap_angle(X_HR.yaw_rad - robot::kPi)) <= kDockHalf_rad;
}

void BodySensors::read(const ObstacleIndex& fixed, std::span<const Outline> pushed, const Pose2& X_WR,
                       RoombaInputs& inputs) const {
  read_light(fixed, pushed, X_WR, inputs);
  inputs.cliff_signal.fill(kFloor_signal);
  if (!cliffs_.empty()) {
    for (std::size_t i = 0; i < kCliff_rad.size(); ++i) {
      const Vec2 spot_m = kCliffRadius_m * Vec2{std::cos(kCliff_rad[i]), std::sin(kCliff_rad[i])};
      inputs.cliff[i] = over_hole(X_WR * spot_m);
      inputs.cliff_signal[i] = inputs.cliff[i] ? kHole_signal : kFloor_signal;
    }
    const auto floor = wheels_on_floor(X_WR);
    inputs.wheel_drop_left = !floor[0];
    inputs.wheel_drop_right = !floor[1];
  }
  if (!virtual_walls_.empty() || home_base_) {
    read_infrared(fixed, X_WR, inputs);
  }
}

void BodySensors::look_around(const ObstacleIndex& fixed, const Vec2& at_m) const {
  around_.segments.clear();
  around_.discs.clear();
  seen_from_m_ = at_m;
  const double far_m = radius_m_ + kBeamRange_m + kLookAround_m;
  nearest_m_ = far_m;
  // A long wall is told once for each bucket it crosses.
  const auto same = [](const Segment& a, const Segment& b) { return a.a_m == b.a_m && a.b_m == b.b_m; };
  const auto segment = [&](const Segment& s) {
    const double d_m = distance_m(at_m, s);
    if (d_m < far_m && std::none_of(around_.segments.begin(), around_.segments.end(),
                                    [&](const Segment& known) { return same(known, s); })) {
      around_.segments.push_back(s);
      nearest_m_ = std::min(nearest_m_, d_m);
    }
  };
  const auto disc = [&](const Disc& d) {
    const double d_m = (at_m - d.middle_m).norm() - d.radius_m;
    if (d_m < far_m) {
      around_.discs.push_back(d);
      nearest_m_ = std::min(nearest_m_, d_m);
    }
  };
  const Vec2 box_m{far_m, far_m};
  fixed.near(at_m - box_m, at_m + box_m, segment, disc);
}

void BodySensors::read_light(const ObstacleIndex& fixed, std::span<const Outline> pushed, const Pose2& X_WR,
                             RoombaInputs& inputs) const {
  const double reach_m = radius_m_ + kBeamRange_m;
  if (!seen_from_m_ || (X_WR.p_m - *seen_from_m_).squaredNorm() > kLookAround_m * kLookAround_m) {
    look_around(fixed, X_WR.p_m);
  }
  // What is nearest may have come nearer by as much as the robot has moved.
  const double moved_m = (X_WR.p_m - *seen_from_m_).norm();
  const bool fixed_near = nearest_m_ < reach_m + moved_m + kRounding_m;
  if (!fixed_near && pushed.empty()) {
    return;
  }
  std::array<Vec2, 6> beam;
  std::array<double, 6> range_m{};
  range_m.fill(reach_m);
  const Vec2 ahead = X_WR.direction();
  for (std::size_t i = 0; i < beam.size(); ++i) {
    static const std::array<Vec2, 6> kBeam_R = [] {
      std::array<Vec2, 6> out;
      std::transform(kBeam_rad.begin(), kBeam_rad.end(), out.begin(), [](double a) {
        return Vec2{std::cos(a), std::sin(a)};
      });
      return out;
    }();
    beam[i] = {ahead.x() * kBeam_R[i].x() - ahead.y() * kBeam_R[i].y(),
               ahead.y() * kBeam_R[i].x() + ahead.x() * kBeam_R[i].y()};
  }
  const auto meet = [&](const auto& thing) {
    for (std::size_t i = 0; i < beam.size(); ++i) {
      range_m[i] = ray_m(X_WR.p_m, beam[i], thing, range_m[i]);
    }
  };
  const auto meet_segment = [&](const Segment& s) {
    if (distance_m(X_WR.p_m, s) < reach_m) {
      meet(s);
    }
  };
  const auto meet_outline = [&](const Outline& outline) {
    std::for_each(outline.segments.begin(), outline.segments.end(), meet_segment);
    std::for_each(outline.discs.begin(), outline.discs.end(), meet);
  };
  if (fixed_near) {
    meet_outline(around_);
  }
  std::for_each(pushed.begin(), pushed.end(), meet_outline);
  for (std::size_t i = 0; i < beam.size(); ++i) {
    const double d_m = std::max(0.0, range_m[i] - radius_m_);
    const double falls = 1.0 + d_m / kBeamHalf_m;
    inputs.light_bump_signal[i] =
        range_m[i] < reach_m ? static_cast<std::uint16_t>(kSignalMax / (falls * falls)) : std::uint16_t{0};
  }
  // "The wall sensor is equivalent to Light Bumper Right" ([CreateOI] packet 8); 10 bits instead of 12.
  inputs.wall_signal = static_cast<std::uint16_t>(inputs.light_bump_signal[5] / 4);
}

void BodySensors::read_infrared(const ObstacleIndex& fixed, const Pose2& X_WR, RoombaInputs& inputs) const {
  const auto receive = [&](const Vec2& source_m, std::uint8_t character) {
    const double from_rad = bearing_rad(X_WR.inverse() * source_m);
    inputs.ir_omni = character;
    if (from_rad >= -kReceiverPast_rad && from_rad <= kReceiverSide_rad) {
      inputs.ir_left = character;
    }
    if (from_rad >= -kReceiverSide_rad && from_rad <= kReceiverPast_rad) {
      inputs.ir_right = character;
    }
  };
  if (home_base_ && !farther(X_WR.p_m - home_base_->X_WH.p_m, kBuoyRange_m)) {
    // From a little in front of the contacts: the base itself usually stands against a wall.
    const Vec2 source_m = home_base_->X_WH * Vec2{0.01, 0.0};
    const Vec2 p_HR_m = X_HW_ * X_WR.p_m;
    const double range_m = p_HR_m.norm();
    const double off_rad = bearing_rad(p_HR_m);
    std::uint8_t beams = 0;
    if (range_m <= kBuoyRange_m && std::abs(off_rad) <= kBuoyHalf_rad) {
      beams |= off_rad <= kBuoyOverlap_rad ? kRedBuoy : std::uint8_t{0};
      beams |= off_rad >= -kBuoyOverlap_rad ? kGreenBuoy : std::uint8_t{0};
    }
    beams |= range_m <= kForceFieldRange_m && p_HR_m.x() > 0.0 ? kForceField : std::uint8_t{0};
    if (beams != 0 && fixed.in_sight(X_WR.p_m, source_m)) {
      receive(source_m, static_cast<std::uint8_t>(kDockBase + beams));
    }
  }
  for (const VirtualWall& fan : virtual_walls_) {
    const Vec2 p_VR_m = fan.X_WV.inverse() * X_WR.p_m;
    if (p_VR_m.norm() <= fan.range_m && std::abs(bearing_rad(p_VR_m)) <= fan.half_angle_rad &&
        fixed.in_sight(X_WR.p_m, fan.X_WV * Vec2{0.01, 0.0})) {
      inputs.virtual_wall = true;
      receive(fan.X_WV.p_m, kVirtualWall);
    }
  }
}

}  // namespace sensotwin::world
