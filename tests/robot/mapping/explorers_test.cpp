// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "carpet.hpp"
#include "robot/mapping/explorer_kind.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Decisions that no explorer needs on 10 x 10 tags: BFM's slowest reading takes some 12 a tag.
constexpr int kManyDecisions = 10000;

Walk walk(const Carpet& carpet, ExplorerKind kind, bool knows_neighbours = true) {
  Walk result{.carpet = carpet, .knows_neighbours = knows_neighbours};
  const auto explorer = make_explorer(kind);
  EXPECT_TRUE(result.run(*explorer, kManyDecisions)) << name_of(kind);
  return result;
}

bool visited_all(const Walk& walk) {
  const auto reachable = walk.carpet.reachable();
  return std::all_of(reachable.begin(), reachable.end(), [&](Tile t) { return walk.map.visited(t); });
}

TEST(Explorers, VisitEveryReachableTagOf500RandomCarpetsWithThinWalls) {
  RandomStream random{RandomStream{1}.fork("explorers_test")};
  for (int i = 0; i < 500; ++i) {
    const Carpet carpet = Carpet::random(8, 0.2, i % 2 == 0 ? 0.0 : 0.15, random);
    for (const ExplorerKind kind : kExplorerKinds) {
      const Walk result = walk(carpet, kind, i % 3 != 0);
      ASSERT_TRUE(visited_all(result)) << name_of(kind) << " on carpet " << i;
      ASSERT_FALSE(result.illegal);
      ASSERT_EQ(result.claimed_twice, 0);
      if (kind != ExplorerKind::kSweep) {
        ASSERT_THAT(result.detours, IsEmpty());
      }
    }
  }
}

TEST(Explorers, DecideTheSameTwice) {
  RandomStream random{RandomStream{2}.fork("explorers_test")};
  const Carpet carpet = Carpet::random(12, 0.2, 0.05, random);
  for (const ExplorerKind kind : kExplorerKinds)
    EXPECT_EQ(walk(carpet, kind).drive, walk(carpet, kind).drive);
}

TEST(Explorers, AreDoneAtOnceWhenShutIn) {
  const Carpet carpet{{"###", "#S#", "###"}};
  for (const ExplorerKind kind : kExplorerKinds) EXPECT_EQ(walk(carpet, kind).moves, 0);
}

TEST(Explorers, CarryOnWithAMapThatAnotherRunBegan) {
  const Carpet carpet{{".....", ".###.", "..S.."}};
  for (const ExplorerKind kind : kExplorerKinds) {
    Walk result{.carpet = carpet};
    const auto first = make_explorer(kind);
    result.run(*first, 3);
    const auto second = make_explorer(kind);
    EXPECT_TRUE(result.run(*second, kManyDecisions));
    EXPECT_TRUE(visited_all(result)) << name_of(kind);
  }
}

TEST(Dfm, RetracesEveryMove) {
  RandomStream random{RandomStream{3}.fork("explorers_test")};
  for (int i = 0; i < 50; ++i) {
    const Carpet carpet = Carpet::random(9, 0.15, 0.05, random);
    const auto tags = static_cast<int>(carpet.reachable().size());
    EXPECT_EQ(walk(carpet, ExplorerKind::kDfm).moves, 2 * (tags - 1));
    EXPECT_LE(walk(carpet, ExplorerKind::kIdfm).moves, 2 * (tags - 1));
  }
}

TEST(Idfm, GoesStraightThenLeftAndBacktracksOnlyToOpenPaths) {
  // East along the south row, left at its end, and so on inwards; the dead end in the middle is the last tag.
  const Carpet spiral{{"...", "...", "S.."}};
  EXPECT_THAT(walk(spiral, ExplorerKind::kIdfm).drive,
              ElementsAre(Tile{0, 0}, Tile{1, 0}, Tile{2, 0}, Tile{2, 1}, Tile{2, 2}, Tile{1, 2}, Tile{0, 2},
                          Tile{0, 1}, Tile{1, 1}));
  // Straight past the turning, then back to it from the dead end: the two tags between count for nothing in
  // S_T.
  const Carpet turning{{"#.##", "S..."}};
  Walk result{.carpet = turning};
  const auto idfm = make_explorer(ExplorerKind::kIdfm);
  ASSERT_TRUE(result.run(*idfm, 100));
  EXPECT_THAT(result.drive, ElementsAre(Tile{0, 0}, Tile{1, 0}, Tile{2, 0}, Tile{3, 0}, Tile{2, 0},
                                        Tile{1, 0}, Tile{1, 1}));
  EXPECT_EQ(idfm->paper_visits(), 6) << "five first visits and one backtrack";
}

TEST(Bfm, VisitsByRingsAndReturnsAsItsReadingSays) {
  const Carpet cross{{"#.#", ".S.", "#.#"}};
  EXPECT_EQ(walk(cross, ExplorerKind::kBfm).moves, 7) << "no way back from the last neighbour";
  EXPECT_EQ(walk(cross, ExplorerKind::kBfmOutAndBack).moves, 8);
  EXPECT_EQ(walk(cross, ExplorerKind::kBfmAllNeighbours).moves, 8 + 3 + 3 * 4)
      << "then each end from the one before, to the middle and back";
}

TEST(Bfm, SlowestReadingIsNeverFaster) {
  RandomStream random{RandomStream{4}.fork("explorers_test")};
  for (int i = 0; i < 20; ++i) {
    const Carpet carpet = Carpet::random(9, 0.1, 0.0, random);
    const int lazy = walk(carpet, ExplorerKind::kBfm).moves;
    const int out_and_back = walk(carpet, ExplorerKind::kBfmOutAndBack).moves;
    EXPECT_LE(lazy, out_and_back);
    EXPECT_LE(out_and_back, walk(carpet, ExplorerKind::kBfmAllNeighbours).moves);
  }
}

TEST(Sweep, NeedsNoMoveTooManyInAnEmptyRoom) {
  const Carpet room{{"......", "......", "......", "......", "S....."}};
  EXPECT_EQ(walk(room, ExplorerKind::kSweep).moves, 29);
}

}  // namespace
}  // namespace sensotwin::robot
