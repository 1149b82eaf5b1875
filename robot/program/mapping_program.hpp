// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/mapping/mapping_mission.hpp"
#include "robot/program/base_sensing.hpp"
#include "robot/program/mode_keeper.hpp"
#include "robot/wire/tag_record.hpp"

namespace sensotwin::robot {

/// Where the devices are plugged in. All links outlive the program.
struct MappingLinks {
  ByteLink& base;            ///< Roomba, serial
  CardLink& floor_reader;    ///< antenna under the robot
  CardLink& forward_reader;  ///< antenna in front
  ByteLink& sensors;         ///< compass board, serial
};

struct MappingProgramConfig {
  RoombaConfig base;
  TagReaderConfig reader;
  MappingConfig mapping;
  /// Stamped into every tag written, so that coordinates of an older map are told from this one's.
  std::uint32_t map_id{1};
};

/// A landmark or a piece of furniture that the forward antenna read, and where the robot was then.
struct ObjectSeen {
  Instant stamp;
  TagUid tag{0};
  TagRecord record;
  Pose2 X_MR;
};

/// The drivers and the mapping mission as one program: stepped every 15 ms, by the twin in virtual time or by
/// the machine's main loop on real ports. It sees bytes and time, nothing else.
class MappingProgram {
 public:
  MappingProgram(const MappingLinks& links, const MappingProgramConfig& config,
                 std::unique_ptr<Explorer> explorer);

  /// \param now  15 ms after the last call, or as near to it as the clock allows
  void step(Instant now);
  /// Stops the wheels and ends the Open Interface. Nothing is to be stepped after that.
  void shut_down() { base_.shut_down(); }

  [[nodiscard]] bool done() const { return mission_.done(); }
  [[nodiscard]] MappingMission& mission() { return mission_; }
  [[nodiscard]] const MappingMission& mission() const { return mission_; }
  [[nodiscard]] const Roomba& base() const { return base_; }
  [[nodiscard]] const TagReader& floor_reader() const { return floor_reader_; }
  [[nodiscard]] const TagReader& forward_reader() const { return forward_reader_; }
  [[nodiscard]] const SensorBoard& sensor_board() const { return sensor_board_; }
  /// The last command given to the wheels.
  [[nodiscard]] const WheelSpeeds& wheels() const { return wheels_; }
  /// The last frame's battery and bumper, for whoever shows them. Nothing before the first frame.
  [[nodiscard]] const std::optional<RoombaState>& state() const { return state_; }
  /// Landmarks and furniture since they were last taken, each tag once.
  [[nodiscard]] std::vector<ObjectSeen> take_objects();

 private:
  void gather_objects();
  void sense(const RoombaState& state);
  void obey(const Command& command);

  MappingProgramConfig config_;
  Roomba base_;
  TagReader floor_reader_;
  TagReader forward_reader_;
  SensorBoard sensor_board_;
  ModeKeeper mode_keeper_;
  MappingMission mission_;
  Sensed sensed_;
  BaseSensing base_sensing_;
  std::optional<RoombaState> state_;
  WheelSpeeds wheels_;
  std::vector<ObjectSeen> objects_;
  std::vector<TagUid> known_objects_;
};

}  // namespace sensotwin::robot
