// SPDX-License-Identifier: MIT
#include "robot/mapping/map_pieces.hpp"

#include <gtest/gtest.h>

#include "carpet.hpp"
#include "robot/mapping/dfm.hpp"

namespace sensotwin::robot {
namespace {

/// Where session two begins, and how its compass stands to session one's.
struct Loss {
  Tile lands_on{};
  int compass_quarter_turns{0};
};

/// A second session on the same carpet: its own origin, its own north, the same tags.
class SecondSession {
 public:
  SecondSession(const Carpet& carpet, const Loss& loss)
      : carpet_(carpet),
        to_carpet_(TileTransform::matching(loss.compass_quarter_turns, {0, 0}, loss.lands_on)) {
    arrive();
  }
  void straight(Tile target) {
    for (const Direction side : kDirections) {
      if (neighbour(at_, side) != target || !carpet_.open(to_carpet_(at_), to_carpet_(side))) continue;
      at_ = target;
      heading_ = side;
      arrive();
      return;
    }
  }
  [[nodiscard]] const TileMap& map() const { return map_; }
  [[nodiscard]] Tile at() const { return at_; }
  [[nodiscard]] Direction heading() const { return heading_; }
  [[nodiscard]] const TileTransform& truth() const { return to_carpet_; }

 private:
  void arrive() {
    EXPECT_TRUE(map_.mark_visited(at_, uid_of(to_carpet_(at_))));
    for (const Direction side : kDirections) {
      const bool open = carpet_.open(to_carpet_(at_), to_carpet_(side));
      map_.mark_passage(at_, side, open ? Passage::kOpen : Passage::kBlocked);
    }
  }
  const Carpet& carpet_;
  TileTransform to_carpet_;
  TileMap map_;
  Tile at_{0, 0};
  Direction heading_{Direction::kEast};
};

TEST(TileTransform, InverseTakesBack) {
  for (int turns = 0; turns < 4; ++turns) {
    const auto there = TileTransform::matching(turns, {3, -2}, {7, 11});
    EXPECT_EQ(there(Tile{3, -2}), (Tile{7, 11}));
    EXPECT_EQ(there.inverse()(there(Tile{-5, 4})), (Tile{-5, 4}));
    EXPECT_EQ(there(neighbour({3, -2}, Direction::kNorth)), neighbour({7, 11}, there(Direction::kNorth)));
  }
}

TEST(MapPieces, MergeAll3000LossesRightWithTheCompass90DegreesOffInHalfOfThem) {
  RandomStream random{RandomStream{4000}.fork("losses")};
  int most_probes = 0;
  for (int i = 0; i < 3000; ++i) {
    const Carpet carpet = Carpet::random(9, 0.15, 0.0, random);
    const auto tags = carpet.reachable();
    if (tags.size() < 12) continue;
    Walk first{.carpet = carpet};
    Dfm explorer{Backtracking::kToOpenPathDirect};
    first.run(explorer, 4 + static_cast<int>(random.below(static_cast<std::uint32_t>(tags.size()))));
    Loss loss{.lands_on = *std::next(tags.begin(), random.below(static_cast<std::uint32_t>(tags.size())))};
    if (i % 2 == 1) loss.compass_quarter_turns = 1 + static_cast<int>(random.below(3));

    SecondSession second{carpet, loss};
    MapPieces pieces{first.map};
    Dfm explorer_2{Backtracking::kToOpenPathDirect};
    int probes = 0;
    while (pieces.update(second.map()) != MapPieces::State::kCommitted) {
      ASSERT_NE(pieces.state(), MapPieces::State::kContradiction) << "loss " << i;
      if (const auto side = pieces.probe(second.map(), second.at())) {
        ++probes;
        second.straight(neighbour(second.at(), *side));
        continue;
      }
      const auto move = explorer_2.next(second.map(), second.at(), second.heading());
      ASSERT_TRUE(move.has_value()) << "loss " << i << ": all seen and still two ways to lay the pieces";
      second.straight(move->target);
    }
    most_probes = std::max(most_probes, probes);
    ASSERT_EQ(pieces.candidates().front(), second.truth()) << "loss " << i;
    const TileMap whole = pieces.merged(second.map());
    for (const auto& [tile, tag] : whole.tiles()) ASSERT_EQ(tag, uid_of(tile));
  }
  EXPECT_LE(most_probes, 3);
}

TEST(MapPieces, NeedOneCommonTagOnlyWhenTheCompassIsTrusted) {
  TileMap old_piece;
  ASSERT_TRUE(old_piece.mark_visited({0, 0}, 1));
  ASSERT_TRUE(old_piece.mark_visited({1, 0}, 2));
  TileMap new_piece;
  ASSERT_TRUE(new_piece.mark_visited({0, 0}, 2));
  MapPieces blind{old_piece};
  EXPECT_EQ(blind.update(new_piece), MapPieces::State::kAmbiguous);
  EXPECT_EQ(blind.candidates().size(), 4u);
  MapPieces trusting{old_piece, true};
  ASSERT_EQ(trusting.update(new_piece), MapPieces::State::kCommitted);
  EXPECT_EQ(trusting.merged(new_piece).visited_count(), 2u);
  EXPECT_EQ(trusting.candidates().front()(Tile{0, 0}), (Tile{1, 0}));
}

TEST(MapPieces, UndoAMergeThatALaterTagContradicts) {
  TileMap old_piece;
  for (int column = 0; column < 4; ++column) {
    ASSERT_TRUE(old_piece.mark_visited({column, 0}, static_cast<TagUid>(column + 1)));
  }
  TileMap new_piece;
  ASSERT_TRUE(new_piece.mark_visited({0, 0}, 1));
  ASSERT_TRUE(new_piece.mark_visited({0, 1}, 2));
  MapPieces pieces{old_piece};
  ASSERT_EQ(pieces.update(new_piece), MapPieces::State::kCommitted);
  // The compass jumped within the new session: tag 3 should lie in the same line.
  ASSERT_TRUE(new_piece.mark_visited({1, 1}, 3));
  EXPECT_EQ(pieces.update(new_piece), MapPieces::State::kContradiction);
}

TEST(MapPieces, RejectAVisitedTileBehindABlockedPassage) {
  TileMap old_piece;
  ASSERT_TRUE(old_piece.mark_visited({0, 0}, 1));
  old_piece.mark_passage({0, 0}, Direction::kEast, Passage::kBlocked);
  TileMap new_piece;
  ASSERT_TRUE(new_piece.mark_visited({0, 0}, 1));
  new_piece.mark_passage({0, 0}, Direction::kNorth, Passage::kOpen);
  MapPieces pieces{old_piece};
  pieces.update(new_piece);
  for (const TileTransform& t : pieces.candidates()) EXPECT_NE(t(Direction::kNorth), Direction::kEast);
  EXPECT_EQ(pieces.candidates().size(), 3u);
}

}  // namespace
}  // namespace sensotwin::robot
