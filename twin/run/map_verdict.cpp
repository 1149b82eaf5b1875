// SPDX-License-Identifier: MIT
#include "twin/run/map_verdict.hpp"

#include <map>
#include <variant>

#include "robot/wire/tag_record.hpp"

namespace sensotwin::twin {
namespace {

using Coordinates = std::pair<int, int>;

/// What this run wrote into the chip, if anything.
std::optional<robot::Tile> written_in(const world::TagMemory& memory, std::uint32_t map_id) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t block = 0; block < robot::kCarpetRecordBytes / 4; ++block) {
    bytes.insert(bytes.end(), memory.blocks[block].begin(), memory.blocks[block].end());
  }
  const auto record = robot::decode_tag_record(bytes);
  const auto* carpet = record ? std::get_if<robot::CarpetRecord>(&*record) : nullptr;
  if (carpet == nullptr || carpet->map_id != map_id) {
    return std::nullopt;
  }
  return robot::Tile{carpet->column, carpet->row};
}

}  // namespace

Coordinates MapPlacement::tile_in_truth(robot::Tile tile) const {
  int x = tile.column;
  int y = tile.row;
  for (int i = 0; i < (quarter_turns & 3); ++i) {
    const int turned_x = -y;
    y = x;
    x = turned_x;
  }
  return {origin.first + x, origin.second + y};
}

MapVerdict judge_map(std::span<const world::Tag> tags, std::uint32_t map_id,
                     const std::optional<MapPlacement>& placement, const std::set<Coordinates>& promised) {
  std::map<Coordinates, int> claims;
  for (const world::Tag& tag : tags) {
    if (const auto tile = written_in(tag.memory, map_id)) {
      ++claims[{tile->column, tile->row}];
    }
  }
  MapVerdict verdict;
  for (const world::Tag& tag : tags) {
    if (tag.place != world::TagPlace::kCarpet) {
      continue;
    }
    JudgedTile judged{tag.column, tag.row, TileOutcome::kBeyond};
    if (const auto tile = written_in(tag.memory, map_id)) {
      const bool right = placement && placement->tile_in_truth(*tile) == Coordinates{tag.column, tag.row};
      const bool once = claims[{tile->column, tile->row}] == 1;
      judged.outcome = right && once ? TileOutcome::kMapped : TileOutcome::kWrong;
    } else if (promised.contains({tag.column, tag.row})) {
      judged.outcome = TileOutcome::kMissed;
    }
    verdict.mapped += judged.outcome == TileOutcome::kMapped ? 1 : 0;
    verdict.wrong += judged.outcome == TileOutcome::kWrong ? 1 : 0;
    verdict.missed += judged.outcome == TileOutcome::kMissed ? 1 : 0;
    verdict.tiles.push_back(judged);
  }
  return verdict;
}

}  // namespace sensotwin::twin
