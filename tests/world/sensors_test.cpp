// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "rooms.hpp"
#include "world/battery.hpp"
#include "world/compass_field.hpp"

namespace sensotwin::world {
namespace {

using robot::rad_from_deg;

RoombaInputs at_rest(const WorldDescription& description, const Pose2& X_WR) {
  World world = make(description, exact_robot(X_WR));
  world.tick({});
  return world.roomba_inputs();
}

TEST(LightBumper, FallsWithTheDistanceToTheWallAsItsLawSays) {
  WorldDescription description = even_floor();
  description.walls.push_back({.points_m = {{0.0, -3.0}, {0.0, 3.0}}, .closed = false});
  const double forward_cos = std::cos(rad_from_deg(14.0));
  for (const double gap_m : {0.02, 0.05, 0.10, 0.15}) {
    const RoombaInputs in = at_rest(description, {{-0.17 - gap_m, 0.0}, 0.0});
    const double beam_m = (0.17 + gap_m) / forward_cos - 0.17;
    const double law = 4095.0 / ((1.0 + beam_m / 0.05) * (1.0 + beam_m / 0.05));
    EXPECT_NEAR(in.light_bump_signal[2], law, 2.0) << gap_m;
    EXPECT_EQ(in.light_bump_signal[2], in.light_bump_signal[3]);
  }
  EXPECT_EQ(at_rest(description, {{-0.5, 0.0}, 0.0}).light_bump_signal, (std::array<std::uint16_t, 6>{}));
}

TEST(LightBumper, SeesAWallOnTheRightInItsRightmostBeamAndInTheWallSignal) {
  WorldDescription description = even_floor();
  description.walls.push_back({.points_m = {{-3.0, -0.22}, {3.0, -0.22}}, .closed = false});
  const RoombaInputs in = at_rest(description, {});
  EXPECT_GT(in.light_bump_signal[5], 500);
  EXPECT_EQ(in.light_bump_signal[0], 0);
  EXPECT_EQ(in.wall_signal, in.light_bump_signal[5] / 4);
}

TEST(LightBumper, SeesFurnitureThatHasBeenPushedThere) {
  WorldDescription description = even_floor();
  description.furniture.push_back({.name = "box",
                                   .shape = FurnitureShape::kBox,
                                   .X_WF = {{0.5, 0.0}, 0.0},
                                   .size_m = {0.3, 0.6},
                                   .points_m = {},
                                   .pushable = true,
                                   .mass_kg = 1.0,
                                   .tag = {}});
  World world = make(description, exact_robot());
  run(world, wheels(0.3, 0.3), 5.0);
  EXPECT_GT(world.X_WR().p_m.x(), 1.0);
  EXPECT_GT(world.roomba_inputs().light_bump_signal[2], 3000);
}

TEST(LightBumper, StaysRightWhileTheRobotComesFromFarAway) {
  // The sensors look up walls only when one may have come near; driving there must equal being put there.
  WorldDescription description = even_floor();
  description.walls.push_back(room(6.0, 4.0));
  World driven = make(description, exact_robot({{1.0, 2.0}, 0.3}));
  for (int i = 0; i < 900; ++i) {
    driven.tick(wheels(0.3, 0.28));
    if (i % 30 == 0) {
      const RoombaInputs there = driven.roomba_inputs();
      const RoombaInputs put = at_rest(description, driven.X_WR());
      for (std::size_t beam = 0; beam < 6; ++beam) {
        ASSERT_NEAR(there.light_bump_signal[beam], put.light_bump_signal[beam], 60) << i << ' ' << beam;
      }
    }
  }
}

WorldDescription with_stairs() {
  WorldDescription description = even_floor();
  description.cliffs.push_back({{{0.5, -1.0}, {1.5, -1.0}, {1.5, 1.0}, {0.5, 1.0}}});
  return description;
}

TEST(Cliff, IsSeenByTheFrontSensorsBeforeAWheelDrops) {
  const RoombaInputs before = at_rest(with_stairs(), {{0.30, 0.0}, 0.0});
  EXPECT_EQ(before.cliff, (std::array<bool, 4>{}));
  const RoombaInputs there = at_rest(with_stairs(), {{0.36, 0.0}, 0.0});
  EXPECT_EQ(there.cliff, (std::array<bool, 4>{false, true, true, false}));
  EXPECT_LT(there.cliff_signal[1], there.cliff_signal[0]);
  EXPECT_FALSE(there.wheel_drop_left);
}

TEST(Cliff, TakesTheFloorFromUnderTheWheels) {
  World world = make(with_stairs(), exact_robot());
  run(world, wheels(0.3, 0.3), 6.0);
  EXPECT_TRUE(world.roomba_inputs().wheel_drop_left);
  EXPECT_TRUE(world.roomba_inputs().wheel_drop_right);
  EXPECT_LT(world.X_WR().p_m.x(), 0.7) << "wheels in the air do not drive";
}

TEST(VirtualWall, IsSeenInsideItsFanOnly) {
  WorldDescription description = even_floor();
  description.virtual_walls.push_back({.X_WV = {{0.0, 0.0}, 0.0}, .range_m = 2.0, .half_angle_rad = 0.1});
  EXPECT_TRUE(at_rest(description, {{1.0, 0.05}, 1.0}).virtual_wall);
  EXPECT_EQ(at_rest(description, {{1.0, 0.05}, 1.0}).ir_omni, 162);
  EXPECT_FALSE(at_rest(description, {{1.0, 0.2}, 1.0}).virtual_wall);
  EXPECT_FALSE(at_rest(description, {{2.2, 0.0}, 1.0}).virtual_wall);
  description.walls.push_back({.points_m = {{0.5, -1.0}, {0.5, 1.0}}, .closed = false});
  EXPECT_FALSE(at_rest(description, {{1.0, 0.05}, 1.0}).virtual_wall) << "a wall hides it";
}

TEST(HomeBase, ShowsRedOnTheLeftGreenOnTheRightAndItsForceFieldNear) {
  WorldDescription description = even_floor();
  description.home_base = HomeBase{};
  EXPECT_EQ(at_rest(description, {{1.5, 0.0}, robot::kPi}).ir_omni, 172);   // both buoys
  EXPECT_EQ(at_rest(description, {{1.5, -0.5}, robot::kPi}).ir_omni, 168);  // left as the robot sees it
  EXPECT_EQ(at_rest(description, {{1.5, 0.5}, robot::kPi}).ir_omni, 164);
  EXPECT_EQ(at_rest(description, {{0.4, 0.0}, robot::kPi}).ir_omni, 173);
  EXPECT_EQ(at_rest(description, {{2.5, 0.0}, robot::kPi}).ir_omni, 0);
}

TEST(HomeBase, ChargesADockedRobotUnlessItsModeForbids) {
  WorldDescription description = even_floor();
  description.home_base = HomeBase{};
  RobotDescription robot = exact_robot({{0.175, 0.0}, robot::kPi});
  robot.base.battery_charge_mah = 1000.0;
  World world = make(description, robot);
  run(world, {}, 60.0);
  EXPECT_TRUE(world.roomba_inputs().on_home_base);
  EXPECT_GT(world.roomba_inputs().battery_ma, 500);
  EXPECT_GT(world.roomba_inputs().battery_charge_mah, 1010.0);
  RoombaOutputs safe_mode;
  safe_mode.charging_allowed = false;
  run(world, safe_mode, 1.0);
  EXPECT_LT(world.roomba_inputs().battery_ma, 0);
}

TEST(Battery, GivesNoMoreThanItHolds) {
  RoombaDescription base;
  base.battery_charge_mah = 1.0;
  Battery battery(base);
  for (int i = 0; i < 100; ++i) {
    battery.pass(1.0, 360.0, false);  // 0.1 mAh each second
    EXPECT_NEAR(battery.charge_mah(), std::max(0.0, 1.0 - 0.1 * (i + 1)), 1e-9);
  }
  EXPECT_TRUE(battery.empty());
}

TEST(Battery, LosesVoltageWithItsChargeAndUnderLoad) {
  double last_mv = 1e9;
  for (const double charge_mah : {2696.0, 2400.0, 1300.0, 500.0, 100.0}) {
    RoombaDescription base;
    base.battery_charge_mah = charge_mah;
    Battery battery(base);
    const double open_mv = battery.voltage_mv();
    EXPECT_LT(open_mv, last_mv);
    last_mv = open_mv;
    battery.pass(1e-6, 1000.0, false);
    EXPECT_NEAR(open_mv - battery.voltage_mv(), 150.0, 1.0);
  }
}

TEST(Battery, StopsTheRobotWhenItIsEmpty) {
  RobotDescription robot = exact_robot();
  robot.base.battery_charge_mah = 0.5;  // a few seconds of driving
  World world = make(even_floor(), robot);
  run(world, wheels(0.3, 0.3), 20.0);
  EXPECT_FALSE(world.roomba_inputs().power);
  EXPECT_EQ(world.energy_j(), 0.0);
  const double x_m = world.X_WR().p_m.x();
  run(world, wheels(0.3, 0.3), 5.0);
  EXPECT_EQ(world.X_WR().p_m.x(), x_m);
}

TEST(Compass, CountsClockwiseFromNorth) {
  const CompassField field({}, {}, robot::RandomStream{1});
  EXPECT_NEAR(field.field_heading_rad({{0.0, 0.0}, rad_from_deg(90.0)}), 0.0, 1e-12);  // north
  EXPECT_NEAR(field.field_heading_rad({{0.0, 0.0}, 0.0}), rad_from_deg(90.0), 1e-12);  // east
  EXPECT_NEAR(field.field_heading_rad({{0.0, 0.0}, rad_from_deg(180.0)}), rad_from_deg(270.0),
              1e-12);  // west
}

TEST(Compass, IsBentByIronAsAGaussianOfTheDistance) {
  WorldDescription world;
  world.compass_distortions.push_back({.at_m = {2.0, 1.0}, .radius_m = 0.5, .peak_rad = 0.4});
  const CompassField field(world, {}, robot::RandomStream{1});
  for (const double d_m : {0.0, 0.25, 0.5, 1.0, 3.0}) {
    EXPECT_NEAR(field.field_heading_rad({{2.0 + d_m, 1.0}, 0.0}),
                rad_from_deg(90.0) + 0.4 * std::exp(-d_m * d_m / 0.25), 1e-12);
  }
}

TEST(Compass, ScattersByItsNoiseAroundTheField) {
  World world = make({}, exact_robot());
  const int n = 4000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < n; ++i) {
    const double error_rad = world.compass_heading_rad() - 0.5 * robot::kPi;
    sum += error_rad;
    squares += error_rad * error_rad;
  }
  const double sigma_rad = CompassDescription{}.noise_sigma_rad;
  EXPECT_NEAR(sum / n, 0.0, 4.0 * sigma_rad / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), sigma_rad, 4.0 * sigma_rad / std::sqrt(2.0 * n));
}

}  // namespace
}  // namespace sensotwin::world
