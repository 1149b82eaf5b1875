// SPDX-License-Identifier: MIT
#include "tests/robot/mapping/kinematic_carpet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/mapping/light_bumper.hpp"
#include "robot/mapping/mapping_config.hpp"

namespace sensotwin::robot::testing {
namespace {

/// The light bumper sees this far (world/body_sensors.hpp).
constexpr double kSight_m = 0.25;
/// Cliff sensors sit so far from the middle, at these angles (world/body_sensors.hpp).
constexpr double kCliffArm_m = 0.16;
constexpr std::array<double, 4> kCliffYaw_deg{60, 15, -15, -60};
/// A touch within this of the middle presses both switches (world/body_sensors.hpp).
constexpr double kBothSwitches_rad = 10.0 * kPi / 180.0;
/// A reader identifies a tag two polls after it came, and writes 12 bytes with verification in six steps: of
/// the size of what the emulated reader takes.
constexpr int kIdentifySteps = 2;
constexpr int kWriteSteps = 6;
/// A compass board says ten sentences a second.
constexpr int kCompassSteps = 7;

/// From the nearest point of the tile's square to p.
Vec2 away_from_tile(Tile tile, const Vec2& p) {
  const double edge = KinematicCarpet::kTile_m;
  const Vec2 nearest{std::clamp(p.x(), tile.column * edge, (tile.column + 1) * edge),
                     std::clamp(p.y(), tile.row * edge, (tile.row + 1) * edge)};
  return p - nearest;
}

}  // namespace

KinematicCarpet::KinematicCarpet(std::vector<std::string> plan, const Errors& errors, std::uint64_t seed)
    : plan_(std::move(plan)), errors_(errors), random_(RandomStream{seed}.fork("kinematic carpet")) {
  const int rows = static_cast<int>(plan_.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < static_cast<int>(plan_.front().size()); ++column) {
      const Tile tile{column, row};
      if (at(tile) == 'S') {
        start_ = tile;
        X_WR_.p_m = centre_m(tile);
      }
      if (at(tile) == '.' || at(tile) == 'S') {
        tags_.insert(tile);
        const Vec2 offset{random_.normal(), random_.normal()};
        laid_at_m_[tile] = centre_m(tile) + errors.tag_offset_m * offset;
      }
    }
  }
}

void KinematicCarpet::put_post(const Vec2& at_tiles, double radius_m, bool seen) {
  posts_.push_back({at_tiles * kTile_m, radius_m, seen});
}

char KinematicCarpet::at(Tile tile) const {
  const int rows = static_cast<int>(plan_.size());
  if (tile.column < 0 || tile.row < 0 || tile.row >= rows ||
      tile.column >= static_cast<int>(plan_.front().size())) {
    return '#';
  }
  return plan_[static_cast<std::size_t>(rows - 1 - tile.row)][static_cast<std::size_t>(tile.column)];
}

TagUid KinematicCarpet::uid(Tile tile) {
  return 0xE004'0100'0000'0000u + static_cast<TagUid>(1000 * tile.column + tile.row);
}

Tile KinematicCarpet::tile_at(const Vec2& p_W_m) {
  return {static_cast<int>(std::floor(p_W_m.x() / kTile_m)),
          static_cast<int>(std::floor(p_W_m.y() / kTile_m))};
}

Sensed KinematicCarpet::step(const Command& command) {
  now_ += kTick;
  ++ticks_;
  Sensed sensed;
  sensed.stamp = now_;
  roll(command.wheels, sensed);
  touch(sensed);
  sense_light(sensed);
  sense_hazards(sensed);
  sense_tag(sensed);
  write(command, sensed);
  if (ticks_ % kCompassSteps == 0 && !compass_silent_) {
    sensed.compass_rad = wrap_angle(X_WR_.yaw_rad - kPi / 2 + errors_.compass_noise_rad * random_.normal());
  }
  return sensed;
}

void KinematicCarpet::roll(const WheelSpeeds& wheels, Sensed& sensed) {
  const double dt = to_s(kTick);
  const double d = (wheels.left_mps + wheels.right_mps) / 2.0 * dt * (1.0 + errors_.scale);
  const double counted_turn = (wheels.right_mps - wheels.left_mps) / OdometryModel{}.wheel_base_m * dt;
  const double turn = counted_turn * (1.0 + errors_.turn_scale) + errors_.curvature_rad_per_m * d +
                      errors_.heading_noise_rad * std::sqrt(std::abs(d)) * random_.normal() +
                      errors_.turn_noise_rad * std::sqrt(std::abs(counted_turn)) * random_.normal();
  X_WR_.yaw_rad += turn / 2.0;
  X_WR_.p_m += d * X_WR_.direction();
  X_WR_.yaw_rad = wrap_angle(X_WR_.yaw_rad + turn / 2.0);
  count(wheels, sensed);
}

void KinematicCarpet::count(const WheelSpeeds& wheels, Sensed& sensed) {
  const double per_count = OdometryModel{}.metres_per_count;
  left_ += wheels.left_mps * to_s(kTick) / per_count;
  right_ += wheels.right_mps * to_s(kTick) / per_count;
  sensed.counts_left = static_cast<int>(std::floor(left_)) - counted_left_;
  sensed.counts_right = static_cast<int>(std::floor(right_)) - counted_right_;
  counted_left_ += sensed.counts_left;
  counted_right_ += sensed.counts_right;
}

