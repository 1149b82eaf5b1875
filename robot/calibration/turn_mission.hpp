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
#include "robot/mapping/mission_io.hpp"
#include "robot/mapping/pose_track.hpp"

namespace sensotwin::robot {

struct TurnPlan {
  int turns{5};            ///< each way round
  double turn_radps{1.0};  ///< chosen: half of what missions turn at; wheels do not slip
  /// Standing before and after a turn. Chosen: ten headings of a compass at 10 Hz, after it has settled.
  Duration settle{std::chrono::milliseconds{500}};
  Duration average{std::chrono::milliseconds{1000}};
};

enum class TurnFault : std::uint8_t { kNone, kNoCompass, kBumped, kLifted };

/// The wheel base by turning on the spot: a whole number of turns by the encoders, and the compass before and
/// after. Both headings are read at the same place and nearly the same angle, so iron in the floor cancels;
/// what the robot turned in truth is the whole number and their difference:
///
///     base = base told * turn by the encoders / turn by the compass
///
/// In the end it faces as it did in the beginning, by the compass: along a row of tags, if it did then.
///
/// Two headings averaged over ten readings of 1 degree are 0.45 degrees apart by chance, 0.025 % of 5 turns.
class TurnMission {
 public:
  TurnMission(const OdometryModel& wheels, const TurnPlan& plan);
  TurnMission(const TurnMission&) = delete;
  TurnMission& operator=(const TurnMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  [[nodiscard]] WheelSpeeds step(const Sensed& sensed);
  [[nodiscard]] bool done() const { return task_.done() || fault_ != TurnFault::kNone; }
  [[nodiscard]] TurnFault fault() const { return fault_; }
  /// Turning left, turning right. \pre done(), without a fault
  [[nodiscard]] const std::array<double, 2>& wheel_base_m() const { return wheel_base_m_; }

 private:
  [[nodiscard]] Task<> run();
  [[nodiscard]] Task<> turn(std::size_t which);
  /// By the wheels told. \param angle_rad  negative: clockwise
  [[nodiscard]] Task<> turn_by(double angle_rad);
  /// Stands; the mean heading at the end of it, when the compass spoke.
  [[nodiscard]] Task<std::optional<double>> heading();

  OdometryModel wheels_;
  TurnPlan plan_;
  StepSignal next_step_;
  Sensed sensed_;
  double turned_rad_{0.0};  ///< counter-clockwise, by the wheels told
  WheelSpeeds command_;
  std::array<double, 2> wheel_base_m_{};
  double off_rad_{0.0};  ///< from the first heading to the last, by the compass
  TurnFault fault_{TurnFault::kNone};
  bool started_{false};
  Task<> task_;
};

}  // namespace sensotwin::robot
