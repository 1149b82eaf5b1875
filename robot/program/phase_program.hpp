// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/drivers/uhf_reader.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/phase/estimation/ceiling_mission.hpp"
#include "robot/phase/estimation/dead_reckoning.hpp"
#include "robot/phase/fuzzy_mission.hpp"
#include "robot/program/base_sensing.hpp"
#include "robot/program/mode_keeper.hpp"
#include "robot/program/phase_events.hpp"

namespace sensotwin::robot {

/// Where the devices are plugged in. All links outlive the program.
struct PhaseLinks {
  ByteLink& base;          ///< Roomba, serial
  ByteLink& uhf_reader;    ///< LLRP connection
  CardLink& floor_reader;  ///< short-range antenna under the robot
  ByteLink& sensors;       ///< compass board, serial
};

struct PhaseProgramConfig {
  RoombaConfig base;
  UhfReaderConfig uhf_reader;
  TagReaderConfig floor_reader;
  WheelModel wheels;  ///< of the odometry shown beside the mission
  std::variant<FuzzyMissionConfig, CeilingMissionConfig> mission;
};

/// The drivers and a mission along ceiling tags as one program: stepped every 15 ms, by the twin in virtual
/// time or by the machine's main loop on real ports. It sees bytes and time, nothing else.
///
/// A floor tag below a ceiling tag holds that one's EPC in its first three blocks; it counts as come upon
/// when they have been read. Neither copies nor moves.
class PhaseProgram {
 public:
  PhaseProgram(const PhaseLinks& links, const PhaseProgramConfig& config);
  PhaseProgram(const PhaseProgram&) = delete;
  PhaseProgram& operator=(const PhaseProgram&) = delete;

  /// \param now  15 ms after the last call, or as near to it as the clock allows
  void step(Instant now);
  /// Stops the wheels, ends the Open Interface and the reader's inventory. Nothing is to be stepped after
  /// that.
  void shut_down();

  [[nodiscard]] bool done() const;
  /// At the last destination.
  [[nodiscard]] bool arrived() const;
  /// Index of the present destination; their number when all are reached.
  [[nodiscard]] std::size_t leg() const;
  /// The one of the two that runs; the other is nullptr.
  [[nodiscard]] const FuzzyMission* fuzzy() const { return fuzzy_ ? &*fuzzy_ : nullptr; }
  [[nodiscard]] const CeilingMission* ceiling() const { return ceiling_ ? &*ceiling_ : nullptr; }
  /// Since they were last taken, in order.
  [[nodiscard]] std::vector<PhaseEvent> take_events();

  [[nodiscard]] const Roomba& base() const { return base_; }
  [[nodiscard]] const UhfReader& uhf_reader() const { return uhf_reader_; }
  [[nodiscard]] const TagReader& floor_reader() const { return floor_reader_; }
  [[nodiscard]] const SensorBoard& sensor_board() const { return sensor_board_; }
  /// By the wheels alone; frame O, the pose at the first frame.
  [[nodiscard]] const Pose2& odometry() const { return X_OR_; }
  /// Where the mission thinks that the robot is, frame M; none with the fuzzy controller.
  [[nodiscard]] std::optional<Pose2> estimate() const;
  /// The last command given to the wheels.
  [[nodiscard]] const WheelSpeeds& wheels() const { return wheels_; }

 private:
  void gather_reads();
  void gather_floor_tags();
  void sense(const RoombaState& state);
  [[nodiscard]] PhaseCommand think();

  Roomba base_;
  UhfReader uhf_reader_;
  TagReader floor_reader_;
  SensorBoard sensor_board_;
  ModeKeeper mode_keeper_;
  WheelModel wheel_model_;
  std::optional<FuzzyMission> fuzzy_;
  std::optional<CeilingMission> ceiling_;
  PhaseSensed sensed_;
  std::vector<UhfRead> reads_;  ///< since the mission's last step
  BaseSensing base_sensing_;
  std::optional<RoombaState> state_;
  Pose2 X_OR_;
  WheelSpeeds wheels_;
};

}  // namespace sensotwin::robot
