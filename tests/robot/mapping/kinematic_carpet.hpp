// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "robot/mapping/mapping_config.hpp"
#include "robot/mapping/mapping_mission.hpp"

namespace sensotwin::robot::testing {

/// A carpeted room drawn as text, and a robot that rolls on it by kinematics alone: enough to try the mission where
/// Box2D is not installed. '#' is solid, '.' is carpet with a tag, 'S' the start, 'x' carpet whose tag is dead. The
/// first line is the far (north) row.
class KinematicCarpet {
 public:
  struct Errors {
    double scale{0.0};            ///< travelled / counted - 1
    double turn_scale{0.0};
    double curvature_rad_per_m{0.0};
    double heading_noise_rad{0.0};  ///< per square root of a metre
    double turn_noise{0.0};         ///< rad per radian turned, as a random walk
    double tag_offset_m{0.0};
  };

  KinematicCarpet(const std::vector<std::string>& plan, const Errors& errors, std::uint64_t seed)
      : plan_(plan), errors_(errors), random_(RandomStream{seed}.fork("kinematic carpet")) {
    for (int row = 0; row < rows(); ++row) {
      for (int column = 0; column < columns(); ++column) {
        if (at(column, row) == 'S') {
          X_WR_ = {centre(column, row), 0.0};
          start_ = {column, row};
        }
        offsets_[{column, row}] = errors.tag_offset_m * Vec2{random_.normal(), random_.normal()};
      }
    }
  }

  /// Everything the mission may know, after one control step with the wheels at `command`.
  Sensed step(const Command& command) {
    now_ += kTick;
    Sensed sensed;
    sensed.stamp = now_;
    roll(command.wheels, sensed);
    sense_light(sensed);
    sense_tag(command, sensed);
    if (ticks_++ % 7 == 0) {
      sensed.compass_rad = X_WR_.yaw_rad - kPi / 2 + 0.02 * random_.normal();
    }
    return sensed;
  }

  [[nodiscard]] int rows() const { return static_cast<int>(plan_.size()); }
  [[nodiscard]] int columns() const { return static_cast<int>(plan_.front().size()); }
  [[nodiscard]] char at(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns() || row >= rows()) {
      return '#';
    }
    return plan_[static_cast<std::size_t>(rows() - 1 - row)][static_cast<std::size_t>(column)];
  }
  [[nodiscard]] const Pose2& truth() const { return X_WR_; }
  [[nodiscard]] Tile start() const { return start_; }
  /// Tag of a tile, by its place in the plan.
  [[nodiscard]] static TagUid uid(int column, int row) {
    return 0xE004'0100'0000'0000u + static_cast<TagUid>(1000 * column + row);
  }
  [[nodiscard]] const std::map<TagUid, Tile>& written() const { return written_; }

 private:
  static constexpr double kTile_m = 0.508;
  static constexpr double kRadius_m = 0.17;
  [[nodiscard]] static Vec2 centre(int column, int row) { return {(column + 0.5) * kTile_m, (row + 0.5) * kTile_m}; }

  /// Vector from the nearest solid point to p, and its length.
  [[nodiscard]] Vec2 away_from_solid(const Vec2& p) const {
    Vec2 best{1e9, 0.0};
    const int column = static_cast<int>(std::floor(p.x() / kTile_m));
    const int row = static_cast<int>(std::floor(p.y() / kTile_m));
    for (int r = row - 1; r <= row + 1; ++r) {
      for (int c = column - 1; c <= column + 1; ++c) {
        if (at(c, r) == '#') {
          const Vec2 nearest{std::clamp(p.x(), c * kTile_m, (c + 1) * kTile_m),
                             std::clamp(p.y(), r * kTile_m, (r + 1) * kTile_m)};
          if ((p - nearest).norm() < best.norm()) {
            best = p - nearest;
          }
        }
      }
    }
    return best;
  }

