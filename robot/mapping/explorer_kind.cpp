// SPDX-License-Identifier: MIT
#include "robot/mapping/explorer_kind.hpp"

#include "robot/mapping/bfm.hpp"
#include "robot/mapping/dfm.hpp"
#include "robot/mapping/spiral.hpp"
#include "robot/mapping/sweep.hpp"

namespace sensotwin::robot {

std::string_view name_of(ExplorerKind kind) {
  switch (kind) {
    case ExplorerKind::kBfm:
      return "bfm";
    case ExplorerKind::kBfmOutAndBack:
      return "bfm_out_and_back";
    case ExplorerKind::kBfmAllNeighbours:
      return "bfm_all_neighbours";
    case ExplorerKind::kDfm:
      return "dfm";
    case ExplorerKind::kIdfm:
      return "idfm";
    case ExplorerKind::kSpiral:
      return "spiral";
    case ExplorerKind::kSweep:
      break;
  }
  return "sweep";
}

std::optional<ExplorerKind> explorer_kind_from(std::string_view name) {
  for (const ExplorerKind kind : kExplorerKinds) {
    if (name_of(kind) == name) return kind;
  }
  return std::nullopt;
}

std::unique_ptr<Explorer> make_explorer(ExplorerKind kind, const MoveCost& cost) {
  switch (kind) {
    case ExplorerKind::kBfm:
      return std::make_unique<Bfm>(BfmReading::kLazy);
    case ExplorerKind::kBfmOutAndBack:
      return std::make_unique<Bfm>(BfmReading::kOutAndBack);
    case ExplorerKind::kBfmAllNeighbours:
      return std::make_unique<Bfm>(BfmReading::kAllNeighbours);
    case ExplorerKind::kDfm:
      return std::make_unique<Dfm>(Backtracking::kRetraceAll);
    case ExplorerKind::kIdfm:
      return std::make_unique<Dfm>(Backtracking::kToOpenPathDirect);
    case ExplorerKind::kSpiral:
      return std::make_unique<Spiral>();
    case ExplorerKind::kSweep:
      break;
  }
  return std::make_unique<Sweep>(cost);
}

}  // namespace sensotwin::robot
