// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/ceiling_mission.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

namespace sensotwin::robot {
namespace {

/// A stopping robot has reached its tag within this. Chosen: a tenth of what it knows of the tag's place.
constexpr double kAtRest_m = 0.003;
/// A leg shorter than this begins where it ends: it is reached as soon as the place is known.
constexpr double kNoLeg_m = 0.3;
constexpr double kTurned_rad = 0.015;  ///< a turn on the spot ends this near. Chosen: 1.5 cm per metre
constexpr double kBacking_mps = 0.1;
constexpr double kLooking_radps = 0.6;
constexpr double kListening_radps = 0.3;  ///< chosen: twice round in the time until it gives up
/// On the way to the first tag the line to it is drawn anew until this near, as its place becomes known.
constexpr double kRedrawn_m = 0.6;

std::vector<ListedTag> without_repeats(const std::vector<ListedTag>& route) {
  std::vector<ListedTag> tags;
  std::set<Epc> seen;
  for (const ListedTag& tag : route) {
    if (seen.insert(tag.epc).second) {
      tags.push_back(tag);
    }
  }
  return tags;
}

}  // namespace

CeilingMission::CeilingMission(const CeilingMissionConfig& config)
    : config_(config), estimator_(config.estimator, without_repeats(config.route)) {
  assert(!config.route.empty());
  const std::vector<ListedTag> tags = without_repeats(config.route);
  for (const ListedTag& stop : config.route) {
    const auto at =
        std::find_if(tags.begin(), tags.end(), [&](const ListedTag& t) { return t.epc == stop.epc; });
    route_.push_back(static_cast<int>(at - tags.begin()));
  }
  events_.reserve(kMostEvents);
  attended_.reserve(route_.size());
  attend();
}

bool CeilingMission::is_last() const {
  return config_.path == TagPathKind::kCircleAbout ? leg_ == 1 : leg_ + 1 == route_.size();
}

PhaseCommand CeilingMission::step(const PhaseSensed& sensed) {
  before_ = started_ ? now_ : sensed.stamp;
  now_ = sensed.stamp;
  if (!started_) {
    started_ = true;
    leg_since_ = now_;
    mode_ = CeilingMode::kDriving;
  }
  estimator_.step(sensed);
  const WheelStep way = wheel_step(config_.estimator.wheels, sensed.counts_left, sensed.counts_right);
  step_m_ = way.forward_m;
  step_rad_ = way.turn_rad;
  loudest_dbm_.reset();
  for (const UhfRead& read : sensed.reads) {
    if (read.epc == config_.route[destination()].epc) {
      loudest_dbm_ = std::max(loudest_dbm_.value_or(read.rssi_dbm), read.rssi_dbm);
    }
  }
  hear_estimator();
  if (mode_ == CeilingMode::kFinished) {
    return {};
  }
  watch_reader(sensed);
  watch_destination();
  watch_order();
  watch_corridor();
  if ((sensed.bump_left || sensed.bump_right) && mode_ != CeilingMode::kBackingOff &&
      mode_ != CeilingMode::kFinished) {
    note(CeilingEventKind::kBump);
    mode_ = CeilingMode::kBackingOff;
    backed_m_ = 0.0;
    if (++bumps_ > config_.faults.most_bumps) {
      finish(false);
    }
  }
  switch (mode_) {
    case CeilingMode::kDriving:
    case CeilingMode::kLooking:
      return {drive()};
    case CeilingMode::kTurning:
      return {turn()};
    case CeilingMode::kBackingOff:
      return {back_off(sensed)};
    case CeilingMode::kSearching:
      return {search()};
    case CeilingMode::kWaiting:
      // A reader that is there and hears nothing may hear a tag in another heading.
      return {wheels_for(config_.follower, 0.0, reader_up_ ? kListening_radps : 0.0)};
    case CeilingMode::kFinished:
      break;
  }
  return {};
}

WheelSpeeds CeilingMission::drive() {
  // The first leg's line follows the estimate: nothing is asked of its course.
  if (leg_ == 0) {
    const std::optional<Vec2> to = place(0);
    if (to && (*to - estimator_.pose().p_m).norm() > kRedrawn_m) {
      origin_M_m_ = estimator_.pose().p_m;
    }
  }
  const TagEstimate sought = estimator_.tag(route_[destination()]);
  const std::optional<PathReference> path = reference(leg_);
  if (path && !guesses(sought)) {
    looking_.end();
    if (doubts_order()) {
      order_looked_rad_ += std::abs(step_rad_);
      return wheels_for(config_.follower, 0.0, kLooking_radps);
    }
    mode_ = CeilingMode::kDriving;
    return drive_to(*path);
  }
  return look(sought);
}

bool CeilingMission::reached(const PathReference& path) const {
  const FollowerConfig& f = config_.follower;
  if (config_.path == TagPathKind::kCircleAbout) {
    if (leg_ == 0) {
      return std::abs(path.to_go_m) < f.look_ahead_m || path.to_go_m < 0.0;
    }
    return circled_rad_ >= 2.0 * kPi * config_.circle_laps;
  }
  const TagKnowledge knowledge = estimator_.tag(route_[leg_]).knowledge;
  if (knowledge != TagKnowledge::kTracked && knowledge != TagKnowledge::kKept) {
    return false;
  }
  if (leg_ == 0 && spread_m(route_[0]) < kNoLeg_m / 3.0 && (*place(0) - origin_M_m_).norm() < kNoLeg_m) {
    return true;
  }
  if (is_last() || config_.path != TagPathKind::kPolyline) {
    return path.to_go_m <= (f.stop_at_corners && is_last() ? kAtRest_m : 0.0);
  }
  if (f.stop_at_corners) {
    return path.to_go_m <= kAtRest_m;
  }
  return path.to_go_m <= f.corner_lead_m * std::tan(std::abs(corner_rad()) / 4.0);
}

WheelSpeeds CeilingMission::drive_to(const PathReference& path) {
  if (config_.path == TagPathKind::kCircleAbout && leg_ == 1) {
    circled_rad_ += (config_.circle_left ? 1.0 : -1.0) * wrap_angle(path.yaw_rad - last_bearing_rad_);
    last_bearing_rad_ = path.yaw_rad;
  }
  if (reached(path)) {
    const std::size_t before = leg_;
    reach();
    if (mode_ == CeilingMode::kFinished) {
      return {};
    }
    if (mode_ == CeilingMode::kTurning) {
      return turn();
    }
    const std::optional<PathReference> next = leg_ != before ? reference(leg_) : std::nullopt;
    return next ? follow(config_.follower, *next, estimator_.pose().yaw_rad, config_.follower.speed_mps)
                : wheels_for(config_.follower,
                             config_.follower.stop_at_corners ? 0.0 : config_.follower.speed_mps, 0.0);
  }
  const FollowerConfig& f = config_.follower;
  double speed = f.speed_mps;
  if (f.stop_at_corners && config_.path == TagPathKind::kPolyline &&
      (is_last() || std::abs(corner_rad()) > f.corner_rad)) {
    speed = stopping_speed_mps(f, path.to_go_m);
  }
  const double astray = std::abs(wrap_angle(estimator_.pose().yaw_rad - path.yaw_rad));
  if (f.stop_at_corners && astray > kPi / 3.0) {
    mode_ = CeilingMode::kTurning;
    return turn();
  }
  return follow(f, path, estimator_.pose().yaw_rad, speed);
}

void CeilingMission::reach() {
  note(CeilingEventKind::kTagReached, route_[destination()]);
  if (is_last()) {
    note(CeilingEventKind::kArrived);
    finish(true);
    return;
  }
  const double corner = config_.path == TagPathKind::kPolyline ? corner_rad() : 0.0;
  from_ = leg_;
  begin_leg(leg_ + 1);
  if (mode_ == CeilingMode::kDriving && config_.follower.stop_at_corners &&
      config_.path == TagPathKind::kPolyline && std::abs(corner) > config_.follower.corner_rad) {
    mode_ = CeilingMode::kTurning;
  }
}

void CeilingMission::begin_leg(std::size_t leg) {
  leg_ = leg;
  leg_since_ = now_;
  origin_M_m_ = estimator_.pose().p_m;
  bumps_ = 0;
  silent_said_ = false;
  looking_.end();
  loudest_dbm_.reset();
  order_judged_ = false;
  order_looked_rad_ = 0.0;
  order_doubted_s_ = 0.0;
  looks_ = 0;
  if (config_.path == TagPathKind::kCircleAbout) {
    const std::optional<PathReference> path = reference(leg);
    last_bearing_rad_ = path ? path->yaw_rad : 0.0;
  }
  attend();
}

WheelSpeeds CeilingMission::turn() {
  const std::optional<PathReference> path = reference(leg_);
  if (!path) {
    return look(estimator_.tag(route_[destination()]));
  }
  const double error = wrap_angle(path->yaw_rad - estimator_.pose().yaw_rad);
  if (std::abs(error) < kTurned_rad) {
    mode_ = CeilingMode::kDriving;
    return drive();
  }
  return turn_in_place(config_.follower, error);
}

WheelSpeeds CeilingMission::back_off(const PhaseSensed& sensed) {
  backed_m_ -= step_m_;
  const bool free = !sensed.bump_left && !sensed.bump_right;
  if (free && backed_m_ >= config_.faults.back_off_m) {
    mode_ = CeilingMode::kDriving;
    return {};
  }
  // A body that does not come free within a hand's breadth is held: nothing more is tried.
  if (backed_m_ > 0.15 + config_.faults.back_off_m) {
    finish(false);
    return {};
  }
  return {-kBacking_mps, -kBacking_mps};
}

void CeilingMission::finish(bool arrived) {
  if (mode_ == CeilingMode::kFinished) {
    return;
  }
  mode_ = CeilingMode::kFinished;
  arrived_ = arrived;
  if (!arrived) {
    note(CeilingEventKind::kStopped);
  }
}

void CeilingMission::note(CeilingEventKind kind, std::optional<int> tag, double value) {
  if (events_.size() >= kMostEvents) {
    return;
  }
  CeilingEvent event{now_, kind, static_cast<int>(leg_), std::nullopt, value};
  if (tag && *tag >= 0) {
    const auto at = std::find(route_.begin(), route_.end(), *tag);
    event.tag = config_.route[static_cast<std::size_t>(at - route_.begin())].epc;
  }
  events_.push_back(event);
}

CeilingStatus CeilingMission::status() const {
  CeilingStatus s;
  s.X_MR = estimator_.pose();
  s.pose_covariance = estimator_.pose_covariance();
  s.leg = leg_;
  s.mode = mode_;
  s.path = reference(leg_);
  if (s.path && config_.path != TagPathKind::kCircleAbout) {
    const Vec2 n{-std::sin(s.path->yaw_rad), std::cos(s.path->yaw_rad)};
    s.across_sigma_m = estimator_.across_sigma_m(n, from_ ? route_[*from_] : -1, route_[leg_],
                                                 std::clamp(s.path->part, 0.0, 1.0));
  }
  return s;
}

}  // namespace sensotwin::robot
