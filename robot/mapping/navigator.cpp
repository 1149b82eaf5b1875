// SPDX-License-Identifier: MIT
#include "robot/mapping/navigator.hpp"

#include <cmath>

namespace sensotwin::robot {
namespace {

/// A rim crossed slower than this says when, not where. Chosen: one cell of the floor grid a second.
constexpr double kRimSpeed_mps = 0.025;
/// The grid is refreshed after this much travel or turn: half a cell, and what moves a beam's end by half a
/// cell.
constexpr double kLookStep_m = 0.0125;
constexpr double kLookStep_rad = 0.04;
/// And standing still every so many steps, 0.3 s.
constexpr int kLookSteps = 20;
/// The sweep clears this much less than the body, for the error of the pose.
constexpr double kSweepMargin_m = 0.03;
/// What is seen from a place known better than this is believed for long. Chosen: two cells of the floor
/// grid.
constexpr double kKnownPlace_m = 0.05;
/// A trail is remembered where the place is known better than this. Chosen: two cells.
constexpr double kTreadSigma_m = 0.05;
/// Placed by hand over a tag: within the zone, square to the tiles within a few degrees.
constexpr double kPlacedSigma_m = 0.03;
constexpr double kPlacedYawSigma_rad = 0.05;
/// Found farther off than the widest search leads, the robot was carried there: its heading is not to blame,
/// and is kept. Chosen: a tile and a half; who carries it may turn it by some degrees.
constexpr double kCarried_m = 0.76;
constexpr double kCarriedYawSigma_rad = 0.10;

}  // namespace

Navigator::Navigator(const MappingConfig& config, const TileMap& map)
    : config_(config), map_(map), filter_(config.odometry, config.compass) {
  filter_.reset(Pose2{}, kPlacedSigma_m, kPlacedYawSigma_rad);
}

Tile Navigator::nearest_tile(const Vec2& p_M_m) const {
  return {static_cast<int>(std::lround(p_M_m.x() / config_.tile_m)),
          static_cast<int>(std::lround(p_M_m.y() / config_.tile_m))};
}

void Navigator::sense(const Sensed& sensed) {
  identified_.reset();
  relocated_ = false;
  sense_motion(sensed);
  sense_tag(sensed);
  sense_obstacles(sensed);
  if (sensed.compass_rad) {
    filter_.correct_by_compass(*sensed.compass_rad);
  }
}

void Navigator::sense_motion(const Sensed& sensed) {
  const double before_m = filter_.path_length_m();
  std::optional<double> contact_rad;
  if (sensed.bump_left || sensed.bump_right) {
    contact_rad = contact_yaw_R_rad((sensed.bump_left ? 1 : 0) - (sensed.bump_right ? 1 : 0), sensed);
  }
  filter_.drive(sensed.counts_left, sensed.counts_right, contact_rad);
  const double sign = sensed.counts_left + sensed.counts_right < 0 ? -1.0 : 1.0;
  speed_mps_ = sign * (filter_.path_length_m() - before_m) / to_s(kTick);
}

void Navigator::sense_obstacles(const Sensed& sensed) {
  const Pose2& X_MR = filter_.pose();
  if ((X_MR.p_m - swept_at_m_).norm() > FloorGrid::kCell_m) {
    floor_.clear_disc(X_MR.p_m, config_.body_radius_m - kSweepMargin_m);
    swept_at_m_ = X_MR.p_m;
    if (filter_.position_sigma_m() < kTreadSigma_m) {
      floor_.tread(X_MR.p_m);
    }
  }
  if ((X_MR.p_m - looked_at_m_).norm() < kLookStep_m &&
      std::abs(wrap_angle(X_MR.yaw_rad - looked_yaw_rad_)) < kLookStep_rad &&
      ++steps_since_look_ < kLookSteps) {
    return;
  }
  steps_since_look_ = 0;
  looked_at_m_ = X_MR.p_m;
  looked_yaw_rad_ = X_MR.yaw_rad;
  const auto seen = filter_.position_sigma_m() < kKnownPlace_m ? FloorGrid::Seen::kFromKnownPlace
                                                               : FloorGrid::Seen::kFromDoubtfulPlace;
  for (std::size_t i = 0; i < sensed.light_bump.size(); ++i) {
    const auto range_m = config_.light_bumper.range_m(sensed.light_bump[i]);
    const double yaw = X_MR.yaw_rad + config_.light_bumper.yaw_R_rad[i];
    const Vec2 beam{std::cos(yaw), std::sin(yaw)};
    const Vec2 shell = X_MR.p_m + config_.light_bumper.shell_radius_m * beam;
    // A cell short of what was met, for the error of the range.
    const double seen_m = range_m.value_or(config_.light_bumper.trusted_range_m) - FloorGrid::kCell_m;
    floor_.see_through(shell, shell + std::max(seen_m, 0.0) * beam);
    if (range_m) {
      floor_.add_hit(shell + *range_m * beam, seen);
    }
  }
}

ReadZone Navigator::zone_of(Tile tile) const {
  return {.tag_M_m = centre_m(tile),
          .radius_m = config_.read_radius_m,
          .rim_sigma_m = config_.rim_sigma_m,
          .tag_sigma_m = config_.tag_sigma_m};
}

void Navigator::sense_tag(const Sensed& sensed) {
  const bool rolling = std::abs(speed_mps_) > kRimSpeed_mps;
  const double late_m = speed_mps_ * config_.rim_delay_s;
  if (sensed.tag_left && in_field_) {
    if (const auto tile = uid_ ? map_.tile_of(*uid_) : std::nullopt;
        tile && entered_ && rolling && near(*tile)) {
      filter_.leave_zone(zone_of(*tile), late_m);
    }
    in_field_ = entered_ = entry_usable_ = false;
    uid_.reset();
  }
  if (sensed.tag_entered) {
    in_field_ = true;
    uid_.reset();
    entered_ = entry_usable_ = rolling;
    filter_.enter_zone(late_m);
  }
  if (sensed.tag_identified) {
    in_field_ = true;
    uid_ = *sensed.tag_identified;
    identified_ = uid_;
    use_tag_in_field();
  }
}

bool Navigator::near(Tile tile) const {
  return (pose().p_m - centre_m(tile)).norm() < config_.tile_m / 2.0;
}

void Navigator::use_tag_in_field() {
  const auto tile = uid_ ? map_.tile_of(*uid_) : std::nullopt;
  if (tile && !near(*tile)) {
    relocate(*tile);
    relocated_ = true;
  } else if (tile && entry_usable_) {
    entry_usable_ = false;
    filter_.identify_zone(zone_of(*tile));
  }
}

void Navigator::miss(Tile tile, double yaw_M_rad) {
  filter_.miss_zone(zone_of(tile), {std::cos(yaw_M_rad), std::sin(yaw_M_rad)});
}

void Navigator::relocate(Tile tile) {
  if ((pose().p_m - centre_m(tile)).norm() > kCarried_m) {
    filter_.reset({centre_m(tile), pose().yaw_rad}, kPlacedSigma_m, kCarriedYawSigma_rad);
  } else {
    filter_.find_at(zone_of(tile));
  }
  entered_ = entry_usable_ = false;
}

double Navigator::contact_yaw_R_rad(int side, const Sensed& sensed) const {
  if (side == 0) {
    return 0.0;
  }
  std::size_t brightest = side > 0 ? 0 : 5;
  for (std::size_t i = side > 0 ? 0 : 3; i < (side > 0 ? 3u : 6u); ++i) {
    if (sensed.light_bump[i] > sensed.light_bump[brightest]) {
      brightest = i;
    }
  }
  if (brightest == 0 || brightest == 5) {
    return side * kPi /
           2.0;  // a wall alongside is seen by the outermost beam only, as far back as it may touch
  }
  return config_.light_bumper.yaw_R_rad[brightest];
}

void Navigator::remember_bump(int side, const Sensed& sensed) {
  const double angle = contact_yaw_R_rad(side, sensed);
  const Vec2 outward{std::cos(angle), std::sin(angle)};
  floor_.forbid_centre(pose() * (FloorGrid::kCell_m * outward));
  floor_.forbid_centre(pose() * (2.0 * FloorGrid::kCell_m * outward));
}

}  // namespace sensotwin::robot
