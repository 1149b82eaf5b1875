// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "robot/mapping/tile.hpp"
#include "twin/scene/scene.hpp"
#include "world/free_space.hpp"
#include "world/tag_field.hpp"

namespace sensotwin::twin {

/// How the robot's map frame lies on the carpet: its origin tile and its +x direction.
struct MapPlacement {
  std::pair<int, int> origin{0, 0};  ///< (column, row) of the truth
  int quarter_turns{0};              ///< M's +x against the carpet's columns, counter-clockwise

  [[nodiscard]] std::pair<int, int> tile_in_truth(robot::Tile tile) const;
};

/// How one tile of the truth ended.
enum class TileOutcome : std::uint8_t {
  kMapped,  ///< its tag holds its right coordinates
  kWrong,   ///< its tag holds others, or its coordinates stand in another tag too
  kMissed,  ///< promised by the explorer, and blank
  kBeyond,  ///< out of the explorer's reach, and blank
};

struct JudgedTile {
  int column{0};
  int row{0};
  TileOutcome outcome{TileOutcome::kBeyond};
};

struct MapVerdict {
  std::vector<JudgedTile> tiles;  ///< in the carpet's order
  int mapped{0};
  int wrong{0};
  int missed{0};
};

/// Whether the carpet now holds its own map: reads every tag's memory, decodes what this run wrote, and
/// compares with where the tag lies. Truth against chips; what the robot believes does not enter. \param
/// promised  tiles that the explorer must map: all that can be reached, or by straight moves alone
[[nodiscard]] MapVerdict judge_map(std::span<const world::Tag> tags, std::uint32_t map_id,
                                   const std::optional<MapPlacement>& placement,
                                   const std::set<std::pair<int, int>>& promised);

}  // namespace sensotwin::twin
