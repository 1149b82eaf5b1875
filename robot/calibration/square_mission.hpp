// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "robot/base/task.hpp"
#include "robot/calibration/wheel_log.hpp"
#include "robot/mapping/mapping_config.hpp"
#include "robot/mapping/mission_log.hpp"
#include "robot/mapping/navigator.hpp"
#include "robot/mapping/pilot.hpp"
#include "robot/mapping/tile_map.hpp"
#include "robot/mapping/tile_mover.hpp"

namespace sensotwin::robot {

/// Why a square came to nothing.
enum class SquareFault : std::uint8_t {
  kNone,
  kNoFirstTag,  ///< none within a metre ahead
  kTagMissing,  ///< none where one of the square's should be
  kBumped,      ///< touched something
  kInTheWay,    ///< the light bumper saw something
  kLifted,      ///< a wheel hangs, or there is a hole
  kLost,        ///< no tag found again
  kTooLong,     ///< longer than such a drive can take
};

struct SquarePlan {
  int laps{3};  ///< each way round
  int side{2};  ///< tiles from corner to corner
};

/// Drives round a square of tags, counter-clockwise first and as often clockwise, and logs what wheels and
/// antenna said. The first tag found is a corner; the square lies ahead and to the left.
///
/// It moves as a mapping mission does, by the same objects: from tag to tag on straight lines, its idea of
/// its pose corrected by each tag, so that wheels which are told quite wrongly still find the next one.
/// Writes nothing into tags. Neither copies nor moves: its behaviours hold references into it.
class SquareMission {
 public:
  SquareMission(const MappingConfig& config, const SquarePlan& plan);
  SquareMission(const SquareMission&) = delete;
  SquareMission& operator=(const SquareMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  [[nodiscard]] WheelSpeeds step(const Sensed& sensed);

  [[nodiscard]] bool done() const { return done_; }
  [[nodiscard]] SquareFault fault() const { return fault_; }
  /// Where it was going when it came to nothing.
  [[nodiscard]] Tile target() const { return target_; }
  [[nodiscard]] int laps_done() const { return static_cast<int>(log_of_wheels_.laps.size()); }
  [[nodiscard]] const WheelLog& log() const { return log_of_wheels_; }

 private:
  struct Entered {
    std::size_t step{0};
    Pose2 X_MR;
  };
  [[nodiscard]] Task<> run();
  [[nodiscard]] Task<bool> drive_lap(bool clockwise);
  void watch(const Sensed& sensed);
  void log(const Sensed& sensed);
  void end(SquareFault fault);

  MappingConfig config_;
  SquarePlan plan_;
  TileMap map_;
  MissionLog mission_log_;
  StepIo io_;
  Navigator navigator_;
  Pilot pilot_;
  TileMover mover_;
  WheelLog log_of_wheels_;
  std::optional<TagUid> in_field_;
  std::optional<Entered> entered_;  ///< a tag that has not said its name yet
  Tile target_;
  SquareFault fault_{SquareFault::kNone};
  bool started_{false};
  bool done_{false};
  Task<> script_;
};

}  // namespace sensotwin::robot