/// Vector from the nearest solid point to p.
Vec2 KinematicCarpet::away_from_solid(const Vec2& p_W_m) const {
  Vec2 best{1e9, 0.0};
  const Tile here = tile_at(p_W_m);
  for (int row = here.row - 1; row <= here.row + 1; ++row) {
    for (int column = here.column - 1; column <= here.column + 1; ++column) {
      const Vec2 away = away_from_tile({column, row}, p_W_m);
      if (solid({column, row}) && away.norm() < best.norm()) {
        best = away;
      }
    }
  }
  for (const Post& post : posts_) {
    const Vec2 from_middle = p_W_m - post.at_m;
    const double distance_m = from_middle.norm() - post.radius_m;
    if (distance_m < best.norm()) {
      best = distance_m * from_middle.normalized();
    }
  }
  return best;
}

void KinematicCarpet::touch(Sensed& sensed) {
  const Vec2 away = away_from_solid(X_WR_.p_m);
  if (away.norm() >= kRadius_m) {
    return;
  }
  X_WR_.p_m += away.normalized() * (kRadius_m - away.norm());
  const double bearing = wrap_angle(std::atan2(-away.y(), -away.x()) - X_WR_.yaw_rad);
  sensed.bump_left = bearing > -kBothSwitches_rad && bearing < kPi / 2;
  sensed.bump_right = bearing < kBothSwitches_rad && bearing > -kPi / 2;
}

bool KinematicCarpet::seen_at(const Vec2& p_W_m) const {
  return at(tile_at(p_W_m)) == '#' || std::any_of(posts_.begin(), posts_.end(), [&](const Post& post) {
           return post.seen && (p_W_m - post.at_m).norm() < post.radius_m;
         });
}

void KinematicCarpet::sense_light(Sensed& sensed) const {
  if (away_from_solid(X_WR_.p_m).norm() > kRadius_m + kSight_m) {
    return;
  }
  const LightBumper model;
  for (std::size_t i = 0; i < model.yaw_R_rad.size(); ++i) {
    const double yaw = X_WR_.yaw_rad + model.yaw_R_rad[i];
    const Vec2 beam{std::cos(yaw), std::sin(yaw)};
    for (double range = 0.0; range < kSight_m; range += 0.005) {
      if (seen_at(X_WR_.p_m + (kRadius_m + range) * beam)) {
        const double fraction = model.near_m / (model.near_m + range);
        sensed.light_bump[i] = static_cast<std::uint16_t>(model.full_signal * fraction * fraction);
        break;
      }
    }
  }
}

void KinematicCarpet::sense_hazards(Sensed& sensed) {
  for (const double yaw_deg : kCliffYaw_deg) {
    const double yaw = rad_from_deg(yaw_deg);
    const Vec2 p_W_m = X_WR_ * Vec2{kCliffArm_m * std::cos(yaw), kCliffArm_m * std::sin(yaw)};
    sensed.cliff = sensed.cliff || at(tile_at(p_W_m)) == 'o';
  }
  const Tile here = tile_at(X_WR_.p_m);
  sensed.virtual_wall = at(here) == 'v';
  if (at(here) == 'v' || at(here) == 'o') {
    const Vec2 off = (X_WR_.p_m - centre_m(here)).cwiseAbs();
    deepest_in_hazard_m_ = std::max(deepest_in_hazard_m_, kTile_m / 2 - off.maxCoeff());
  }
}

void KinematicCarpet::sense_tag(Sensed& sensed) {
  const Tile here = tile_at(X_WR_.p_m);
  const auto laid = laid_at_m_.find(here);
  const bool inside =
      laid != laid_at_m_.end() && (X_WR_.p_m - laid->second).norm() < MappingConfig{}.read_radius_m;
  const std::optional<Tile> field = inside ? std::optional{here} : std::nullopt;
  if (in_field_ && field != in_field_) {
    sensed.tag_left = true;
  }
  if (field && field != in_field_) {
    sensed.tag_entered = true;
    entered_ = now_;
    identified_ = false;
  }
  in_field_ = field;
  if (in_field_ && !identified_ && now_ >= entered_ + kIdentifySteps * kTick) {
    identified_ = true;
    sensed.tag_identified = uid(here);
  }
}

void KinematicCarpet::write(const Command& command, Sensed& sensed) {
  if (writing_ && (!in_field_ || uid(*in_field_) != writing_->tag)) {
    sensed.write_ended = TileWriteEnded{writing_->tag, false};
    writing_.reset();
  } else if (writing_ && now_ >= write_done_) {
    const bool torn = writes_to_tear_ > 0;
    writes_to_tear_ -= torn ? 1 : 0;
    if (!torn) {
      written_[writing_->tag] = writing_->tile;
    }
    sensed.write_ended = TileWriteEnded{writing_->tag, !torn};
    writing_.reset();
  }
  if (command.write) {
    writing_ = command.write;
    write_done_ = now_ + kWriteSteps * kTick;
  }
}

}  // namespace sensotwin::robot::testing
