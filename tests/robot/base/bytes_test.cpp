// SPDX-License-Identifier: MIT
#include "robot/base/bytes.hpp"

#include <gtest/gtest.h>

namespace sensotwin::robot {
namespace {

// Create 2 Open Interface (2016), opcode 137, worked example: velocity -200 is FF 38, radius 500 is 01 F4.
TEST(BigEndianBytes, AreThoseOfTheManualsDriveExample) {
  EXPECT_EQ(s16_from_be(0xFF, 0x38), -200);
  EXPECT_EQ(s16_from_be(0x01, 0xF4), 500);
  EXPECT_EQ(high_byte(500), 0x01);
  EXPECT_EQ(low_byte(500), 0xF4);
}

TEST(BigEndianBytes, KeepTheTopBitWhenUnsigned) {
  EXPECT_EQ(u16_from_be(0xFF, 0xFF), 65535);
  EXPECT_EQ(u16_from_be(0x80, 0x00), 32768);
  EXPECT_EQ(s16_from_be(0x80, 0x00), -32768);
}

TEST(BigEndianBytes, ComeBackFromEveryNumber) {
  for (int i = 0; i <= 0xFFFF; ++i) {
    const auto value = static_cast<std::uint16_t>(i);
    ASSERT_EQ(u16_from_be(high_byte(value), low_byte(value)), value);
  }
}

}  // namespace
}  // namespace sensotwin::robot
