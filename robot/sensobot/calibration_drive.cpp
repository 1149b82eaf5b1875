// SPDX-License-Identifier: MIT
#include "robot/sensobot/calibration_drive.hpp"

#include <cmath>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {
namespace {

/// Slower at the end of a turn, so that it stops where it should. Chosen: the last quarter turn.
constexpr double kBrake_rad = kPi / 2.0;
constexpr double kBraked = 0.3;

double wrapped(double rad) {
  return std::remainder(rad, 2.0 * kPi);
}

}  // namespace

const char* say(CalibrationFault fault) {
  switch (fault) {
    case CalibrationFault::kNone:
      return "nothing went wrong";
    case CalibrationFault::kNoCompass:
      return "the compass gave no heading while the robot stood";
    case CalibrationFault::kTooFewTags:
      return "fewer tags came under the robot than were asked for: does it stand over a row of tiles, facing "
             "along it?";
    case CalibrationFault::kBumped:
      break;
  }
  return "it touched something: clear two metres ahead of it";
}

CalibrationDrive::CalibrationDrive(const CalibrationConfig& config) : config_(config), task_(run()) {}

WheelSpeeds CalibrationDrive::step(const CalibrationSensed& sensed) {
  sensed_ = sensed;
  if (!started_) {
    started_ = true;
    task_.start();
  } else if (!task_.done()) {
    next_step_.resume();
  }
  return task_.done() ? WheelSpeeds{} : wheels_;
}

Task<> CalibrationDrive::run() {
  for (std::size_t which = 0; which < 2 && config_.turns > 0; ++which) {
    co_await turn(which);
    if (result_.fault != CalibrationFault::kNone) {
      co_return;
    }
  }
  for (std::size_t which = 0; which < 2 && config_.tags > 0; ++which) {
    co_await cross(which);
    if (result_.fault != CalibrationFault::kNone) {
      co_return;
    }
  }
}

Task<std::optional<double>> CalibrationDrive::heading() {
  wheels_ = {};
  const Instant begin = sensed_.now + config_.settle;
  const Instant end = begin + config_.average;
  double sines = 0.0;
  double cosines = 0.0;
  while (sensed_.now < end) {
    if (sensed_.now >= begin && sensed_.yaw_from_north_rad) {
      sines += std::sin(*sensed_.yaw_from_north_rad);
      cosines += std::cos(*sensed_.yaw_from_north_rad);
    }
    co_await next_step_;
  }
  if (sines == 0.0 && cosines == 0.0) {
    co_return std::nullopt;
  }
  co_return std::atan2(sines, cosines);
}

Task<> CalibrationDrive::turn(std::size_t which) {
  const double sign = which == 0 ? 1.0 : -1.0;
  const std::optional<double> before = co_await heading();
  const double begin_rad = turned_rad();
  const double goal_rad = config_.turns * 2.0 * kPi;
  double rest_rad = goal_rad;
  while (rest_rad > 0.0) {
    const double rate_radps = config_.turn_radps * (rest_rad < kBrake_rad ? kBraked : 1.0);
    const double wheel_mps = sign * rate_radps * config_.wheel_base_m / 2.0;
    wheels_ = {.left_mps = -wheel_mps, .right_mps = wheel_mps};
    co_await next_step_;
    rest_rad = goal_rad - sign * (turned_rad() - begin_rad);
  }
  const std::optional<double> after = co_await heading();
  if (!before || !after) {
    result_.fault = CalibrationFault::kNoCompass;
    co_return;
  }
  const double encoders_rad = turned_rad() - begin_rad;
  const double true_rad = sign * goal_rad + wrapped(*after - *before);
  result_.wheel_base_m[which] = config_.wheel_base_m * encoders_rad / true_rad;
}

Task<> CalibrationDrive::cross(std::size_t which) {
  const double sign = which == 0 ? 1.0 : -1.0;
  const double begin_m = way_m();
  const double limit_m = (config_.tags + 1.5) * config_.tile_m;
  std::optional<double> entered_m;
  std::optional<double> first_m;
  double last_m = 0.0;
  int crossed = 0;
  wheels_ = {.left_mps = sign * config_.speed_mps, .right_mps = sign * config_.speed_mps};
  while (crossed <= config_.tags && std::abs(way_m() - begin_m) < limit_m) {
    co_await next_step_;
    if (sensed_.bumped) {
      result_.fault = CalibrationFault::kBumped;
      break;
    }
    if (sensed_.tag_entered) {
      entered_m = way_m();
    } else if (sensed_.tag_left && entered_m) {
      last_m = 0.5 * (*entered_m + way_m());
      first_m = first_m.value_or(last_m);
      entered_m.reset();
      ++crossed;
    }
  }
  wheels_ = {};
  if (crossed <= config_.tags && result_.fault == CalibrationFault::kNone) {
    result_.fault = CalibrationFault::kTooFewTags;
  } else if (first_m) {
    result_.way_scale[which] = config_.tags * config_.tile_m / std::abs(last_m - *first_m);
  }
}

}  // namespace sensotwin::robot
