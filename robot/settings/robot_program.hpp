// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/program/hallway_program.hpp"
#include "robot/program/mapping_program.hpp"
#include "robot/program/phase_program.hpp"
#include "robot/settings/robot_settings.hpp"

namespace sensotwin::robot {

/// Every wire that a robot may have. Those that its mission does not use are left alone.
struct RobotLinks {
  ByteLink& base;
  ByteLink& sensors;
  ByteLink& uhf_reader;
  CardLink& floor_reader;
  CardLink& forward_reader;
};

/// The program that a robot file asks for, whichever it is: what `sensobot run` steps, and a replay steps
/// again. Neither copies nor moves.
class RobotProgram {
 public:
  /// All links outlive the program. \pre settings.mission has one member set, and was checked
  RobotProgram(const RobotLinks& links, const RobotSettings& settings);
  RobotProgram(const RobotProgram&) = delete;
  RobotProgram& operator=(const RobotProgram&) = delete;

  void step(Instant now);
  /// Stops the wheels and ends the talk with all devices.
  void shut_down();
  [[nodiscard]] bool done() const;
  [[nodiscard]] const Roomba& base() const;
  [[nodiscard]] const TagReader& floor_reader() const;
  [[nodiscard]] const SensorBoard& sensor_board() const;
  [[nodiscard]] const WheelSpeeds& wheels() const;
  /// The one of the three that runs; the others are nullptr.
  [[nodiscard]] MappingProgram* mapping() { return mapping_ ? &*mapping_ : nullptr; }
  [[nodiscard]] PhaseProgram* phase() { return phase_ ? &*phase_ : nullptr; }
  [[nodiscard]] HallwayProgram* hallway() { return hallway_ ? &*hallway_ : nullptr; }

 private:
  std::optional<MappingProgram> mapping_;
  std::optional<PhaseProgram> phase_;
  std::optional<HallwayProgram> hallway_;
};

}  // namespace sensotwin::robot
