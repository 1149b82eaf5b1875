// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_sensor_board.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "tests/robot/drivers/compass_transcript.hpp"

namespace sensotwin::twin {
namespace {

using robot::Duration;
using robot::Instant;
using robot::kTick;

std::string heard(robot::ByteLink& link) {
  std::array<std::uint8_t, 2048> bytes{};
  const std::size_t n = link.read(bytes);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)};
}

TEST(EmulatedSensorBoard, SaysTheSentencesThatTheDriverIsTestedWith) {
  EmulatedSensorBoard board{{}};
  Instant now{};
  for (const auto& line : testing::kCompassLines) {
    now += std::chrono::milliseconds{100};
    board.step(now, line.yaw_from_north_rad);
    EXPECT_EQ(heard(board), line.sentence);
  }
}

TEST(EmulatedSensorBoard, SpeaksEverySixOrSevenTicksAndTenTimesASecond) {
  EmulatedSensorBoard board{{}};
  Instant now{};
  std::vector<int> spoke;
  for (int tick = 1; tick <= 6'667; ++tick) {  // 100.005 s
    now += kTick;
    board.step(now, 0.0);
    if (!heard(board).empty()) {
      spoke.push_back(tick);
    }
  }
  EXPECT_EQ(spoke.size(), 1000u);
  EXPECT_EQ(spoke.front(), 7);  // 105 ms: the first tick at or after 100 ms
  for (std::size_t i = 1; i < spoke.size(); ++i) {
    EXPECT_TRUE(spoke[i] - spoke[i - 1] == 6 || spoke[i] - spoke[i - 1] == 7);
  }
}

TEST(EmulatedSensorBoard, SpeaksOnceAfterALongStep) {
  EmulatedSensorBoard board{{}};
  board.step(Instant{std::chrono::seconds{3}}, 0.0);
  EXPECT_EQ(heard(board), testing::kCompassLines[0].sentence);
  board.step(Instant{std::chrono::milliseconds{3'090}}, 0.0);
  EXPECT_EQ(heard(board), "");
}

TEST(EmulatedSensorBoard, KeepsTheLatestSentencesForWhoDoesNotRead) {
  EmulatedSensorBoard board{{}};
  Instant now{};
  for (int i = 0; i < 100; ++i) {
    now += std::chrono::milliseconds{100};
    board.step(now, i == 99 ? robot::kPi / 2 : 0.0);
  }
  const std::string text = heard(board);
  EXPECT_EQ(text.size(), 512u);
  EXPECT_TRUE(text.ends_with(testing::kCompassLines[2].sentence));
}

TEST(EmulatedSensorBoard, IsSilentWhileUnplugged) {
  EmulatedSensorBoard board{{}};
  board.step(Instant{std::chrono::milliseconds{100}}, 0.0);
  board.unplug();
  EXPECT_FALSE(board.is_up());
  board.step(Instant{std::chrono::milliseconds{200}}, 0.0);
  board.replug();
  EXPECT_EQ(heard(board), "");
  board.step(Instant{std::chrono::milliseconds{300}}, 0.0);
  EXPECT_EQ(heard(board), testing::kCompassLines[0].sentence);
}

// The sentence's one decimal rounds by at most 0.05 degrees, and that is all that is lost on the way.
TEST(EmulatedSensorBoard, IsUnderstoodByTheDriverToATwentiethOfADegree) {
  EmulatedSensorBoard board{{}};
  robot::SensorBoard driver{board};
  Instant now{};
  for (int i = 0; i < 2'000; ++i) {
    const double yaw_rad = robot::wrap_angle(0.0123 * i);
    now += std::chrono::milliseconds{100};
    board.step(now, yaw_rad);
    driver.step(now);
    ASSERT_TRUE(driver.compass());
    EXPECT_LE(std::abs(robot::wrap_angle(driver.compass()->yaw_from_north_rad - yaw_rad)),
              robot::rad_from_deg(0.05) + 1e-12);
  }
  EXPECT_EQ(driver.health().headings, 2'000u);
}

}  // namespace
}  // namespace sensotwin::twin
