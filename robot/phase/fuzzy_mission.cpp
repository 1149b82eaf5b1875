// SPDX-License-Identifier: MIT
#include "robot/phase/fuzzy_mission.hpp"

#include <algorithm>
#include <cassert>

#include "robot/base/rolled_wheels.hpp"

namespace sensotwin::robot {

FuzzyMission::FuzzyMission(const FuzzyMissionConfig& config)
    : config_(config), controller_(config.sets), pairing_(config.pairing, Epc{}), script_(run()) {
  assert(config.speed_mps > 0.0 && config.speed_mps < config.top_wheel_mps);
}

PhaseCommand FuzzyMission::step(const PhaseSensed& sensed) {
  sensed_ = sensed;
  count_turn();
  listen();
  if (!started_) {
    started_ = true;
    script_.start();
  } else {
    next_.resume();
  }
  sensed_.reads = {};  // valid for this step only
  return command_;
}

Task<> FuzzyMission::run() {
  for (const Epc& destination : config_.destinations) {
    pairing_.follow(destination);
    listen();  // what this step heard so far was of the last destination
    status_.pair.reset();
    leg_begun_ = sensed_.stamp;
    heard_at_ = sensed_.stamp;
    say(FuzzyEventKind::kLegBegun);
    const End end = co_await drive_to_destination();
    if (end == End::kFailed) {
      stand();
      status_.state = FuzzyState::kStopped;
      co_return;
    }
    say(FuzzyEventKind::kArrived);
    ++status_.destination;
  }
  stand();
  say(FuzzyEventKind::kDone);
  status_.state = FuzzyState::kArrived;
}

Task<FuzzyMission::End> FuzzyMission::drive_to_destination() {
  while (!at_destination()) {
    if (must_end()) {
      co_return End::kFailed;
    }
    if (!sensed_.reader_up || sensed_.stamp - heard_at_ > config_.silence) {
      const FuzzyEventKind why =
          sensed_.reader_up ? FuzzyEventKind::kDestinationSilent : FuzzyEventKind::kReaderDown;
      const End end = co_await wait_standing(why);
      if (end == End::kFailed) {
        co_return End::kFailed;
      }
      continue;
    }
    steer();
    co_await next_;
  }
  co_return End::kWell;
}

Task<FuzzyMission::End> FuzzyMission::wait_standing(FuzzyEventKind why) {
  const Instant begun = sensed_.stamp;
  const bool down = why == FuzzyEventKind::kReaderDown;
  stand();
  status_.state = FuzzyState::kWaiting;
  say(why);
  for (;;) {
    co_await next_;
    if (must_end()) {
      co_return End::kFailed;
    }
    if (at_destination()) {
      co_return End::kWell;
    }
    if (down ? sensed_.reader_up : heard_.has_value()) {
      heard_at_ = sensed_.stamp;
      say(down ? FuzzyEventKind::kReaderUp : FuzzyEventKind::kHeardAgain);
      co_return End::kWell;
    }
    if (sensed_.stamp - begun > config_.patience) {
      say(FuzzyEventKind::kGivenUp);
      co_return End::kFailed;
    }
  }
}

void FuzzyMission::listen() {
  heard_.reset();
  for (const UhfRead& read : sensed_.reads) {
    if (const std::optional<PhasePair> pair = pairing_.add(read)) {
      heard_ = pair;
    }
  }
}

bool FuzzyMission::at_destination() const {
  return sensed_.floor_tag && *sensed_.floor_tag == config_.destinations[status_.destination];
}

void FuzzyMission::count_turn() {
  // Wheels that did not move at all have just been told to, stand, or have no encoders.
  if (last_stamp_ && (sensed_.counts_left != 0 || sensed_.counts_right != 0)) {
    const double asked_rad = status_.turn_rate_radps * to_s(sensed_.stamp - *last_stamp_);
    const RolledWheels rolled = rolled_m(config_, sensed_.counts_left, sensed_.counts_right);
    const double turned_rad = (rolled.right_m - rolled.left_m) / config_.wheel_base_m;
    status_.owed_rad =
        std::clamp(status_.owed_rad + asked_rad - turned_rad, -config_.most_owed_rad, config_.most_owed_rad);
  }
  last_stamp_ = sensed_.stamp;
}

void FuzzyMission::steer() {
  const double limit_radps = 2.0 * (config_.top_wheel_mps - config_.speed_mps) / config_.wheel_base_m;
  if (heard_) {
    if (!status_.pair) {
      say(FuzzyEventKind::kDestinationHeard);
    }
    heard_at_ = sensed_.stamp;
    status_.pair = heard_;
    ++status_.decisions;
    status_.turn_rate_radps =
        std::clamp(controller_.turn_rate_radps(heard_->difference_rad), -limit_radps, limit_radps);
    status_.state = FuzzyState::kSteering;
  } else if (!status_.pair || sensed_.stamp - heard_at_ > config_.longest_turn) {
    status_.turn_rate_radps = 0.0;
    status_.state = FuzzyState::kKeepingHeading;
  }
  const double rate_radps = std::clamp(status_.turn_rate_radps + config_.catch_up_per_s * status_.owed_rad,
                                       -limit_radps, limit_radps);
  const double half_mps = rate_radps * config_.wheel_base_m / 2.0;
  command_.wheels = {.left_mps = config_.speed_mps - half_mps, .right_mps = config_.speed_mps + half_mps};
}

void FuzzyMission::stand() {
  command_.wheels = {};
  status_.turn_rate_radps = 0.0;
  status_.owed_rad = 0.0;
}

bool FuzzyMission::must_end() {
  if (sensed_.bump_left || sensed_.bump_right) {
    say(FuzzyEventKind::kBumped);
    return true;
  }
  if (sensed_.stamp - leg_begun_ > config_.leg_limit) {
    say(FuzzyEventKind::kLegTooLong);
    return true;
  }
  return false;
}

void FuzzyMission::say(FuzzyEventKind kind) {
  const std::size_t last = config_.destinations.empty() ? 0 : config_.destinations.size() - 1;
  const Epc destination =
      config_.destinations.empty() ? Epc{} : config_.destinations[std::min(status_.destination, last)];
  log_.add(sensed_.stamp, kind, destination);
}

}  // namespace sensotwin::robot
