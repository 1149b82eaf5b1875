// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/calibration/antenna_fit.hpp"
#include "robot/calibration/spin_mission.hpp"
#include "robot/calibration/square_mission.hpp"
#include "robot/calibration/turn_mission.hpp"
#include "robot/calibration/wheel_fit.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/drivers/uhf_reader.hpp"
#include "robot/program/base_sensing.hpp"
#include "robot/program/mode_keeper.hpp"
#include "robot/settings/robot_program.hpp"
#include "robot/settings/robot_settings.hpp"

namespace sensotwin::robot {

/// What is to be measured. Zero: left alone.
struct CalibrationPlan {
  int turns{5};            ///< each way round, by the compass: a first wheel base
  int laps{3};             ///< each way round a square of floor tags: wheels and floor antenna
  int side{2};             ///< of that square, tiles
  double speed_mps{0.15};  ///< on the square. Chosen: a tag's zone takes a second
  int spins{0};            ///< under a ceiling tag, at each of four spots: UHF antennas and cables
  std::string tag{};       ///< name of that tag; empty: the file's first
};

/// What came of it.
struct CalibrationResult {
  std::string fault{};  ///< empty, or why it ended early, for people
  std::optional<Measured> turned_base_m{};
  std::optional<WheelFit> wheels{};
  std::optional<AntennaFit> antennas{};
};

/// Measures what `sensobot run` is then told: drives, listens, fits. Steps like a mission's program, on the
/// machine and in the twin. Neither copies nor moves.
class CalibrationProgram {
 public:
  /// All links outlive the program. \pre the plan's tag is among settings.ceiling_tags
  CalibrationProgram(const RobotLinks& links, const RobotSettings& settings, const CalibrationPlan& plan);
  CalibrationProgram(const CalibrationProgram&) = delete;
  CalibrationProgram& operator=(const CalibrationProgram&) = delete;

  /// \param now  15 ms after the last call, or as near to it as the clock allows
  void step(Instant now);
  /// Stops the wheels and ends the talk with the devices.
  void shut_down();

  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  [[nodiscard]] const CalibrationResult& result() const { return result_; }
  [[nodiscard]] const Roomba& base() const { return base_; }
  /// What it is at, for people.
  [[nodiscard]] std::string progress() const;

 private:
  enum class Stage : std::uint8_t { kTurns, kSquare, kSpins, kDone };
  void begin(Stage stage);
  void think();
  void watch_wheels();
  void end_turns();
  void end_square();
  void end_spins();
  void fail(std::string why);
  [[nodiscard]] const KnownTag& spin_tag() const;

  RobotSettings settings_;  ///< with what was measured so far
  CalibrationPlan plan_;
  Roomba base_;
  TagReader floor_reader_;
  SensorBoard sensor_board_;
  std::optional<UhfReader> uhf_reader_;
  ModeKeeper mode_keeper_;
  BaseSensing base_sensing_;
  Sensed sensed_;
  std::vector<UhfRead> reads_;
  std::optional<RoombaState> state_;
  WheelSpeeds wheels_;
  int still_steps_{0};  ///< told to move, and did not
  Stage stage_{Stage::kDone};
  std::optional<TurnMission> turns_;
  std::optional<SquareMission> square_;
  std::optional<SpinMission> spins_;
  CalibrationResult result_;
};

}  // namespace sensotwin::robot
