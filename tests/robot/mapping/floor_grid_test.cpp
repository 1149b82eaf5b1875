// SPDX-License-Identifier: MIT
#include "robot/mapping/floor_grid.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

/// Where the robot touched or saw something in these tests, in the middle of a cell.
const Vec2 kThere_m = FloorGrid::centre_m({40, -30});

void put_obstacle(FloorGrid& grid, const Vec2& p_M_m) {
  grid.add_hit(p_M_m);
  grid.add_hit(p_M_m);
}

TEST(FloorGrid, KnowsNothingAtFirst) {
  const FloorGrid grid;
  EXPECT_FALSE(grid.occupied({0, 0}));
  EXPECT_FALSE(grid.swept({0, 0}));
  EXPECT_FALSE(grid.centre_forbidden({0, 0}));
  EXPECT_FALSE(grid.blocks({-5.0, -5.0}, {5.0, 5.0}, 0.2));
}

TEST(FloorGrid, PutsCellsOnBothSidesOfZero) {
  EXPECT_EQ(FloorGrid::cell_at({0.01, -0.01}), (FloorGrid::Cell{0, -1}));
  EXPECT_EQ(FloorGrid::cell_at(FloorGrid::centre_m({-65, 64})), (FloorGrid::Cell{-65, 64}));
}

TEST(FloorGrid, BelievesInAnObstacleAtTheSecondHit) {
  FloorGrid grid;
  grid.add_hit(kThere_m);
  EXPECT_FALSE(grid.occupied(FloorGrid::cell_at(kThere_m))) << "one stray reading moves nothing";
  EXPECT_EQ(grid.revision(), 0u);
  grid.add_hit(kThere_m);
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(kThere_m)));
  EXPECT_EQ(grid.revision(), 1u);
}

