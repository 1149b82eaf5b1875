// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "rooms.hpp"
#include "world/body_sensors.hpp"

namespace sensotwin::world {
namespace {

using robot::rad_from_deg;

/// A wall across the robot's way, 0.3 m ahead of the origin along +x.
WorldDescription wall_ahead() {
  WorldDescription world = even_floor();
  world.walls.push_back({.points_m = {{0.3, -3.0}, {0.3, 3.0}}, .closed = false});
  return world;
}

Furniture block_ahead(double mass_kg) {
  return {.name = "block",
          .shape = FurnitureShape::kBox,
          .X_WF = {{0.5, 0.0}, 0.0},
          .size_m = {0.3, 0.3},
          .points_m = {},
          .pushable = true,
          .mass_kg = mass_kg,
          .tag = {}};
}

TEST(Stall, HoldsTheBodyAndNotTheEncoders) {
  World world = make(wall_ahead(), exact_robot());
  run(world, wheels(0.2, 0.2), 2.0);
  const Pose2 stalled = world.X_WR();
  const double angle_rad = world.roomba_inputs().wheel_angle_left_rad;
  run(world, wheels(0.2, 0.2), 4.995);
  EXPECT_NEAR(stalled.p_m.x(), 0.13, 0.005);  // touching, sunk in by one step or Box2D's slop at most
  EXPECT_NEAR(world.X_WR().p_m.x(), stalled.p_m.x(), 0.001);
  EXPECT_NEAR(world.roomba_inputs().wheel_angle_left_rad - angle_rad, 4.995 * 0.2 / 0.036, 0.001);
  EXPECT_LT(world.energy_j(), 1e-6);
}

TEST(Stall, DrawsMoreMotorCurrentThanDriving) {
  World world = make(wall_ahead(), exact_robot());
  run(world, wheels(0.1, 0.1), 0.9);
  const int driving_ma = world.roomba_inputs().motor_ma[0];
  run(world, wheels(0.1, 0.1), 2.0);
  EXPECT_GT(world.roomba_inputs().motor_ma[0], 4 * driving_ma);
}

TEST(Bumper, PressesTheSwitchOfTheSideItIsHitOn) {
  for (int deg = -180; deg < 180; ++deg) {
    const BumpSwitches pressed = switches_pressed(rad_from_deg(deg));
    EXPECT_EQ(pressed.left, deg > -10 && deg <= 90) << deg;
    EXPECT_EQ(pressed.right, deg >= -90 && deg < 10) << deg;
  }
}

TEST(Bumper, FeelsAPostAtEveryBearingOfItsFrontHalfAndNoneBehind) {
  for (int deg = -175; deg <= 180; deg += 5) {
    const double bearing_rad = rad_from_deg(deg);
    WorldDescription description = even_floor();
    // The post overlaps the shell by a millimetre, as after a step of driving into it.
    description.furniture.push_back(
        {.name = "post",
         .shape = FurnitureShape::kCircle,
         .X_WF = {0.219 * Vec2{std::cos(bearing_rad), std::sin(bearing_rad)}, 0.0},
         .radius_m = 0.05,
         .points_m = {},
         .tag = {}});
    World world = make(description, exact_robot());
    world.tick({});
    const BumpSwitches expected = switches_pressed(bearing_rad);
    if (std::abs(deg) != 90 && std::abs(deg) != 10) {  // at the very edge rounding decides
      EXPECT_EQ(world.roomba_inputs().bump_left, expected.left) << deg;
      EXPECT_EQ(world.roomba_inputs().bump_right, expected.right) << deg;
    }
  }
}

TEST(Bumper, ShowsATouchThatEndsWithinTheTick) {
  // The shell begins 0.05 mm inside the wall; reversing brings it 0.17 mm back before the tick is over.
  World world = make(wall_ahead(), exact_robot({{0.13005, 0.0}, 0.0}), 1, {.steps_per_tick = 60});
  world.tick(wheels(-0.5, -0.5));
  EXPECT_FALSE(world.contacts().touching_wall);
  EXPECT_TRUE(world.roomba_inputs().bump_left);
  EXPECT_TRUE(world.roomba_inputs().bump_right);
  run(world, wheels(-0.5, -0.5), 0.3);
  EXPECT_FALSE(world.roomba_inputs().bump_left);
  EXPECT_FALSE(world.roomba_inputs().bump_right);
}

TEST(Bumper, CountsEachMeetingWithAWallOnce) {
  World world = make(wall_ahead(), exact_robot());
  for (int i = 0; i < 3; ++i) {
    run(world, wheels(0.2, 0.2), 1.5);
    run(world, wheels(-0.2, -0.2), 1.0);
  }
  EXPECT_EQ(world.contacts().wall, 3U);
  EXPECT_EQ(world.contacts().push, 0U);
}

TEST(Furniture, ThatIsLightIsPushedAlong) {
  WorldDescription description = even_floor();
  description.furniture.push_back(block_ahead(2.0));
  World world = make(description, exact_robot());
  run(world, wheels(0.2, 0.2), 4.0);
  EXPECT_GT(world.X_WF()[0].p_m.x(), 0.7);
  EXPECT_EQ(world.contacts().push, 1U);
}

TEST(Furniture, ThatIsHeavyStopsTheRobotAndStandsWhereItStood) {
  // Dry friction 0.4 of 20 kg holds 78 N; the tyres slip at 19 N.
  WorldDescription description = even_floor();
  description.furniture.push_back(block_ahead(20.0));
  World world = make(description, exact_robot());
  run(world, wheels(0.2, 0.2), 4.0);
  EXPECT_NEAR(world.X_WF()[0].p_m.x(), 0.5, 0.002);
  EXPECT_NEAR(world.X_WR().p_m.x(), 0.18, 0.006);
}

TEST(Furniture, StopsSoonAfterThePushEnds) {
  WorldDescription description = even_floor();
  description.furniture.push_back(block_ahead(2.0));
  World world = make(description, exact_robot());
  run(world, wheels(0.3, 0.3), 2.0);
  run(world, {}, 1.0);
  const double x_m = world.X_WF()[0].p_m.x();
  run(world, {}, 5.0);
  EXPECT_NEAR(world.X_WF()[0].p_m.x(), x_m, 1e-4);
}

TEST(Furniture, LetsTheRobotPassBeneathWhenItIsHighEnough) {
  for (const double clearance_m : {0.15, 0.05}) {
    WorldDescription description = even_floor();
    description.furniture.push_back({.name = "bed",
                                     .shape = FurnitureShape::kBox,
                                     .X_WF = {{1.0, 0.0}, 0.0},
                                     .size_m = {0.6, 2.0},
                                     .points_m = {},
                                     .clearance_m = clearance_m,
                                     .tag = {}});
    World world = make(description, exact_robot());
    run(world, wheels(0.3, 0.3), 8.0);
    EXPECT_EQ(world.X_WR().p_m.x() > 2.0, clearance_m > 0.092) << clearance_m;
  }
}

TEST(Furniture, OfManyCornersBlocksAsOneConvexPiece) {
  Furniture pillar{.name = "pillar",
                   .shape = FurnitureShape::kPolygon,
                   .X_WF = {{0.6, 0.0}, 0.0},
                   .points_m = {},
                   .pushable = true,
                   .mass_kg = 50.0,
                   .tag = {}};
  for (int i = 0; i < 20; ++i) {
    pillar.points_m.emplace_back(0.2 * std::cos(robot::kPi * i / 10.0),
                                 0.2 * std::sin(robot::kPi * i / 10.0));
  }
  WorldDescription description = even_floor();
  description.furniture.push_back(pillar);
  World world = make(description, exact_robot());
  run(world, wheels(0.2, 0.2), 4.0);
  EXPECT_NEAR(world.X_WR().p_m.x(), 0.6 - 0.2 - 0.17, 0.006);
}

}  // namespace
}  // namespace sensotwin::world
