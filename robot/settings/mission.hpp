// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/mapping/explorer_kind.hpp"
#include "robot/phase/fuzzy_controller.hpp"
#include "robot/phase/phase_pairing.hpp"
#include "robot/topology/hallway_config.hpp"

/// The section `mission:` of scenes and robot files. Field order here is the order in the YAML; each default
/// lives in its struct and nowhere else.
namespace sensotwin::robot {

/// How fast the robot works.
struct PaceSection {
  double tile_s{0.0};     ///< least time from tile to tile, s; 0: as fast as it goes
  double tag_s{0.0};      ///< time that a new tag costs, s; 0: as fast as the reader goes
  double speed_mps{0.3};  ///< driving. Chosen: 60 % of the Roomba's 0.5 m/s leaves room to correct
  double turn_radps{1.5707963267948966};  ///< turning on the spot. Chosen: a quarter turn a second
};
/// 3.4 s a tile and 4.4 s a new tag: what reproduces the paper's 69, 42 and 26 minutes (algorithms study,
/// B.2).
inline constexpr PaceSection kPaperPace{.tile_s = 3.4, .tag_s = 4.4};

/// SensoBot: map the carpet.
struct MapMission {
  ExplorerKind explorer{kDefaultExplorer};
  PaceSection pace;
};

/// Who steers along the ceiling tags.
enum class PhaseController : std::uint8_t {
  kFuzzy,  ///< Gueaieb & Miah
  kOwn,    ///< estimates where tags and robot are (robot/phase/estimation)
};
/// How the path runs through the projections of the destinations. In the order of TagPathKind.
enum class PhasePath : std::uint8_t { kPolyline, kSmooth, kCircle, kCircleAbout };
/// In the order of OnTagFault.
enum class OnMissingTag : std::uint8_t { kSearch, kSkip, kStop };

/// What to do about a list of tags that seems out of order. In the order of OnTagFault.
enum class OnOrderDoubt : std::uint8_t { kGoOn, kExchange, kStop };

/// Gueaieb & Miah: along a path given by ceiling tags, by phase difference.
struct PhaseMission {
  PhaseController controller{PhaseController::kFuzzy};
  std::vector<std::string> destinations;           ///< names of tags in order; none: all, as they are listed
  std::vector<std::string> exchanged;              ///< two tags whose codes the robot has the wrong way round
  double speed_mps{0.2};                           ///< Gueaieb & Miah, section V
  FuzzySets sets{kReproductionSets};               ///< fuzzy
  Pairing pairing{Pairing::kSameInstant};          ///< fuzzy
  PhasePath path{PhasePath::kPolyline};            ///< own; the fuzzy controller knows polylines only
  bool slow_corners{false};                        ///< own: brakes and turns on the spot
  double circle_radius_m{2.0};                     ///< own, circle_about
  double circle_laps{1.0};                         ///< own, circle_about
  OnMissingTag on_missing{OnMissingTag::kSkip};    ///< own
  double order_factor{0.0};                        ///< own; 0: the list is not doubted
  OnOrderDoubt on_order{OnOrderDoubt::kExchange};  ///< own
  std::optional<double> corridor_half_width_m;     ///< own: never further from its path than this
};

/// Tsukiyama: through hallways by a map of places and tags.
struct HallwaySection {
  std::string from;    ///< place where it stands; empty: it finds out
  std::string to;      ///< place to go to
  bool survey{false};  ///< draws the map instead, and needs none
  double speed_mps{HallwayConfig{}.speed_mps};
  HallwayLine follow{HallwayConfig{}.follow};
  double wall_m{HallwayConfig{}.wall_m};  ///< of the wall that is followed
};

/// What the robot is to do. Exactly one member is set.
struct Mission {
  std::optional<MapMission> map;
  std::optional<PhaseMission> phase;
  std::optional<HallwaySection> hallway;
};

}  // namespace sensotwin::robot
