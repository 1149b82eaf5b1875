// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "rooms.hpp"
#include "world/sonar_ring.hpp"

namespace sensotwin::world {
namespace {

using robot::rad_from_deg;
constexpr double kNothing = -1.0;

/// One rangefinder in the middle of the robot, that looks forward.
SonarDescription one() {
  SonarDescription sonar;
  sonar.bearings_rad = {0.0};
  sonar.mount_radius_m = 0.0;
  return sonar;
}

double heard_m(const SonarDescription& sonar, Outline outline, const Pose2& X_WR = {}) {
  const SonarRing ring(sonar, robot::RandomStream{1});
  return ring.echoes_m(ObstacleIndex(std::move(outline)), {}, X_WR).at(0).value_or(kNothing);
}

Outline wall_at(double x_m) {
  return {{{{x_m, -20.0}, {x_m, 20.0}}}, {}};
}

TEST(Sonar, HearsTheNearestPointOfAWallAheadNotThatOnItsAxis) {
  EXPECT_NEAR(heard_m(one(), wall_at(2.0)), 2.0, 1e-3);
  for (const double turn_deg : {5.0, 10.0, 14.0}) {
    EXPECT_NEAR(heard_m(one(), wall_at(2.0), {{0.0, 0.0}, rad_from_deg(turn_deg)}), 2.0, 1e-3) << turn_deg;
  }
}

TEST(Sonar, HearsAWallByTheEdgeOfItsConeAndLosesItBeyondTheSpecularLimit) {
  // At 40 degrees the nearest ray meets the wall at 25, and the sound comes back.
  EXPECT_NEAR(heard_m(one(), wall_at(1.0), {{0.0, 0.0}, rad_from_deg(40.0)}),
              1.0 / std::cos(rad_from_deg(25.0)), 1e-3);
  EXPECT_GT(heard_m(one(), wall_at(1.0), {{0.0, 0.0}, rad_from_deg(44.5)}), 1.0);
  EXPECT_EQ(heard_m(one(), wall_at(1.0), {{0.0, 0.0}, rad_from_deg(46.0)}), kNothing);
}

TEST(Sonar, HearsNothingBeyondItsRangeAndNothingNearerThanItsLeast) {
  EXPECT_NEAR(heard_m(one(), wall_at(4.99)), 4.99, 1e-3);
  EXPECT_EQ(heard_m(one(), wall_at(5.01)), kNothing);
  EXPECT_EQ(heard_m(one(), wall_at(0.01)), 0.03);
}

TEST(Sonar, FindsAThinLegAnywhereInItsCone) {
  for (double bearing_deg = -14.9; bearing_deg < 15.0; bearing_deg += 0.37) {
    const Vec2 at_m = 4.0 * Vec2{std::cos(rad_from_deg(bearing_deg)), std::sin(rad_from_deg(bearing_deg))};
    EXPECT_NEAR(heard_m(one(), {{}, {{at_m, 0.02}}}), 3.98, 1e-3) << bearing_deg;
  }
  EXPECT_EQ(heard_m(one(), {{}, {{{3.0, 1.2}, 0.02}}}), kNothing) << "at 21.8 degrees";
}

TEST(Sonar, DoesNotHearThroughAWall) {
  Outline outline = wall_at(1.0);
  outline.discs.push_back({{2.0, 0.0}, 0.1});
  EXPECT_NEAR(heard_m(one(), outline), 1.0, 1e-3);
  // The wall is a mirror here, and hides the leg all the same.
  Outline slanted{{{{0.0, -1.0}, {3.0, 0.5}}}, {{{2.9, -0.2}, 0.05}}};
  EXPECT_EQ(heard_m(one(), slanted, {{0.0, -0.5}, rad_from_deg(5.0)}), kNothing);
}

TEST(Sonar, HearsACornerNearBy) {
  // Two walls that meet at 45 degrees from the axis: both mirrors, the corner between them is not.
  const auto corner_at = [](double x_m) {
    return Outline{{{{x_m - 10.0, 10.0}, {x_m, 0.0}}, {{x_m, 0.0}, {x_m - 10.0, -10.0}}}, {}};
  };
  SonarDescription narrow = one();
  narrow.half_angle_rad = rad_from_deg(10.0);
  EXPECT_NEAR(heard_m(narrow, corner_at(2.0)), 2.0, 1e-6);
  EXPECT_EQ(heard_m(narrow, corner_at(3.0)), kNothing);
}

TEST(Sonar, OfAHallwaySeesBothWallsAndTheOpeningBetweenThem) {
  WorldDescription description = even_floor();
  description.walls.push_back({.points_m = {{-9.0, 1.0}, {9.0, 1.0}}, .closed = false});
  description.walls.push_back({.points_m = {{-9.0, -1.0}, {9.0, -1.0}}, .closed = false});
  RobotDescription robot = exact_robot();
  robot.sonar.emplace();
  robot.sonar->noise_sigma_m = 0.0;
  robot.sonar->dropout = 0.0;
  World world = make(description, robot);
  const auto ranges = world.sonar_ranges_m();
  ASSERT_EQ(ranges.size(), 7u);
  EXPECT_NEAR(ranges[0].value_or(kNothing), 0.85, 1e-3);
  EXPECT_NEAR(ranges[6].value_or(kNothing), 0.85, 1e-3);
  EXPECT_FALSE(ranges[3]);
}

TEST(Sonar, SeesWhatHasBeenPushedWhereItIsNow) {
  WorldDescription description = even_floor();
  Furniture box;
  box.name = "box";
  box.X_WF = {{1.5, 0.0}, 0.0};
  box.size_m = {0.4, 0.4};
  box.pushable = true;
  box.mass_kg = 1.0;
  description.furniture.push_back(box);
  RobotDescription robot = exact_robot();
  robot.sonar = one();
  robot.sonar->noise_sigma_m = 0.0;
  robot.sonar->dropout = 0.0;
  World world = make(description, robot);
  EXPECT_NEAR(world.sonar_ranges_m()[0].value_or(kNothing), 1.3, 2e-3);
  run(world, wheels(0.3, 0.3), 6.0);
  ASSERT_GT(world.X_WF()[0].p_m.x(), 1.6);
  EXPECT_NEAR(world.sonar_ranges_m()[0].value_or(kNothing), 0.17, 0.02);
}

TEST(Sonar, HasTheNoiseAndTheDropoutsThatItIsGiven) {
  SonarDescription sonar = one();
  sonar.dropout = 0.1;
  SonarRing ring(sonar, robot::RandomStream{7});
  const ObstacleIndex fixed(wall_at(2.0));
  double sum = 0.0;
  double squares = 0.0;
  int heard = 0;
  constexpr int kReadings = 4000;
  for (int i = 0; i < kReadings; ++i) {
    if (const auto range_m = ring.read_m(fixed, {}, {}).at(0)) {
      sum += *range_m;
      squares += (*range_m - 2.0) * (*range_m - 2.0);
      ++heard;
    }
  }
  EXPECT_NEAR(heard, 0.9 * kReadings, 5.0 * std::sqrt(0.09 * kReadings));
  EXPECT_NEAR(sum / heard, 2.0, 1e-3);
  EXPECT_NEAR(std::sqrt(squares / heard), 0.01, 0.001);
}

TEST(Sonar, OverhearsItsNeighbourWhenBothFireAtOnce) {
  SonarDescription sonar = one();
  sonar.bearings_rad = {rad_from_deg(90.0), 0.0};
  sonar.noise_sigma_m = 0.0;
  sonar.dropout = 0.0;
  const ObstacleIndex fixed(Outline{{{{-9.0, 1.0}, {9.0, 1.0}}, {{3.0, -9.0}, {3.0, 0.9}}}, {}});
  SonarRing alone(sonar, robot::RandomStream{1});
  EXPECT_NEAR(alone.read_m(fixed, {}, {})[1].value_or(kNothing), 3.0, 1e-2);
  sonar.crosstalk = 1.0;
  SonarRing together(sonar, robot::RandomStream{1});
  EXPECT_NEAR(together.read_m(fixed, {}, {})[1].value_or(kNothing), 1.0, 1e-2);
}

}  // namespace
}  // namespace sensotwin::world
