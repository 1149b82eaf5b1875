// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/tag_search.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

constexpr double kTurn_rad = 2.0 * kPi;
/// A turn towards a bearing ends this near. Chosen: a tenth of a sector.
constexpr double kFaced_rad = 0.05;
/// Of a sector's loudness when it had a few reads only: it counts this much less for each that lacks.
constexpr int kTrusted = 3;
constexpr double kDoubt_db = 2.0;

}  // namespace

void TagSearch::begin() {
  round_ = 0;
  silent_turns_ = 0;
  begin_turn();
}

void TagSearch::begin_turn() {
  phase_ = Phase::kTurning;
  turned_rad_ = 0.0;
  sectors_.fill({});
}

void TagSearch::listen(double loudest_dbm) {
  const double part = std::fmod(turned_rad_, kTurn_rad) / kTurn_rad;
  Sector& sector = sectors_[static_cast<std::size_t>(part * kSectors) % kSectors];
  sector.sum_dbm += loudest_dbm;
  ++sector.count;
}

double TagSearch::bearing_rad() const {
  std::size_t best = kSectors;
  double loudest_dbm = 0.0;
  for (std::size_t i = 0; i < kSectors; ++i) {
    const Sector& sector = sectors_[i];
    if (sector.count == 0) {
      continue;
    }
    const double doubt_db = kDoubt_db * std::max(0, kTrusted - sector.count);
    const double dbm = sector.sum_dbm / sector.count - doubt_db;
    if (best == kSectors || dbm > loudest_dbm) {
      best = i;
      loudest_dbm = dbm;
    }
  }
  if (best == kSectors) {
    // Not heard: the next side of the square. After a whole turn the robot looks along the last one.
    return round_ == 0 ? 0.0 : kPi / 2.0;
  }
  return wrap_angle((static_cast<double>(best) + 0.5) * kTurn_rad / kSectors);
}

std::optional<TagSearch::Move> TagSearch::step(const WheelStep& way, std::optional<double> loudest_dbm) {
  switch (phase_) {
    case Phase::kIdle:
      return std::nullopt;
    case Phase::kTurning: {
      turned_rad_ += std::max(way.turn_rad, 0.0);
      if (loudest_dbm) {
        listen(*loudest_dbm);
      }
      if (turned_rad_ < kTurn_rad) {
        return Move{0.0, config_.turn_radps};
      }
      const bool heard =
          std::any_of(sectors_.begin(), sectors_.end(), [](const Sector& s) { return s.count > 0; });
      silent_turns_ = heard ? 0 : silent_turns_ + 1;
      if (silent_turns_ == 1 && round_ == 0) {
        begin_turn();
        return Move{0.0, config_.turn_radps};
      }
      to_turn_rad_ = bearing_rad();
      // Two sides of each length, as of a square spiral; towards a tag always the same.
      const int longer = heard ? 0 : round_ / 2;
      to_drive_m_ = config_.piece_m * (1.0 + longer);
      phase_ = Phase::kFacing;
      return Move{};
    }
    case Phase::kFacing:
      to_turn_rad_ -= way.turn_rad;
      if (std::abs(to_turn_rad_) > kFaced_rad) {
        return Move{0.0, std::copysign(config_.turn_radps, to_turn_rad_)};
      }
      phase_ = Phase::kDriving;
      return Move{config_.speed_mps, 0.0};
    case Phase::kDriving:
      to_drive_m_ -= std::abs(way.forward_m);
      if (to_drive_m_ > 0.0) {
        return Move{config_.speed_mps, 0.0};
      }
      if (++round_ >= config_.rounds) {
        end();
        return std::nullopt;
      }
      begin_turn();
      return Move{0.0, config_.turn_radps};
  }
  return std::nullopt;
}

}  // namespace sensotwin::robot
