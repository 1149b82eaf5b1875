// SPDX-License-Identifier: MIT
#include "robot/wire/sci.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/wire/oi_opcodes.hpp"

namespace sensotwin::robot::sci {
namespace {

TEST(Sci, HasFourSensorGroupsOf26And10And6And10Bytes) {
  const std::array<std::size_t, 4> sizes{26, 10, 6, 10};
  std::array<std::uint8_t, 26> bytes{};
  for (std::uint8_t code = 0; code <= kLastGroup; ++code) {
    EXPECT_EQ(*encode_sensors(code, oi::SensorValues{}, bytes), sizes[code]);
  }
}

TEST(Sci, AnswersNoSinglePacketsAndNoMode) {
  std::array<std::uint8_t, 80> bytes{};
  oi::SensorValues values;
  for (const std::uint8_t code : Bytes{4, 6, 7, 35, 100}) {
    EXPECT_EQ(encode_sensors(code, values, bytes).error(), oi::PacketError::kUnknownPacket);
    EXPECT_EQ(decode_sensors(code, bytes, values).error(), oi::PacketError::kUnknownPacket);
  }
}

TEST(Sci, CarriesTheRightDirtDetectorAndTheCasterWhereLaterRobotsSendZero) {
  oi::SensorValues values;
  values[oi::PacketId::kBumpsAndWheelDrops] = kWheelDropCaster;
  values[oi::PacketId::kUnused16] = 77;
  std::array<std::uint8_t, 26> bytes{};
  ASSERT_TRUE(encode_sensors(kAllSensors, values, bytes));
  EXPECT_EQ(bytes[0], 16);
  EXPECT_EQ(bytes[9], 77);
  oi::SensorValues back;
  ASSERT_TRUE(decode_sensors(kAllSensors, bytes, back));
  EXPECT_EQ(back, values);
}

// SCI specification, 2005: degrees = 360 * angle / (258 * pi).
TEST(Sci, TurnsAngleMillimetresIntoRadians) {
  EXPECT_NEAR(deg_from_rad(turn_rad(100)), 360.0 * 100 / (258 * kPi), 1e-9);
}

TEST(Sci, LeavesPassiveByControlOnly) {
  using oi::Mode;
  const auto acts_in = [](oi::Opcode code, Mode mode) {
    return oi::contains(oi::kSerialCommandInterface.find(static_cast<std::uint8_t>(code))->modes, mode);
  };
  EXPECT_TRUE(acts_in(oi::Opcode::kControl, Mode::kPassive));
  EXPECT_FALSE(acts_in(oi::Opcode::kSafe, Mode::kPassive));
  EXPECT_FALSE(acts_in(oi::Opcode::kFull, Mode::kPassive));
  EXPECT_TRUE(acts_in(oi::Opcode::kFull, Mode::kSafe));
  EXPECT_TRUE(acts_in(oi::Opcode::kSafe, Mode::kFull));
}

}  // namespace
}  // namespace sensotwin::robot::sci
