// SPDX-License-Identifier: MIT
#include "robot/wire/oi_packets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "robot/base/random.hpp"

namespace sensotwin::robot::oi {
namespace {

using ::testing::ElementsAre;

constexpr std::array<std::uint8_t, 11> kGroups{0, 1, 2, 3, 4, 5, 6, 100, 101, 106, 107};

[[nodiscard]] SensorValues random_values(RandomStream& random) {
  SensorValues values;
  for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
    const PacketInfo& info = packet_info(id);
    const auto span = static_cast<std::uint32_t>(info.max - info.min + 1);
    values[static_cast<PacketId>(id)] = info.min + static_cast<std::int32_t>(random.below(span));
  }
  return values;
}

/// `values` with all packets outside first..last set to 0.
[[nodiscard]] SensorValues only(const SensorValues& values, const PacketRun& run) {
  SensorValues out;
  for (std::uint8_t id = run.first; id <= run.last; ++id) {
    out[static_cast<PacketId>(id)] = values[static_cast<PacketId>(id)];
  }
  return out;
}

void expect_round_trip(std::uint8_t id, const SensorValues& values) {
  std::array<std::uint8_t, 80> bytes{};
  const auto written = encode_packet(id, values, bytes);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, packet_run(id).size);
  SensorValues back;
  const auto used = decode_packet(id, ByteView{bytes}.first(*written), back);
  ASSERT_TRUE(used);
  EXPECT_EQ(*used, *written);
  EXPECT_EQ(back, only(values, packet_run(id))) << "packet " << int{id};
}

TEST(SensorPacket, ReturnsFromTheWireAsItWasForEveryPacketAndGroup) {
  RandomStream random = RandomStream{2}.fork("packets");
  for (int i = 0; i < 200; ++i) {
    const SensorValues values = random_values(random);
    for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
      expect_round_trip(id, values);
    }
    for (const std::uint8_t id : kGroups) {
      expect_round_trip(id, values);
    }
  }
}

TEST(SensorPacket, CarriesBothEndsOfItsRange) {
  for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
    for (const std::int32_t value : {packet_info(id).min, packet_info(id).max}) {
      SensorValues values;
      values[static_cast<PacketId>(id)] = value;
      expect_round_trip(id, values);
    }
  }
}

// Page 37, "Group Packet Sizes and Contents".
TEST(SensorPacket, HasTheSizesOfTheManual) {
  const std::array<int, kGroups.size()> sizes{26, 10, 6, 10, 14, 12, 52, 80, 28, 12, 9};
  for (std::size_t i = 0; i < kGroups.size(); ++i) {
    EXPECT_EQ(packet_run(kGroups[i]).size, sizes[i]) << "group " << int{kGroups[i]};
  }
}

// Offsets that pycreate2 and BreezyCreate2 rely on in group 100.
TEST(SensorPacket, StandsWhereClientsLookForItInGroup100) {
  SensorValues values;
  values[PacketId::kDistance] = -2;
  values[PacketId::kVoltage] = 0x38A4;
  values[PacketId::kMode] = 3;
  values[PacketId::kEncoderLeft] = 0x0123;
  values[PacketId::kLightBumper] = 0x2A;
  values[PacketId::kStasis] = 1;
  std::array<std::uint8_t, 80> b{};
  ASSERT_TRUE(encode_packet(100, values, b));
  EXPECT_EQ(s16_from_be(b[12], b[13]), -2);
  EXPECT_EQ(u16_from_be(b[17], b[18]), 0x38A4);
  EXPECT_EQ(b[40], 3);
  EXPECT_EQ(u16_from_be(b[52], b[53]), 0x0123);
  EXPECT_EQ(b[56], 0x2A);
  EXPECT_EQ(b[79], 1);
}

TEST(SensorPacket, IsRefusedByNameWhenNobodyKnowsItsId) {
  SensorValues values;
  std::array<std::uint8_t, 80> bytes{};
  for (const std::uint8_t id : Bytes{59, 99, 102, 103, 104, 105, 108, 255}) {
    ASSERT_FALSE(encode_packet(id, values, bytes));
    EXPECT_EQ(encode_packet(id, values, bytes).error(), PacketError::kUnknownPacket);
    EXPECT_EQ(decode_packet(id, bytes, values).error(), PacketError::kUnknownPacket);
  }
}

TEST(SensorPacket, SaysWhenBytesOrRoomEndTooSoonAndStoresNothing) {
  SensorValues values;
  std::array<std::uint8_t, 79> bytes{};
  bytes.fill(7);
  EXPECT_EQ(encode_packet(100, values, bytes).error(), PacketError::kNoRoom);
  EXPECT_EQ(decode_packet(100, bytes, values).error(), PacketError::kTooShort);
  EXPECT_EQ(values, SensorValues{});
}

}  // namespace
}  // namespace sensotwin::robot::oi
