// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <vector>

#include "rooms.hpp"

namespace sensotwin::world {
namespace {

using robot::deg_from_rad;
using robot::rad_from_deg;

TEST(Roomba, TurnsOnTheSpotAndStaysThereWithinACentimetreATurn) {
  // The default carpet is rough and its nap leads the wheels: 1 % each of the 0.74 m that each wheel rolls,
  // and most of that cancels in a whole turn (measured: 2 to 6 mm).
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    World world = make({}, {}, seed);
    run(world, wheels(-0.1, 0.1), 7.4);
    EXPECT_LT(world.X_WR().p_m.norm(), 0.010) << "seed " << seed;
  }
}

TEST(Roomba, TurnsOnTheSpotWithinATenthOfAMillimetreOnAnEvenFloor) {
  World world = make(even_floor(), exact_robot());
  run(world, wheels(-0.1, 0.1), 7.4);
  EXPECT_LT(world.X_WR().p_m.norm(), 1e-4);
}

TEST(Roomba, StandsStillForTenMinutes) {
  World world = make({}, robot_at({{1.0, 2.0}, 0.3}));
  run(world, {}, 600.0);
  EXPECT_EQ(world.X_WR().p_m.x(), 1.0);
  EXPECT_EQ(world.X_WR().p_m.y(), 2.0);
  EXPECT_NEAR(world.X_WR().yaw_rad, 0.3, 1e-7);  // one rounding to single precision at the start
}

TEST(Roomba, ReachesItsSpeedNoFasterThanItsWheelsAccelerate) {
  World world = make(even_floor(), exact_robot());
  run(world, wheels(0.3, 0.3), 0.105);
  const double early_j = world.energy_j();
  EXPECT_LT(early_j, 0.5 * 3.5 * 0.16 * 0.16);  // 1.5 m/s2 for 0.105 s is 0.1575 m/s
  run(world, wheels(0.3, 0.3), 0.5);
  EXPECT_NEAR(world.energy_j(), 0.5 * 3.5 * 0.3 * 0.3, 0.002);
}

TEST(Roomba, LosesSpeedToTheCarpetButNeverGainsAnyWithItsMotorsOff) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    World world = make({}, {}, seed);
    run(world, wheels(0.4, 0.2), 2.0);
    double before_j = world.energy_j();
    for (int i = 0; i < 100; ++i) {
      world.tick({});
      const double now_j = world.energy_j();
      ASSERT_LE(now_j, before_j + 1e-9) << "seed " << seed << " tick " << i;
      before_j = now_j;
    }
    EXPECT_EQ(before_j, 0.0);
  }
}

TEST(Roomba, NeverHoldsMoreEnergyThanItsWheelsBroughtIn) {
  WorldDescription description;
  description.walls.push_back(room(1.6, 1.4));
  description.furniture.push_back({.name = "chair",
                                   .shape = FurnitureShape::kLegs,
                                   .X_WF = {{1.0, 0.8}, 0.4},
                                   .points_m = {{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}},
                                   .pushable = true,
                                   .mass_kg = 2.0,
                                   .friction = 0.2,
                                   .tag = {}});
  robot::RandomStream drive{99};
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    World world = make(description, robot_at({{0.3, 0.3}, 0.5}), seed);
    double low_j = 0.0;  // energy that is not there although the wheels brought it in: lost for good
    for (int turn = 0; turn < 60; ++turn) {
      const RoombaOutputs out = wheels(drive.uniform(-0.5, 0.5), drive.uniform(-0.5, 0.5));
      for (int i = 0; i < 30; ++i) {
        world.tick(out);
        const double lost_j = world.work_j() - world.energy_j();
        // What is lost only grows. 1e-5 J: single precision on energies near 0.5 J.
        ASSERT_GE(lost_j, low_j - 1e-5) << "seed " << seed << " turn " << turn;
        low_j = lost_j;
      }
    }
  }
}

/// A drive with everything in it: straight, curve, turn on the spot, standing, backing.
Pose2 reference_drive(int steps_per_tick) {
  World world = make(even_floor(), exact_robot(), 1, {.steps_per_tick = steps_per_tick});
  run(world, wheels(0.3, 0.3), 3.0);
  run(world, wheels(0.2, 0.3), 3.0);
  run(world, wheels(-0.1, 0.1), 2.0);
  run(world, {}, 0.6);
  run(world, wheels(-0.15, -0.2), 2.0);
  run(world, {}, 0.6);
  return world.X_WR();
}

// The default is the largest step that passes: halved, three steps a tick move the end by 0.34 mm, two by
// 0.51 mm.
TEST(PhysicsStep, HalvedMovesTheEndOfTheReferenceDriveByLessThanHalfAMillimetreAndATwentiethOfADegree) {
  const int chosen = PhysicsDescription{}.steps_per_tick;
  const Pose2 whole = reference_drive(chosen);
  const Pose2 halved = reference_drive(2 * chosen);
  const double moved_m = (whole.p_m - halved.p_m).norm();
  const double turned_deg = std::abs(deg_from_rad(robot::wrap_angle(whole.yaw_rad - halved.yaw_rad)));
  EXPECT_LT(moved_m, 0.0005);
  EXPECT_LT(turned_deg, 0.05);
}

TEST(PhysicsStep, IsStableEvenWhenOneStepIsTheWholeTick) {
  const Pose2 fine = reference_drive(12);
  const Pose2 coarse = reference_drive(1);
  EXPECT_LT((fine.p_m - coarse.p_m).norm(), 0.005);
}

TEST(Nap, LeadsARobotThatDrivesAcrossItTowardsWhereThePileLies) {
  for (const double drive_yaw_deg : {0.0, 180.0}) {
    WorldDescription description = even_floor();
    description.floor.nap_drift = 0.01;
    description.floor.nap_yaw_rad = rad_from_deg(90.0);
    World world = make(description, exact_robot({{0.0, 0.0}, rad_from_deg(drive_yaw_deg)}));
    run(world, wheels(0.25, 0.25), 4.0);
    EXPECT_NEAR(world.X_WR().p_m.y() / std::abs(world.X_WR().p_m.x()), 0.01, 0.0005);
  }
}

TEST(Nap, DoesNothingToARobotThatDrivesAlongIt) {
  WorldDescription description = even_floor();
  description.floor.nap_drift = 0.01;
  World world = make(description, exact_robot());
  run(world, wheels(0.25, 0.25), 4.0);
  EXPECT_NEAR(world.X_WR().p_m.y(), 0.0, 1e-6);
}

TEST(World, RepeatsItselfToTheBit) {
  const auto hash_after_drive = [](const WorldDescription& description) {
    World world = make(description, robot_at({{0.5, 0.5}, 0.2}), 7);
    std::vector<double> headings;
    for (int i = 0; i < 20; ++i) {
      run(world, wheels(0.3, 0.25 + 0.004 * i), 0.3);
      headings.push_back(world.compass_heading_rad());
    }
    return std::pair{world.state_hash(), headings};
  };
  WorldDescription description;
  description.walls.push_back(room(6.0, 5.0));
  const auto once = hash_after_drive(description);
  EXPECT_EQ(once, hash_after_drive(description));

  // A cupboard in the far corner changes nobody's noise.
  description.furniture.push_back({.name = "cupboard",
                                   .shape = FurnitureShape::kBox,
                                   .X_WF = {{5.5, 4.5}, 0.0},
                                   .size_m = {0.6, 0.6},
                                   .points_m = {},
                                   .tag = ObjectTag{}});
  EXPECT_EQ(once, hash_after_drive(description));
}

}  // namespace
}  // namespace sensotwin::world
