// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/program/base_sensing.hpp"
#include "robot/program/mode_keeper.hpp"
#include "robot/topology/hallway_mission.hpp"
#include "robot/topology/hallway_survey.hpp"

namespace sensotwin::robot {

/// Where the devices are plugged in. All links outlive the program.
struct HallwayLinks {
  ByteLink& base;          ///< Roomba, serial
  CardLink& floor_reader;  ///< reads the tags near junctions
  ByteLink& sensors;       ///< compass and rangefinders, serial
};

struct HallwayProgramConfig {
  RoombaConfig base;
  TagReaderConfig floor_reader;
  std::variant<HallwayMissionConfig, HallwaySurveyConfig> mission;
};

/// The drivers and a mission in hallways as one program: stepped every 15 ms, by the twin in virtual time or
/// by the machine's main loop on real ports. It sees bytes and time, nothing else. A tag counts as come upon
/// when its unique number is known. Neither copies nor moves.
class HallwayProgram {
 public:
  HallwayProgram(const HallwayLinks& links, const HallwayProgramConfig& config);
  HallwayProgram(const HallwayProgram&) = delete;
  HallwayProgram& operator=(const HallwayProgram&) = delete;

  /// \param now  15 ms after the last call, or as near to it as the clock allows
  void step(Instant now);
  /// Stops the wheels and ends the talk with the base.
  void shut_down() { base_.shut_down(); }

  [[nodiscard]] bool done() const { return mission_ ? mission_->done() : survey_->done(); }
  /// At the goal; of a survey, the map is whole.
  [[nodiscard]] bool arrived() const { return mission_ ? mission_->status().arrived : survey_->whole(); }
  /// The one of the two that runs; the other is nullptr.
  [[nodiscard]] const HallwayMission* mission() const { return mission_ ? &*mission_ : nullptr; }
  [[nodiscard]] const HallwaySurvey* survey() const { return survey_ ? &*survey_ : nullptr; }
  [[nodiscard]] const HallwayTracker& tracker() const {
    return mission_ ? mission_->tracker() : survey_->tracker();
  }
  /// The map it goes by; of a survey, as far as it is drawn.
  [[nodiscard]] const HallwayMap& map() const { return mission_ ? mission_->map() : survey_->map(); }
  /// The last place it was at.
  [[nodiscard]] std::optional<NodeIndex> place() const {
    return mission_ ? mission_->status().place : survey_->place();
  }
  /// Since they were last taken, in order.
  [[nodiscard]] std::vector<HallwayEvent> take_events() {
    return mission_ ? mission_->log().take() : survey_->log().take();
  }

  [[nodiscard]] const Roomba& base() const { return base_; }
  [[nodiscard]] const TagReader& floor_reader() const { return floor_reader_; }
  [[nodiscard]] const SensorBoard& sensor_board() const { return sensor_board_; }
  /// The last command given to the wheels.
  [[nodiscard]] const WheelSpeeds& wheels() const { return wheels_; }

 private:
  void gather_tags();
  void sense(const RoombaState& state);

  Roomba base_;
  TagReader floor_reader_;
  SensorBoard sensor_board_;
  ModeKeeper mode_keeper_;
  std::optional<HallwayMission> mission_;
  std::optional<HallwaySurvey> survey_;
  HallwaySensed sensed_;
  BaseSensing base_sensing_;
  std::optional<RoombaState> state_;
  Instant sonar_stamp_;
  WheelSpeeds wheels_;
};

}  // namespace sensotwin::robot
