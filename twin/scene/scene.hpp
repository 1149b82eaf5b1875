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
#include "robot/mapping/explorer_kind.hpp"
#include "robot/phase/fuzzy_controller.hpp"
#include "robot/phase/phase_pairing.hpp"
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

/// What the scene file says of the place, from which Scene::world is made. Exactly one of room and map is
/// set.
struct Layout {
  std::optional<RoomPlan> room;
  std::optional<MapPlan> map;
  CarpetPlan carpet;
};

/// How fast the robot works.
struct Pace {
  double tile_s{0.0};     ///< least time from tile to tile, s; 0: as fast as it goes
  double tag_s{0.0};      ///< time that a new tag costs, s; 0: as fast as the reader goes
  double speed_mps{0.3};  ///< driving. Chosen: 60 % of the Roomba's 0.5 m/s leaves room to correct
  double turn_radps{1.5707963267948966};  ///< turning on the spot. Chosen: a quarter turn a second
};
/// 3.4 s a tile and 4.4 s a new tag: what reproduces the paper's 69, 42 and 26 minutes (algorithms study,
/// B.2).
inline constexpr Pace kPaperPace{.tile_s = 3.4, .tag_s = 4.4};

/// SensoBot: map the carpet.
struct MapMission {
  robot::ExplorerKind explorer{robot::kDefaultExplorer};
  Pace pace;
};

/// Who steers along the ceiling tags.
enum class PhaseController : std::uint8_t {
  kFuzzy,  ///< Gueaieb & Miah
  kOwn,    ///< estimates where tags and robot are (robot/phase/estimation)
};
/// How the path runs through the projections of the destinations. In the order of robot::TagPathKind.
enum class PhasePath : std::uint8_t { kPolyline, kSmooth, kCircle, kCircleAbout };
/// In the order of robot::OnTagFault.
enum class OnMissingTag : std::uint8_t { kSearch, kSkip, kStop };

/// What to do about a list of tags that seems out of order. In the order of robot::OnTagFault.
enum class OnOrderDoubt : std::uint8_t { kGoOn, kExchange, kStop };

/// Gueaieb & Miah: along a path given by ceiling tags, by phase difference.
struct PhaseMission {
  PhaseController controller{PhaseController::kFuzzy};
  std::vector<std::string> destinations;  ///< names of tags in order; none: all, as they are listed
  std::vector<std::string> exchanged;     ///< two tags whose codes the robot has the wrong way round
  double speed_mps{0.2};                  ///< Gueaieb & Miah, section V
  robot::FuzzySets sets{robot::kReproductionSets};       ///< fuzzy
  robot::Pairing pairing{robot::Pairing::kSameInstant};  ///< fuzzy
  PhasePath path{PhasePath::kPolyline};                  ///< own; the fuzzy controller knows polylines only
  bool slow_corners{false};                              ///< own: brakes and turns on the spot
  double circle_radius_m{2.0};                           ///< own, circle_about
  double circle_laps{1.0};                               ///< own, circle_about
  OnMissingTag on_missing{OnMissingTag::kSkip};          ///< own
  double order_factor{0.0};                              ///< own; 0: the list is not doubted
  OnOrderDoubt on_order{OnOrderDoubt::kExchange};        ///< own
  std::optional<double> corridor_half_width_m;           ///< own: never further from its path than this
};

/// What the robot is to do. Exactly one member is set.
struct Mission {
  std::optional<MapMission> map;
  std::optional<PhaseMission> phase;
};

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
  std::vector<Expectation> expect;
  RunLimits limits;
};

}  // namespace sensotwin::twin
