// SPDX-License-Identifier: MIT
#include "twin/run/map_verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "robot/wire/tag_record.hpp"
#include "twin/run/recovered_map.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::uint32_t kMapId = 0xCAFE0001;

/// A carpet tag at a tile of the truth that says to be `claims`.
world::Tag tag_at(int column, int row, std::optional<robot::Tile> claims, std::uint32_t map_id = kMapId) {
  world::Tag tag;
  tag.column = column;
  tag.row = row;
  if (claims) {
    const auto bytes = robot::encode(robot::CarpetRecord{.map_id = map_id,
                                                         .column = static_cast<std::int16_t>(claims->column),
                                                         .row = static_cast<std::int16_t>(claims->row)});
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      tag.memory.blocks[i / 4][i % 4] = bytes[i];
    }
  }
  return tag;
}

const std::set<std::pair<int, int>> kPromised{{5, 5}, {6, 5}};
constexpr MapPlacement kUnturned{.origin = {5, 5}, .quarter_turns = 0};

std::vector<TileOutcome> outcomes(const MapVerdict& verdict) {
  std::vector<TileOutcome> result;
  for (const JudgedTile& tile : verdict.tiles) {
    result.push_back(tile.outcome);
  }
  return result;
}

TEST(MapVerdict, CountsATagThatHoldsItsOwnCoordinatesAsMapped) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}), tag_at(6, 5, robot::Tile{1, 0})};
  const MapVerdict verdict = judge_map(tags, kMapId, kUnturned, kPromised);
  EXPECT_EQ(outcomes(verdict), (std::vector{TileOutcome::kMapped, TileOutcome::kMapped}));
  EXPECT_EQ(verdict.mapped, 2);
  EXPECT_EQ(verdict.wrong + verdict.missed, 0);
}

TEST(MapVerdict, CountsATagThatHoldsItsNeighboursCoordinatesAsWrong) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}), tag_at(6, 5, robot::Tile{2, 0})};
  EXPECT_EQ(outcomes(judge_map(tags, kMapId, kUnturned, kPromised)),
            (std::vector{TileOutcome::kMapped, TileOutcome::kWrong}));
}

TEST(MapVerdict, CountsCoordinatesThatStandInTwoTagsAsWrongInBoth) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}), tag_at(6, 5, robot::Tile{0, 0})};
  const MapVerdict verdict = judge_map(tags, kMapId, kUnturned, kPromised);
  EXPECT_EQ(verdict.wrong, 2);
  EXPECT_EQ(verdict.mapped, 0);
}

TEST(MapVerdict, TakesBlankTagsAsMissedWherePromisedAndAsBeyondElsewhere) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}), tag_at(6, 5, {}), tag_at(9, 9, {})};
  const MapVerdict verdict = judge_map(tags, kMapId, kUnturned, kPromised);
  EXPECT_EQ(outcomes(verdict),
            (std::vector{TileOutcome::kMapped, TileOutcome::kMissed, TileOutcome::kBeyond}));
  EXPECT_EQ(verdict.missed, 1);
}

TEST(MapVerdict, CreditsATileBeyondThePromiseThatWasMappedAllTheSame) {
  const std::vector<world::Tag> tags{tag_at(9, 9, robot::Tile{4, 4})};
  EXPECT_EQ(judge_map(tags, kMapId, kUnturned, kPromised).mapped, 1);
}

TEST(MapVerdict, TakesCoordinatesOfAnOlderMapAsBlank) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}),
                                     tag_at(6, 5, robot::Tile{0, 0}, kMapId + 1)};
  EXPECT_EQ(outcomes(judge_map(tags, kMapId, kUnturned, kPromised)),
            (std::vector{TileOutcome::kMapped, TileOutcome::kMissed}));
}

TEST(MapVerdict, TakesATornRecordAsBlank) {
  std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0})};
  tags[0].memory.blocks[2] = {};
  EXPECT_EQ(judge_map(tags, kMapId, kUnturned, kPromised).missed, 1);
}

TEST(MapVerdict, FollowsAMapThatIsTurnedAgainstTheCarpet) {
  // The robot's +x is the carpet's +row: its tile (2, 0) lies two rows further, (0, 1) a column to the left.
  const MapPlacement turned{.origin = {5, 5}, .quarter_turns = 1};
  const std::vector<world::Tag> tags{tag_at(5, 7, robot::Tile{2, 0}), tag_at(4, 5, robot::Tile{0, 1}),
                                     tag_at(6, 5, robot::Tile{0, 2})};
  EXPECT_EQ(outcomes(judge_map(tags, kMapId, turned, {})),
            (std::vector{TileOutcome::kMapped, TileOutcome::kMapped, TileOutcome::kWrong}));
}

TEST(MapVerdict, KnowsNoRightCoordinatesWhenTheOriginIsUnknown) {
  const std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0})};
  EXPECT_EQ(judge_map(tags, kMapId, std::nullopt, kPromised).wrong, 1);
}

TEST(MapVerdict, LooksAtCarpetTagsOnly) {
  std::vector<world::Tag> tags{tag_at(5, 5, robot::Tile{0, 0}), tag_at(0, 0, {})};
  tags[1].place = world::TagPlace::kLandmark;
  EXPECT_EQ(judge_map(tags, kMapId, kUnturned, kPromised).tiles.size(), 1u);
}

TEST(MapPlacement, IsUndoneByTileInMapInEveryQuarterTurn) {
  for (int turns = 0; turns < 4; ++turns) {
    const MapPlacement placement{.origin = {3, -2}, .quarter_turns = turns};
    for (const robot::Tile tile : {robot::Tile{0, 0}, robot::Tile{4, 1}, robot::Tile{-2, 7}}) {
      const auto [column, row] = placement.tile_in_truth(tile);
      EXPECT_EQ(tile_in_map(placement, column, row), tile) << turns;
    }
  }
}

}  // namespace
}  // namespace sensotwin::twin
