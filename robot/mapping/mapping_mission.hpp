// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "robot/base/task.hpp"
#include "robot/mapping/explorer.hpp"
#include "robot/mapping/mapping_config.hpp"
#include "robot/mapping/mission_log.hpp"
#include "robot/mapping/navigator.hpp"
#include "robot/mapping/pilot.hpp"
#include "robot/mapping/tile_map.hpp"
#include "robot/mapping/tile_mover.hpp"

namespace sensotwin::robot {

/// SensoBot's first job (section III.A): find every tag of the carpet, write its coordinates into it, draw
/// the floor plan. One object, stepped once per Open Interface frame; the same on the machine and in the
/// twin.
///
/// Neither copies nor moves: its behaviours hold references into it.
class MappingMission {
 public:
  MappingMission(const MappingConfig& config, std::unique_ptr<Explorer> explorer);
  MappingMission(const MappingMission&) = delete;
  MappingMission& operator=(const MappingMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  /// \returns the command that holds until the next call
  Command step(const Sensed& sensed);

  [[nodiscard]] bool done() const { return finished_; }
  /// False when no tag was found at the start, or the robot got lost for good.
  [[nodiscard]] bool succeeded() const { return finished_ && succeeded_; }
  [[nodiscard]] const TileMap& map() const { return map_; }
  [[nodiscard]] const Navigator& navigator() const { return navigator_; }
  [[nodiscard]] const Explorer& explorer() const { return *explorer_; }
  [[nodiscard]] Tile at() const { return mover_.at(); }
  [[nodiscard]] MissionLog& log() { return log_; }
  [[nodiscard]] const MissionCounts& counts() const { return log_.counts; }

 private:
  Task<> run();
  /// Does a move and writes its outcome into the map. \returns false when the robot is lost for good
  /// \param squeeze  how narrow the ways of a detour may be
  Task<bool> perform(Move move, Squeeze squeeze = Squeeze::kNo);
  /// Tries tiles once more that were given up or blocked against the look of things. \returns true when one
  /// was reached
  Task<bool> try_doubtful();
  /// Tries the tiles to which no way was found once more, by narrower ways. \returns true when one was
  /// reached
  Task<bool> squeeze();
  /// Goes for tiles that no visited tile borders on, where a way seems open: behind one that cannot be
  /// entered there may be more. \returns true when one was reached
  Task<bool> leap();
  [[nodiscard]] std::set<Tile> beyond_neighbours() const;
  [[nodiscard]] std::optional<Tile> next_doubtful();
  [[nodiscard]] bool looks_solid(Tile tile) const;
  void give_up(Tile tile);
  /// Tiles given up around this one, newly visited, are open again.
  void reconsider_round(Tile tile);
  Task<> dwell(Instant begun, bool new_tag);

  MappingConfig config_;
  std::unique_ptr<Explorer> explorer_;
  TileMap map_;
  MissionLog log_;
  StepIo io_;
  Navigator navigator_;
  Pilot pilot_;
  TileMover mover_;
  std::set<std::pair<Tile, Tile>> touched_;  ///< moves that ended at something solid
  std::set<Tile> no_tag_;                    ///< where the way was free and no tag was found
  std::set<Tile> no_way_;                    ///< given up by a detour
  std::set<Tile> tried_again_;
  std::map<Squeeze, std::set<Tile>> squeezed_;  ///< tried by narrower ways
  std::set<Tile> leapt_;                        ///< tried though no visited tile borders on it
  bool finished_{false};
  bool succeeded_{false};
  bool started_{false};
  Task<> script_;
};

}  // namespace sensotwin::robot
