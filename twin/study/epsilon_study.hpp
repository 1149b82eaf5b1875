// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/mapping/explorer_kind.hpp"
#include "twin/study/grid_drive.hpp"
#include "twin/study/obstacle_room.hpp"

namespace sensotwin::twin {

/// The 96 combinations of SensoBot, section V: Bp 5, 10 .. 30 per cent, Bd 1, 2 .. 16 chunks; Bp outermost.
[[nodiscard]] std::vector<ObstacleCell> paper_cells();

struct EpsilonStudyOptions {
  std::vector<robot::ExplorerKind> explorers{robot::ExplorerKind::kIdfm};
  int maps_per_cell{1000};
  std::uint64_t seed{1};
  int jobs{1};  ///< threads; the result does not depend on their number
  Knowledge knowledge{Knowledge::kAdjacent};
  /// What sweep minimises: visits, as epsilon counts them, not time.
  robot::MoveCost cost{.tile_s = 1.0, .quarter_turn_s = 0.0};
  robot::MoveCost pace{};  ///< what `time_per_tag_s` is made of
  std::vector<ObstacleCell> cells = paper_cells();
};

/// epsilon over the maps of one cell, in per cent.
struct EpsilonFigures {
  double mean_percent{0.0};
  double worst_percent{0.0};  ///< of a single map
};

struct EpsilonCell {
  ObstacleCell obstacles;
  EpsilonFigures paper{};     ///< S_T as Algorithm 1 counts: each first visit and each backtrack is one
  EpsilonFigures physical{};  ///< every tag driven over counted
  double turns_per_tag{0.0};
  double time_per_tag_s{0.0};
  int incomplete_maps{0};  ///< where the explorer gave up before the last reachable tag
};

/// epsilon_percent = per_blocked_percent * Bp + per_chunk * Bd + constant, least squares over the cells.
struct PlaneFit {
  double per_blocked_percent{0.0};
  double per_chunk{0.0};
  double constant{0.0};
  double r_squared{0.0};
};

struct ExplorerEpsilon {
  robot::ExplorerKind explorer{};
  std::vector<EpsilonCell> cells{};  ///< in the order of the options' cells
  PlaneFit paper_fit{};
  PlaneFit physical_fit{};

  [[nodiscard]] double mean_physical_percent() const;
  [[nodiscard]] double mean_paper_percent() const;
  [[nodiscard]] const EpsilonCell& worst_physical_cell() const;
  [[nodiscard]] const EpsilonCell& worst_paper_cell() const;
};

struct EpsilonStudy {
  EpsilonStudyOptions options;
  std::vector<ExplorerEpsilon> explorers;  ///< in the order of the options
};

/// Drives each explorer through `maps_per_cell` rooms of each cell; all explorers get the same rooms.
/// \param progress  called from the working threads, one call at a time, with the rooms done and their
///   number; the study ends early once it returns false
/// \returns nothing when it ended before its last room
[[nodiscard]] std::optional<EpsilonStudy> run_epsilon_study(
    const EpsilonStudyOptions& options, const std::function<bool(int, int)>& progress = {});

/// Least squares for z = a x + b y + c. \pre at least three points that are not on one line
[[nodiscard]] PlaneFit fit_plane(const std::vector<std::array<double, 3>>& points);

/// One line per explorer and cell, with a heading line.
[[nodiscard]] std::string to_csv(const EpsilonStudy& study);
[[nodiscard]] std::string to_json(const EpsilonStudy& study);
/// For people: the planes beside the paper's equation (2), means, largest cells, worst maps.
[[nodiscard]] std::string to_table(const EpsilonStudy& study);

}  // namespace sensotwin::twin
