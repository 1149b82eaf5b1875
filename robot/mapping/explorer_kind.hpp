// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "robot/mapping/explorer.hpp"
#include "robot/mapping/move_cost.hpp"

namespace sensotwin::robot {

enum class ExplorerKind : std::uint8_t {
  kBfm,               ///< BFM, next unvisited neighbour directly
  kBfmOutAndBack,     ///< BFM, back to the tag after each unvisited neighbour
  kBfmAllNeighbours,  ///< BFM, back to the tag after each of its four neighbours, visited or not
  kDfm,               ///< DFM
  kIdfm,              ///< IDFM, Algorithm 1
  kSpiral,            ///< right-hand spiral, then the nearest grey tag
  kSweep              ///< our own: plans the whole rest in advance; the default
};

inline constexpr std::array<ExplorerKind, 7> kExplorerKinds{
    ExplorerKind::kBfm,  ExplorerKind::kBfmOutAndBack, ExplorerKind::kBfmAllNeighbours,
    ExplorerKind::kDfm,  ExplorerKind::kIdfm,          ExplorerKind::kSpiral,
    ExplorerKind::kSweep};

inline constexpr ExplorerKind kDefaultExplorer = ExplorerKind::kSweep;

/// As scenes and the command line spell it: "bfm", "bfm_out_and_back", "bfm_all_neighbours", "dfm", "idfm",
/// "spiral", "sweep".
[[nodiscard]] std::string_view name_of(ExplorerKind kind);
/// \returns nothing for a name that is none
[[nodiscard]] std::optional<ExplorerKind> explorer_kind_from(std::string_view name);

/// \param cost  what `kSweep` minimises; the others do not look at it
[[nodiscard]] std::unique_ptr<Explorer> make_explorer(ExplorerKind kind, const MoveCost& cost = {});

}  // namespace sensotwin::robot