  void roll(const WheelSpeeds& wheels, Sensed& sensed) {
    const double dt = to_s(kTick);
    const double v = (wheels.left_mps + wheels.right_mps) / 2.0;
    const double w = (wheels.right_mps - wheels.left_mps) / 0.235;
    const double d = v * dt * (1.0 + errors_.scale);
    const double turn = w * dt * (1.0 + errors_.turn_scale) + errors_.curvature_rad_per_m * d +
                        errors_.heading_noise_rad * std::sqrt(std::abs(d)) * random_.normal() +
                        errors_.turn_noise * std::sqrt(std::abs(w * dt)) * random_.normal();
    X_WR_.p_m += d * Vec2{std::cos(X_WR_.yaw_rad + turn / 2), std::sin(X_WR_.yaw_rad + turn / 2)};
    X_WR_.yaw_rad = wrap_angle(X_WR_.yaw_rad + turn);
    const double per_count = OdometryModel{}.metres_per_count;
    left_ += wheels.left_mps * dt / per_count;
    right_ += wheels.right_mps * dt / per_count;
    sensed.counts_left = static_cast<int>(std::floor(left_)) - counted_left_;
    sensed.counts_right = static_cast<int>(std::floor(right_)) - counted_right_;
    counted_left_ += sensed.counts_left;
    counted_right_ += sensed.counts_right;
    const Vec2 away = away_from_solid(X_WR_.p_m);
    if (away.norm() < kRadius_m) {
      X_WR_.p_m += away.normalized() * (kRadius_m - away.norm());
      const double angle = wrap_angle(std::atan2(-away.y(), -away.x()) - X_WR_.yaw_rad);
      sensed.bump_left = angle > -0.17 && angle < kPi / 2;
      sensed.bump_right = angle < 0.17 && angle > -kPi / 2;
    }
  }

  void sense_light(Sensed& sensed) const {
    const LightBumper model;
    for (std::size_t i = 0; i < 6; ++i) {
      const double yaw = X_WR_.yaw_rad + model.yaw_R_rad[i];
      const Vec2 u{std::cos(yaw), std::sin(yaw)};
      for (double range = 0.0; range < 0.25; range += 0.005) {
        const Vec2 p = X_WR_.p_m + (kRadius_m + range) * u;
        if (at(static_cast<int>(std::floor(p.x() / kTile_m)), static_cast<int>(std::floor(p.y() / kTile_m))) == '#') {
          const double fraction = model.near_m / (model.near_m + range);
          sensed.light_bump[i] = static_cast<std::uint16_t>(model.full_signal * fraction * fraction);
          break;
        }
      }
    }
  }

  void sense_tag(const Command& command, Sensed& sensed) {
    const int column = static_cast<int>(std::floor(X_WR_.p_m.x() / kTile_m));
    const int row = static_cast<int>(std::floor(X_WR_.p_m.y() / kTile_m));
    const auto offset = offsets_.find({column, row});
    const bool inside = (at(column, row) == '.' || at(column, row) == 'S') && offset != offsets_.end() &&
                        (X_WR_.p_m - centre(column, row) - offset->second).norm() < 0.08;
    if (inside && !in_field_) {
      sensed.tag_entered = true;
      entered_ = now_;
      identified_ = false;
    } else if (!inside && in_field_) {
      sensed.tag_left = true;
      if (writing_) {
        sensed.write_ended = TileWriteEnded{writing_->tag, false};
        writing_.reset();
      }
    }
    in_field_ = inside;
    if (inside && !identified_ && now_ >= entered_ + 2 * kTick) {
      identified_ = true;
      sensed.tag_identified = uid(column, row);
    }
    if (writing_ && inside && now_ >= write_done_) {
      written_[writing_->tag] = writing_->tile;
      sensed.write_ended = TileWriteEnded{writing_->tag, true};
      writing_.reset();
    }
    if (command.write) {
      writing_ = command.write;
      write_done_ = now_ + 6 * kTick;
    }
  }

  std::vector<std::string> plan_;
  Errors errors_;
  RandomStream random_;
  Pose2 X_WR_;
  Tile start_;
  std::map<Tile, Vec2> offsets_;
  Instant now_;
  Instant entered_;
  Instant write_done_;
  int ticks_{0};
  double left_{0.0};
  double right_{0.0};
  int counted_left_{0};
  int counted_right_{0};
  bool in_field_{false};
  bool identified_{false};
  std::optional<TileWrite> writing_;
  std::map<TagUid, Tile> written_;
};

}  // namespace sensotwin::robot::testing
