// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/time.hpp"
#include "robot/drivers/roomba_state.hpp"
#include "robot/mapping/tile.hpp"
#include "robot/output/event_log.hpp"
#include "robot/program/hallway_program.hpp"
#include "robot/program/mapping_program.hpp"
#include "robot/program/phase_program.hpp"
#include "robot/settings/robot_settings.hpp"
#include "robot/telemetry/telemetry_hub.hpp"

namespace sensotwin::robot {

/// What is known of a robot before it moves.
struct RobotCard {
  int id{0};              ///< tells robots on one page apart
  std::string name;       ///< of the robot or its file
  std::string title{};    ///< of what it does, for people
  std::string source{};   ///< "twin run", "twin serve", "sensobot run"
  std::string mission{};  ///< "map", "hallway", "phase", "serve"
  double tile_m{0.508};
  double radius_m{0.17};
  /// Of missions along ceiling tags: the names of the destinations, in order.
  std::vector<std::string> destinations{};
  std::string goal{};  ///< of missions to a place in hallways
};
[[nodiscard]] RobotCard card_of(const RobotSettings& settings, std::string name, std::string source);

/// Turns what a robot's program knows and says into telemetry. It reads what the program believes and never
/// what is true; a twin may add the truth, marked as such, by scene() and truth().
///
/// Every message has a kind "k" and a robot "r"; times are of the robot's clock, coordinates of its own
/// frame M (docs/monitor.md lists them).
class ProgramTap {
 public:
  /// The hub outlives the tap.
  ProgramTap(TelemetryHub& hub, RobotCard card);

  /// Of each line of events.jsonl: for EventLog::set_listener.
  void heard(Instant now, std::string_view event, std::initializer_list<EventField> fields);
  /// After each step of the program.
  void after_step(Instant now, const MappingProgram& program);
  void after_step(Instant now, const HallwayProgram& program);
  void after_step(Instant now, const PhaseProgram& program);
  /// How the run ended: "done", "interrupted", ...
  void ended(Instant now, std::string_view outcome);

  /// The base's last frame, where there is one that is new. Called by after_step().
  void sense(Instant now, const RoombaState* fresh);
  /// A pose every 7 ticks, and the trail: what the program believes.
  void pose(Instant now, const Pose2& X_MR);
  /// The same of a twin's truth; the trail, where a program believes no pose. \returns whether it was shown
  bool truth(Instant now, const Pose2& X_WR);
  /// Anything else of this robot. \param key  in this robot's name space  \param body  `,"key":value` ...
  void publish(std::string_view key, std::string_view kind, std::string_view body);
  /// The same, when it is not what was published last.
  void publish_changed(const std::string& key, std::string_view kind, std::string_view body);
  /// A value over time, for a chart: at most one a second is kept, the last 4096 of them.
  void sample(Instant now, std::string_view series, double value);

 private:
  /// A pose is shown every seventh tick: asked every tick, it says whether this is one.
  class PoseTurn {
   public:
    [[nodiscard]] bool is_now();

   private:
    int ticks_left_{0};
  };
  /// Poses of one kind, and the points that they leave behind.
  struct Track {
    std::string_view kind;
    std::string_view trail;  ///< kind of its points; empty: none are shown
    PoseTurn turn{};
    std::optional<Vec2> last_point_m{};
    std::int64_t points{0};
  };
  struct ShownTile {
    std::string state;
    unsigned blocked_sides{0};
    bool written{false};
    bool operator==(const ShownTile&) const = default;
  };

  bool show_pose(Track& track, Instant now, const Pose2& X);
  void show_tiles(const MappingProgram& program);
  void show_tile(const Tile& tile, const ShownTile& shown, TagUid tag);
  void show_places(const HallwayProgram& program);
  void show_ceiling(const CeilingMission& mission);
  void show_way(const HallwayProgram& program);
  /// Whatever stands on the page in figures: once a second, and when the mission is done.
  [[nodiscard]] bool status_is_due(Instant now, bool done);

  TelemetryHub& hub_;
  RobotCard card_;
  std::string prefix_;
  std::map<Tile, ShownTile> tiles_;
  std::map<Tile, double> found_s_;
  std::set<Tile> written_;
  std::map<std::string, std::string> shown_;  ///< by key, what was published last
  struct Series {
    std::int64_t samples{0};
    double last_s{0.0};
  };
  std::map<std::string, Series, std::less<>> series_;
  bool changed_{true};
  Track believed_{"pose", "trail"};
  Track true_{"truth", ""};
  std::optional<double> status_s_;
  std::optional<double> base_s_;
  std::int64_t events_{0};
  bool done_{false};
};

}  // namespace sensotwin::robot
