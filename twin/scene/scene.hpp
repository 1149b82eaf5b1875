// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/settings/hallway_file.hpp"
#include "robot/settings/mission.hpp"
#include "world/description.hpp"

/// A scene: everything that one run is made of. Field order here is the order in the YAML and in the schema;
/// each default lives in its struct and nowhere else.
namespace sensotwin::twin {

using robot::Vec2;

/// An inner wall: straight from each point to the next, and back to the first when closed.
struct Partition {
  std::vector<Vec2> points_m;
  bool closed{false};
};

/// A room drawn by its corners.
struct RoomPlan {
  std::vector<Vec2> walls_m;          ///< outer wall, closed, either way round
  std::vector<Partition> partitions;  ///< inner walls
};

/// A ROS map_server map: the path of its YAML, relative to the scene file.
struct MapPlan {
  std::string file;
  std::string hallways{};  ///< hallway map of the building, relative to the scene file; empty: none
};

/// Floor beside the hallways: a doorway, a room. Its walls are where it ends.
struct FloorPiece {
  Vec2 low_m{0.0, 0.0};
  Vec2 high_m{0.0, 0.0};
};

/// A building of hallways, drawn from its hallway map: walls on both sides of every hallway.
struct HallwaysPlan {
  std::string file;  ///< relative to the scene file
  std::vector<FloorPiece> rooms;
};

/// Which tiles are laid. A tile exists where its middle, which is where its tag sits, lies on floor: slivers
/// along the border that are too narrow to hold a tag are left out (SensoBot, chapter 5). Carpet lies under
/// furniture too; those tiles are simply out of reach. In an imported map, occupied and unknown cells are not
/// floor.
struct CarpetPlan {
  bool laid{true};  ///< false: `carpet: none`, a bare floor
  double tile_m{world::Carpet{}.tile_m};
  std::optional<Vec2> origin_m;                   ///< a corner of the grid; none: the lower left of the floor
  std::optional<std::pair<Vec2, Vec2>> region_m;  ///< lay only within these two opposite corners
  std::optional<std::vector<std::pair<int, int>>> tiles;  ///< (column, row): exactly these, wherever they lie
  std::vector<std::pair<int, int>> without;               ///< leave these out
  std::vector<std::pair<int, int>> unreadable;            ///< their tags are dead
  double tag_offset_sigma_m{world::Carpet{}.tag_offset_sigma_m};
};

/// What the scene file says of the place, from which Scene::world is made. Exactly one of room, map and
/// hallways is set.
struct Layout {
  std::optional<RoomPlan> room;
  std::optional<MapPlan> map;
  std::optional<HallwaysPlan> hallways;
  CarpetPlan carpet;
};

using robot::HallwaySection;
using robot::MapMission;
using robot::Mission;
using robot::OnMissingTag;
using robot::PhaseController;
using robot::PhaseMission;
using robot::PhasePath;
using Pace = robot::PaceSection;

/// Inclusive; at least one is set.
struct Bounds {
  std::optional<double> min;
  std::optional<double> max;
};

/// What the runs of many seeds come to in one figure.
struct SeedStatistic {
  std::string_view key;
  std::string_view help;
  std::optional<double> quantile;  ///< none: the mean
};
inline constexpr std::array<SeedStatistic, 6> kSeedStatistics{{
    {"mean", "over the seeds of a validation", std::nullopt},
    {"median", "over the seeds of a validation", 0.5},
    {"quantile_2_5", "below which 2.5 % of the seeds of a validation lie", 0.025},
    {"quantile_5", "below which 5 % of the seeds of a validation lie", 0.05},
    {"quantile_95", "below which 95 % of the seeds of a validation lie", 0.95},
    {"quantile_97_5", "below which 97.5 % of the seeds of a validation lie", 0.975},
}};

/// A figure of the summary and what is asked of it. `min` and `max`, both inclusive, of each run; the rest of
/// many seeds together, by `twin validate` alone. At least one bound is set.
struct Expectation {
  std::string name;
  std::optional<double> min;
  std::optional<double> max;
  /// Share of the seeds, above 0 and at most 1, that must keep min and max; none: every seed.
  std::optional<double> rate_min{};
  std::array<std::optional<Bounds>, kSeedStatistics.size()> statistics{};
};

struct RunLimits {
  /// The run ends undone after this time, s. Chosen: five times the paper's slowest house (69 min).
  double time_limit_s{20700.0};
};

struct Scene {
  int version{1};         ///< of the file format; the reader refuses others
  std::uint64_t seed{0};  ///< every random stream of the run forks from this
  std::string title;      ///< `title:`, else the first comment line of the file
  std::string variant;    ///< that was chosen; empty: none
  std::string name;       ///< the file's name without folder and extension, and of a variant "-" and its name
  std::vector<std::string> variants;  ///< names of those that the file offers
  std::string file;                   ///< as the user spelt it
  Layout layout;
  world::WorldDescription world;  ///< walls and carpet made from `layout`
  world::RobotDescription robot;
  world::PhysicsDescription physics;
  Mission mission;
  robot::HallwayFile hallways;  ///< that `layout` names; empty where there is none
  std::string known_file;       ///< hallway map that the robot is given instead, relative; empty: the same
  std::optional<robot::HallwayFile> known;  ///< what stands in it
  std::vector<Expectation> expect;
  RunLimits limits;
};

}  // namespace sensotwin::twin
