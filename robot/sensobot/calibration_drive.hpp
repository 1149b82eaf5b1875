// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robot/base/task.hpp"
#include "robot/base/time.hpp"
#include "robot/base/wheel_speeds.hpp"

namespace sensotwin::robot {

struct CalibrationConfig {
  double wheel_base_m{0.235};  ///< as it is told now
  int turns{5};                ///< each way round; 0: the wheel base is left alone
  int tags{4};                 ///< tiles from the first tag crossed to the last; 0: the way is left alone
  double tile_m{0.508};        ///< from tag to tag
  double turn_radps{1.0};      ///< chosen: half of what missions turn at; wheels do not slip
  double speed_mps{0.1};       ///< chosen: a second over a spot of 10 cm
  /// Standing before and after a turn. Chosen: ten headings of a compass at 10 Hz, after it has settled.
  Duration settle{std::chrono::milliseconds{500}};
  Duration average{std::chrono::milliseconds{1000}};
};

/// What the drive is told each step.
struct CalibrationSensed {
  Instant now;
  double left_m{0.0};  ///< way of each wheel since the start, by the present wheel diameter
  double right_m{0.0};
  std::optional<double> yaw_from_north_rad{};  ///< a new heading of the compass
  bool tag_entered{false};
  bool tag_left{false};
  bool bumped{false};
};

/// Why a calibration came to nothing.
enum class CalibrationFault : std::uint8_t { kNone, kNoCompass, kTooFewTags, kBumped };
[[nodiscard]] const char* say(CalibrationFault fault);

/// Each figure measured twice: turning left and right, driving forward and back.
struct CalibrationResult {
  CalibrationFault fault{CalibrationFault::kNone};
  std::array<double, 2> wheel_base_m{};  ///< empty turns: 0
  std::array<double, 2> way_scale{};     ///< true way / way by the encoders; empty tags: 0
};

/// Drives what a calibration needs.
///
/// Wheel base: a whole number of turns on the spot, by the encoders, and the compass before and after. Both
/// headings are read at the same place and nearly the same angle, so iron in the floor cancels; what the
/// robot turned in truth is the whole number and their difference:
///
///     base = base told * turn by the encoders / turn by the compass
///
/// Two headings averaged over ten readings of 1 degree are 0.45 degrees apart by chance, 0.025 % of 5 turns.
///
/// Way: straight over tags that lie a tile apart. The middle of a tag is half-way between its entering and
/// its leaving; a reader that notices both late by the same time shifts all middles alike. Begins over the
/// first tag or before it, with as many tags ahead as are asked for.
class CalibrationDrive {
 public:
  explicit CalibrationDrive(const CalibrationConfig& config);
  CalibrationDrive(const CalibrationDrive&) = delete;
  CalibrationDrive& operator=(const CalibrationDrive&) = delete;

  /// \pre sensed.now never earlier than before
  [[nodiscard]] WheelSpeeds step(const CalibrationSensed& sensed);
  [[nodiscard]] bool done() const { return task_.done(); }
  [[nodiscard]] const CalibrationResult& result() const { return result_; }

 private:
  [[nodiscard]] Task<> run();
  [[nodiscard]] Task<> turn(std::size_t which);
  [[nodiscard]] Task<> cross(std::size_t which);
  /// Stands; the mean heading at the end of it, when the compass spoke.
  [[nodiscard]] Task<std::optional<double>> heading();
  [[nodiscard]] double way_m() const { return 0.5 * (sensed_.left_m + sensed_.right_m); }
  /// Counter-clockwise, by the wheel base told.
  [[nodiscard]] double turned_rad() const {
    return (sensed_.right_m - sensed_.left_m) / config_.wheel_base_m;
  }

  CalibrationConfig config_;
  StepSignal next_step_;
  CalibrationSensed sensed_;
  WheelSpeeds wheels_;
  CalibrationResult result_;
  Task<> task_;
  bool started_{false};
};

}  // namespace sensotwin::robot
