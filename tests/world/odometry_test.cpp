// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rooms.hpp"

namespace sensotwin::world {
namespace {

using robot::deg_from_rad;

constexpr int kRuns = 200;

/// Dead reckoning as on the machine: wheel rotation times the nominal geometry.
class DeadReckoning {
 public:
  void look(const RoombaInputs& in) {
    const RoombaDescription nominal;
    const double left_m = (in.wheel_angle_left_rad - left_rad_) * 0.5 * nominal.wheel_diameter_m;
    const double right_m = (in.wheel_angle_right_rad - right_rad_) * 0.5 * nominal.wheel_diameter_m;
    left_rad_ = in.wheel_angle_left_rad;
    right_rad_ = in.wheel_angle_right_rad;
    const double turn_rad = (right_m - left_m) / nominal.wheel_base_m;
    const double middle_rad = X_OR.yaw_rad + 0.5 * turn_rad;
    X_OR.p_m += 0.5 * (left_m + right_m) * Vec2{std::cos(middle_rad), std::sin(middle_rad)};
    X_OR.yaw_rad += turn_rad;
  }
  Pose2 X_OR;  ///< yaw not wrapped

 private:
  double left_rad_{0.0};
  double right_rad_{0.0};
};

struct Statistics {
  double sum{0.0};
  double squares{0.0};
  int count{0};
  void add(double x) {
    sum += x;
    squares += x * x;
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / count); }
};

// The figures of the "typ" class: 2 deg per 90-degree turn, 1 deg/sqrt(m), 1 % of the way (algorithms study,
// C.2). An rms over n runs is known to 1 / sqrt(2 n), 5 % here; four of these are the 20 % by which the
// bounds are wider than what the defaults give (measured: 1.1 % of the way, 0.7 to 1.0 deg/sqrt(m), 1.4 deg a
// turn).
TEST(Odometry, IsOfTheTypicalClassOnTheDefaultCarpetWhenDrivingStraight) {
  Statistics scale;
  std::vector<Statistics> heading_deg(4);
  for (int seed = 0; seed < kRuns; ++seed) {
    World world = make({}, {}, static_cast<std::uint64_t>(seed));
    DeadReckoning odometry;
    for (std::size_t metre = 0; metre < heading_deg.size(); ++metre) {
      while (odometry.X_OR.p_m.norm() < static_cast<double>(metre + 1)) {
        world.tick(wheels(0.3, 0.3));
        odometry.look(world.roomba_inputs());
      }
      heading_deg[metre].add(deg_from_rad(world.X_WR().yaw_rad - odometry.X_OR.yaw_rad));
    }
    scale.add(world.X_WR().p_m.norm() / odometry.X_OR.p_m.norm() - 1.0);
  }
  EXPECT_GT(scale.rms(), 0.005);
  EXPECT_LT(scale.rms(), 0.015);
  EXPECT_LT(scale.mean(), 0.0) << "the pile takes way, it never gives any";
  for (std::size_t i = 0; i < heading_deg.size(); ++i) {
    const double per_root_metre_deg = heading_deg[i].rms() / std::sqrt(static_cast<double>(i + 1));
    EXPECT_GT(per_root_metre_deg, 0.5) << i + 1 << " m";
    EXPECT_LT(per_root_metre_deg, 1.25) << i + 1 << " m";
    if (i > 0) {
      EXPECT_GT(heading_deg[i].rms(), heading_deg[i - 1].rms()) << "the error grows with the way";
    }
  }
}

TEST(Odometry, IsOfTheTypicalClassOnTheDefaultCarpetWhenTurningOnTheSpot) {
  Statistics turn_deg;
  for (int seed = 0; seed < kRuns; ++seed) {
    World world = make({}, {}, static_cast<std::uint64_t>(seed));
    DeadReckoning odometry;
    double true_rad = 0.0;
    while (odometry.X_OR.yaw_rad < robot::kPi) {
      const double before_rad = world.X_WR().yaw_rad;
      world.tick(wheels(-0.1, 0.1));
      true_rad += robot::wrap_angle(world.X_WR().yaw_rad - before_rad);
      odometry.look(world.roomba_inputs());
    }
    turn_deg.add(0.5 * deg_from_rad(true_rad - odometry.X_OR.yaw_rad));
  }
  EXPECT_GT(turn_deg.rms(), 1.0);
  EXPECT_LT(turn_deg.rms(), 2.0);
}

TEST(Odometry, IsWithinAFewTenthsOfAPercentForAnExactRobotOnAnEvenFloor) {
  World world = make(even_floor(), exact_robot());
  DeadReckoning odometry;
  for (int i = 0; i < 600; ++i) {
    world.tick(wheels(0.3, 0.3));
    odometry.look(world.roomba_inputs());
  }
  // What is left is creep: rolling resistance over friction times the creep coefficient, 0.0015.
  const double scale = world.X_WR().p_m.x() / odometry.X_OR.p_m.x() - 1.0;
  EXPECT_NEAR(scale, -0.04 / (0.6 * 0.9) * 0.02, 0.0006);
}

}  // namespace
}  // namespace sensotwin::world
