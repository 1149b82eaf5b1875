// SPDX-License-Identifier: MIT
#include "twin/study/epsilon_study.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>

#include "twin/study/parallel.hpp"

namespace sensotwin::twin {
namespace {

GridRoom study_room(const ObstacleCell& cell, std::uint64_t seed, int map) {
  const std::string name = "epsilon/bp" + std::to_string(cell.blocked_percent) + "/bd" +
                           std::to_string(cell.chunks) + "/map" + std::to_string(map);
  return obstacle_room(cell, robot::RandomStream{seed}.fork(name));
}

void add(EpsilonFigures& figures, double epsilon, int maps) {
  figures.mean_percent += 100.0 * epsilon / maps;
  figures.worst_percent = std::max(figures.worst_percent, 100.0 * epsilon);
}

EpsilonCell reduce(const ObstacleCell& obstacles, const DriveTally* tallies, std::size_t stride,
                   const EpsilonStudyOptions& options) {
  EpsilonCell cell{.obstacles = obstacles};
  const int maps = options.maps_per_cell;
  for (int map = 0; map < maps; ++map) {
    const DriveTally& tally = tallies[static_cast<std::size_t>(map) * stride];
    add(cell.paper, tally.paper_epsilon(), maps);
    add(cell.physical, tally.physical_epsilon(), maps);
    const double turns = static_cast<double>(tally.quarter_turns) / tally.tags;
    cell.turns_per_tag += turns / maps;
    cell.time_per_tag_s +=
        (options.pace.tile_s * tally.moves / tally.tags + options.pace.quarter_turn_s * turns) / maps;
    if (tally.tags_visited < tally.tags) ++cell.incomplete_maps;
  }
  return cell;
}

PlaneFit fit_cells(const std::vector<EpsilonCell>& cells, EpsilonFigures EpsilonCell::*figures) {
  std::vector<std::array<double, 3>> points;
  points.reserve(cells.size());
  for (const EpsilonCell& cell : cells) {
    points.push_back({static_cast<double>(cell.obstacles.blocked_percent),
                      static_cast<double>(cell.obstacles.chunks), (cell.*figures).mean_percent});
  }
  return points.size() < 3 ? PlaneFit{} : fit_plane(points);
}

double mean_over(const std::vector<EpsilonCell>& cells, EpsilonFigures EpsilonCell::*figures) {
  double sum = 0.0;
  for (const EpsilonCell& cell : cells) sum += (cell.*figures).mean_percent;
  return sum / static_cast<double>(cells.size());
}

const EpsilonCell& worst_of(const std::vector<EpsilonCell>& cells, EpsilonFigures EpsilonCell::*figures) {
  return *std::max_element(cells.begin(), cells.end(), [figures](const EpsilonCell& a, const EpsilonCell& b) {
    return (a.*figures).mean_percent < (b.*figures).mean_percent;
  });
}

}  // namespace

std::vector<ObstacleCell> paper_cells() {
  std::vector<ObstacleCell> cells;
  for (int percent = 5; percent <= 30; percent += 5) {
    for (int chunks = 1; chunks <= 16; ++chunks) cells.push_back({percent, chunks});
  }
  return cells;
}

double ExplorerEpsilon::mean_physical_percent() const {
  return mean_over(cells, &EpsilonCell::physical);
}
double ExplorerEpsilon::mean_paper_percent() const {
  return mean_over(cells, &EpsilonCell::paper);
}
const EpsilonCell& ExplorerEpsilon::worst_physical_cell() const {
  return worst_of(cells, &EpsilonCell::physical);
}
const EpsilonCell& ExplorerEpsilon::worst_paper_cell() const {
  return worst_of(cells, &EpsilonCell::paper);
}

std::optional<EpsilonStudy> run_epsilon_study(const EpsilonStudyOptions& options,
                                              const std::function<bool(int, int)>& progress) {
  assert(options.maps_per_cell > 0 && !options.cells.empty());
  const std::size_t kinds = options.explorers.size();
  const std::size_t maps = static_cast<std::size_t>(options.maps_per_cell);
  std::vector<DriveTally> tallies(options.cells.size() * maps * kinds);
  const auto drive_room = [&](int job) {
    const std::size_t room_index = static_cast<std::size_t>(job);
    const ObstacleCell& cell = options.cells[room_index / maps];
    const GridRoom room = study_room(cell, options.seed, static_cast<int>(room_index % maps));
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const auto explorer = robot::make_explorer(options.explorers[kind], options.cost);
      tallies[room_index * kinds + kind] = drive(*explorer, room, {.knowledge = options.knowledge});
    }
  };
  if (!run_in_parallel(static_cast<int>(options.cells.size() * maps), options.jobs, drive_room, progress)) {
    return std::nullopt;
  }

  EpsilonStudy study{.options = options, .explorers = {}};
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    ExplorerEpsilon result{.explorer = options.explorers[kind]};
    for (std::size_t cell = 0; cell < options.cells.size(); ++cell) {
      result.cells.push_back(
          reduce(options.cells[cell], &tallies[cell * maps * kinds + kind], kinds, options));
    }
    result.paper_fit = fit_cells(result.cells, &EpsilonCell::paper);
    result.physical_fit = fit_cells(result.cells, &EpsilonCell::physical);
    study.explorers.push_back(std::move(result));
  }
  return study;
}

PlaneFit fit_plane(const std::vector<std::array<double, 3>>& points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd a(n, 3);
  Eigen::VectorXd z(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& p = points[static_cast<std::size_t>(i)];
    a.row(i) << p[0], p[1], 1.0;
    z(i) = p[2];
  }
  const Eigen::Vector3d x = a.colPivHouseholderQr().solve(z);
  const double spread = (z.array() - z.mean()).square().sum();
  const double rest = (z - a * x).squaredNorm();
  return {x(0), x(1), x(2), spread > 0.0 ? 1.0 - rest / spread : 1.0};
}

}  // namespace sensotwin::twin