TEST(FloorGrid, DoesNotCallAnObstacleNewThatItHasSeenAHundredTimes) {
  FloorGrid grid;
  for (int i = 0; i < 100; ++i) {
    grid.add_hit(kThere_m);
  }
  EXPECT_EQ(grid.revision(), 1u);
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(kThere_m)));
  EXPECT_FALSE(grid.swept(FloorGrid::cell_at(kThere_m))) << "evidence must not run over into the flags";
  EXPECT_FALSE(grid.centre_forbidden(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, BelievesTheBodyMoreThanTheBeams) {
  FloorGrid grid;
  for (int i = 0; i < 100; ++i) {
    grid.add_hit(kThere_m);
  }
  grid.clear_disc(kThere_m + Vec2{0.05, 0.0}, 0.14);
  EXPECT_FALSE(grid.occupied(FloorGrid::cell_at(kThere_m)));
  EXPECT_TRUE(grid.swept(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, ClearsNothingBeyondTheBody) {
  FloorGrid grid;
  put_obstacle(grid, kThere_m);
  grid.clear_disc(kThere_m + Vec2{0.15, 0.0}, 0.14);
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(kThere_m)));
  EXPECT_FALSE(grid.swept(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, ForgetsWhatManyBeamsWentThrough) {
  FloorGrid grid;
  for (int i = 0; i < 100; ++i) {
    grid.add_hit(kThere_m);
  }
  const Vec2 aside{0.2, 0.0};
  grid.see_through(kThere_m - aside, kThere_m + aside);
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(kThere_m))) << "one beam past a leg says little";
  for (int i = 0; i < 20; ++i) {
    grid.see_through(kThere_m - aside, kThere_m + aside);
  }
  EXPECT_FALSE(grid.occupied(FloorGrid::cell_at(kThere_m)));
  EXPECT_FALSE(grid.swept(FloorGrid::cell_at(kThere_m))) << "seen through is not driven over";
}

TEST(FloorGrid, ForgetsSoonWhatWasSeenFromAPlaceKnownBadly) {
  FloorGrid sure;
  FloorGrid unsure;
  for (int i = 0; i < 20; ++i) {
    sure.add_hit(kThere_m);
    unsure.add_hit(kThere_m, FloorGrid::Seen::kFromDoubtfulPlace);
  }
  const FloorGrid::Cell there = FloorGrid::cell_at(kThere_m);
  EXPECT_TRUE(unsure.occupied(there));
  for (int i = 0; i < 2; ++i) {
    sure.see_through(kThere_m - Vec2{0.2, 0.0}, kThere_m + Vec2{0.2, 0.0});
    unsure.see_through(kThere_m - Vec2{0.2, 0.0}, kThere_m + Vec2{0.2, 0.0});
  }
  EXPECT_TRUE(sure.occupied(there));
  EXPECT_FALSE(unsure.occupied(there));
  sure.add_hit(kThere_m, FloorGrid::Seen::kFromDoubtfulPlace);
  EXPECT_TRUE(sure.occupied(there)) << "what was known for sure stays so";
}

TEST(FloorGrid, ForgetsNothingBehindTheEndOfABeam) {
  FloorGrid grid;
  put_obstacle(grid, kThere_m);
  for (int i = 0; i < 20; ++i) {
    grid.see_through(kThere_m - Vec2{0.2, 0.0}, kThere_m - Vec2{0.02, 0.0});
  }
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, ForbidsTheCentreWhereTheBumperWasPressed) {
  FloorGrid grid;
  grid.forbid_centre(kThere_m);
  grid.forbid_centre(kThere_m);
  EXPECT_TRUE(grid.centre_forbidden(FloorGrid::cell_at(kThere_m)));
  EXPECT_FALSE(grid.occupied(FloorGrid::cell_at(kThere_m)))
      << "something stands a body's radius away, not here";
  EXPECT_EQ(grid.revision(), 1u);
}

TEST(FloorGrid, ForgetsTouchesAndDoubtfulSightsNearAPlaceAndKeepsThoseFarOff) {
  FloorGrid grid;
  const Vec2 far_m = kThere_m + Vec2{0.7, 0.0};
  grid.forbid_centre(kThere_m);
  grid.forbid_centre(far_m);
  const Vec2 beside_m = kThere_m + Vec2{0.1, 0.0};
  const Vec2 sure_m = kThere_m + Vec2{0.2, 0.0};
  for (int i = 0; i < 4; ++i) {
    grid.add_hit(beside_m, FloorGrid::Seen::kFromDoubtfulPlace);
    grid.add_hit(sure_m);
  }
  const std::uint64_t before = grid.revision();
  grid.forget_doubtful(kThere_m, 0.6);
  EXPECT_FALSE(grid.centre_forbidden(FloorGrid::cell_at(kThere_m)));
  EXPECT_FALSE(grid.occupied(FloorGrid::cell_at(beside_m)));
  EXPECT_TRUE(grid.occupied(FloorGrid::cell_at(sure_m)));
  EXPECT_TRUE(grid.centre_forbidden(FloorGrid::cell_at(far_m)));
  EXPECT_GT(grid.revision(), before);
}

TEST(FloorGrid, RemembersItsTrailUnderWhateverComesLater) {
  FloorGrid grid;
  EXPECT_FALSE(grid.trodden(FloorGrid::cell_at(kThere_m)));
  grid.tread(kThere_m);
  put_obstacle(grid, kThere_m);
  grid.clear_disc(kThere_m, 0.14);
  EXPECT_TRUE(grid.trodden(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, KeepsForbiddenCentresUnderTheBodysEdgeButNotUnderItsMiddle) {
  FloorGrid grid;
  grid.forbid_centre(kThere_m);
  grid.clear_disc(kThere_m + Vec2{0.05, 0.0}, 0.14);
  EXPECT_TRUE(grid.centre_forbidden(FloorGrid::cell_at(kThere_m)))
      << "the body was there, its middle was not";
  grid.clear_disc(kThere_m, 0.14);
  EXPECT_FALSE(grid.centre_forbidden(FloorGrid::cell_at(kThere_m)));
}

TEST(FloorGrid, BlocksAStraightWayThatPassesTooClose) {
  FloorGrid grid;
  put_obstacle(grid, kThere_m);
  const Vec2 before = kThere_m - Vec2{0.5, 0.0};
  const Vec2 behind = kThere_m + Vec2{0.5, 0.0};
  const Vec2 aside{0.0, 0.16};
  EXPECT_TRUE(grid.blocks(before + aside, behind + aside, 0.165));
  EXPECT_FALSE(grid.blocks(before + aside, behind + aside, 0.155));
}

TEST(FloorGrid, MeasuresClearanceFromTheEndsOfAWayToo) {
  FloorGrid grid;
  put_obstacle(grid, kThere_m);
  const Vec2 before = kThere_m - Vec2{0.5, 0.0};
  EXPECT_FALSE(grid.blocks(before, kThere_m - Vec2{0.16, 0.0}, 0.155)) << "it ends before what stands there";
  EXPECT_TRUE(grid.blocks(before, kThere_m - Vec2{0.16, 0.0}, 0.165));
  EXPECT_TRUE(grid.blocks(kThere_m, kThere_m, 0.05)) << "a way of no length is a place";
}

TEST(FloorGrid, RemembersPlacesFarApartAndAcrossItsChunks) {
  FloorGrid grid;
  for (const int x : {-1000, -65, -64, -63, -1, 0, 63, 64, 1000}) {
    put_obstacle(grid, FloorGrid::centre_m({x, -x}));
  }
  int occupied = 0;
  for (int x = -1001; x <= 1001; ++x) {
    occupied += grid.occupied({x, -x}) ? 1 : 0;
  }
  EXPECT_EQ(occupied, 9);
}

}  // namespace
}  // namespace sensotwin::robot
