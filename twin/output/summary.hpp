// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::twin {

/// What a mapping mission came to. Tiles of the truth are counted by the twin, outside robot/.
struct MapResult {
  std::string explorer{};
  int tiles_reachable{0};       ///< over whose tag the robot can bring its antenna at all
  int tiles_grid_reachable{0};  ///< of these, by straight moves between neighbouring tags
  int tiles_mapped{0};          ///< that hold their right coordinates
  int tiles_missed{0};          ///< reachable, not mapped
  int tiles_wrong{0};           ///< that hold wrong coordinates, or are claimed twice
  int tiles_given_up{0};        ///< that the robot itself reports as unreachable
  int visits{0};                ///< S_T, every tag driven over
  int visits_paper{0};          ///< S_T as Algorithm 1 counts it
  double epsilon{0.0};          ///< visits beyond one for each tile, as a fraction of the tiles
  double minutes{0.0};          ///< simulated, until the map was complete
  double metres{0.0};
  double turns{0.0};       ///< quarter turns
  double energy_wh{0.0};   ///< drawn from the battery
  int moves{0};            ///< from tile to tile
  int moves_missed{0};     ///< that did not meet their tag
  int moves_recovered{0};  ///< of these, found by local search
};

/// What no estimator without bias can go below on the ideal path with the same reads: posterior Cramer-Rao
/// (twin/run/scene_bound.hpp), beside PathResult's rmse of the same parts.
struct BoundResult {
  double bound_m{0.0};
  double bound_first_half_m{0.0};
  double bound_second_half_m{0.0};
};

/// What a mission along ceiling tags came to. Errors are of the truth against the ideal path, counted by the
/// twin, outside robot/: signed perpendicular distance to the line of the present leg, left of travel
/// positive; of curves, the distance to the nearest point. Counted are the legs that begin at a tag, not the
/// way to the first (Gueaieb & Miah, section V), once each tick.
struct PathResult {
  std::string controller{};
  double rmse_m{0.0};              ///< Gueaieb & Miah, equation 4
  double rmse_first_half_m{0.0};   ///< of the first half of the legs: the first of two laps
  double rmse_second_half_m{0.0};  ///< of the second half of the legs: later laps
  double error_min_m{0.0};
  double error_max_m{0.0};
  double off_path_max_m{0.0};  ///< farthest from the nearest point of the whole path, on the legs counted
  int arrived{0};              ///< 1: the mission says that it is at the last tag
  int tags_reached{0};         ///< destinations
  int tags_skipped{0};
  double minutes{0.0};          ///< simulated, to the end
  double time_to_first_s{0.0};  ///< until the first destination; to the end when it was never reached
  double metres{0.0};           ///< driven, in truth
  double end_error_m{0.0};      ///< at the end, from the last destination's projection
  int wall_contacts{0};
  std::int64_t uhf_reads{0};  ///< as the driver gave them
  std::int64_t uhf_faults{0};
  std::optional<BoundResult> bound;  ///< of our own controller
};

/// What a mission in hallways came to.
struct HallwayResult {
  std::string mission{};   ///< "go" or "survey"
  int arrived{0};          ///< 1: it says that it is at the goal, and is; of a survey, that its map is whole
  double length_m{0.0};    ///< driven, in truth
  double shortest_m{0.0};  ///< from start to goal over the hallways of the map; 0 of a survey
  double detour{0.0};      ///< length_m / shortest_m; 0 where there is no shortest way
  int wall_contacts{0};
  double end_error_m{0.0};  ///< at the end, from the middle of the goal
  double minutes{0.0};
  int tags_read{0};
  int tags_missed{0};      ///< places that it knew by its rangefinders alone
  int turned_wrong{0};     ///< times that a tag told it that it faced another way
  int blocked{0};          ///< hallways given up
  int went_round{0};       ///< things passed
  int shoved{0};           ///< times that somebody turned it
  int explored{0};         ///< hallways of its map whose end it found
  int places{0};           ///< of its map at the end
  int map_differences{0};  ///< of a survey: sides of places that are not as drawn
};

/// Health of the wires, counted by the drivers on the robot's side.
struct LinkHealth {
  std::int64_t roomba_frames{0};
  std::int64_t roomba_frames_corrupt{0};  ///< checksum or length wrong
  std::int64_t roomba_frames_missed{0};   ///< that should have come and did not
  std::int64_t roomba_watchdog_stops{0};  ///< wheels stopped because frames had stopped
  std::int64_t card_exchanges{0};         ///< APDUs, both readers
  std::int64_t card_exchanges_failed{0};
  std::int64_t card_writes_repeated{0};
  std::int64_t compass_sentences{0};
  std::int64_t compass_sentences_corrupt{0};
};

/// What the scene asks of one figure. A limit is inclusive; an absent one always holds.
struct FigureLimits {
  std::string name{};
  std::optional<double> min{};
  std::optional<double> max{};
};
struct JudgedFigure {
  FigureLimits asked;
  double value{0.0};
  bool ok{false};
};

/// summary.json. Nothing in it depends on the machine, its load or its clock: equal runs, equal bytes.
struct Summary {
  std::string scene;    ///< as given on the command line
  std::string variant;  ///< of the scene; empty: none
  std::uint64_t seed{0};
  bool interrupted{false};
  std::vector<JudgedFigure> expect;
  std::string state_hash;  ///< StateHash::text()
  double sim_s{0.0};
  std::optional<MapResult> map;
  std::optional<PathResult> path;
  std::optional<HallwayResult> hallway;
  LinkHealth links;
};

/// "accepted" (all expectations met, none included), "not_accepted" or "interrupted".
[[nodiscard]] std::string_view verdict_of(const Summary& summary);

/// Figures by name, as `expect:` in a scene may ask for them; the mission's are absent when it had none.
using Figures = std::map<std::string, double, std::less<>>;
[[nodiscard]] Figures figures_of(const Summary& summary);

/// Every name that figures_of can give, sorted: the same before the run as after it.
[[nodiscard]] std::vector<std::string> figure_names();

/// One line that says what is wrong with the first expectation whose name is no figure, valid names included;
/// nothing when all are figures. Ask before the run starts.
[[nodiscard]] std::optional<std::string> complain_about(const std::vector<FigureLimits>& expectations);

/// Judges in the order given. A figure that the mission did not produce, or that is not finite, is not ok.
[[nodiscard]] std::vector<JudgedFigure> judge(const std::vector<FigureLimits>& expectations,
                                              const Figures& figures);

/// Keys in a fixed order; numbers rounded to six decimals; not finite becomes null; ends in a line feed.
[[nodiscard]] std::string to_json(const Summary& summary);

/// Wall time of a run, split by who used it. The one file of a run that differs between equal runs.
struct Timing {
  double sim_s{0.0};
  double wall_s{0.0};
  double physics_s{0.0};
  double devices_s{0.0};
  double controller_s{0.0};
  double log_s{0.0};
  double render_s{0.0};
};
/// timing.json, with rtf = sim_s / wall_s (simulated seconds per second of wall time; pictures not counted).
[[nodiscard]] std::string to_json(const Timing& timing);

}  // namespace sensotwin::twin
