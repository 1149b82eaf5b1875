// SPDX-License-Identifier: MIT
#include "robot/mapping/light_bumper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sensotwin::robot {
namespace {

// The law of world/body_sensors.hpp, in numbers of its own so that neither side can change alone:
// signal = 4095 / (1 + d / 0.05 m)^2 up to d = 0.25 m, then 0; beams to +-65, +-38 and +-14 degrees.
constexpr double kFullSignal = 4095.0;
constexpr double kHalfway_m = 0.05;

std::uint16_t signal_at(double range_m) {
  return static_cast<std::uint16_t>(std::lround(kFullSignal / std::pow(1.0 + range_m / kHalfway_m, 2)));
}

TEST(LightBumper, TellsTheRangeThatTheSurfaceAnsweredFrom) {
  const LightBumper bumper;
  for (double range_m = 0.0; range_m < 0.199; range_m += 0.001) {
    const auto told_m = bumper.range_m(signal_at(range_m));
    ASSERT_TRUE(told_m.has_value()) << range_m;
    // Half a step of the signal is 0.4 mm where the law is flattest, at 0.2 m.
    ASSERT_NEAR(*told_m, range_m, 0.0005);
  }
}

TEST(LightBumper, KnowsNoRangeWhenNothingAnswers) {
  EXPECT_FALSE(LightBumper{}.range_m(0).has_value());
}

TEST(LightBumper, DoesNotBelieveWhatIsFartherThanItTrusts) {
  EXPECT_FALSE(LightBumper{}.range_m(signal_at(0.21)).has_value());
  EXPECT_FALSE(LightBumper{}.range_m(1).has_value());
}

TEST(LightBumper, TakesTheFullSignalForTouch) {
  EXPECT_DOUBLE_EQ(*LightBumper{}.range_m(4095), 0.0);
}

TEST(LightBumper, LooksTheWaysTheBodyDoesFromLeftToRight) {
  const std::array<double, 6> expected_deg{65, 38, 14, -14, -38, -65};
  for (std::size_t i = 0; i < expected_deg.size(); ++i) {
    EXPECT_DOUBLE_EQ(deg_from_rad(LightBumper{}.yaw_R_rad[i]), expected_deg[i]);
  }
}

}  // namespace
}  // namespace sensotwin::robot
