// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "robot/base/task.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/calibration/antenna_log.hpp"
#include "robot/mapping/mission_io.hpp"
#include "robot/phase/estimation/dead_reckoning.hpp"

namespace sensotwin::robot {

enum class SpinFault : std::uint8_t {
  kNone,
  kNotHeard,  ///< the tag was not read during the first turn
  kBumped,
  kLifted,
};

struct SpinPlan {
  int turns{2};            ///< at each spot, the first half of them left, the others right
  int spots{4};            ///< chosen: echoes are others at each; half a minute each
  double step_m{0.12};     ///< from spot to spot. Chosen: more than echoes keep to (8 cm: data study, 4)
  double turn_radps{0.5};  ///< chosen: a degree between two reads of a port
  double speed_mps{0.1};   ///< chosen: slow, for a way that is measured
};

/// Turns on the spot under a tag, drives a step ahead, turns again and so on, and comes back; keeps every
/// read of that tag with the place where it was made.
class SpinMission {
 public:
  SpinMission(const WheelModel& wheels, const Epc& tag, const SpinPlan& plan);
  SpinMission(const SpinMission&) = delete;
  SpinMission& operator=(const SpinMission&) = delete;

  /// One control step. \param reads  since the last one, in the order of their times
  [[nodiscard]] WheelSpeeds step(const Sensed& sensed, std::span<const UhfRead> reads);
  [[nodiscard]] bool done() const { return task_.done() || fault_ != SpinFault::kNone; }
  [[nodiscard]] SpinFault fault() const { return fault_; }
  [[nodiscard]] const std::vector<PlacedRead>& reads() const { return reads_; }

 private:
  [[nodiscard]] Task<> run();
  [[nodiscard]] Task<> turn(double turns);
  [[nodiscard]] Task<> roll(double way_m);
  void keep(std::span<const UhfRead> reads);

  WheelModel wheels_;
  Epc tag_;
  SpinPlan plan_;
  StepSignal next_step_;
  DeadReckoning reckoning_;
  WheelStep moved_;
  WheelSpeeds command_;
  std::vector<PlacedRead> reads_;
  std::size_t spot_{0};
  bool turning_{false};
  SpinFault fault_{SpinFault::kNone};
  bool started_{false};
  Task<> task_;
};

}  // namespace sensotwin::robot
