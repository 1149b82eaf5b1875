// SPDX-License-Identifier: MIT
#include "robot/wire/oi_stream_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/wire/oi_stream.hpp"

namespace sensotwin::robot::oi {
namespace {

/// Every single packet, twice a group, and a packet twice.
const std::vector<Bytes> kRequests{{7}, {29, 13}, {1, 58}, {100}, {19, 20, 19}, [] {
                                     Bytes all(kLastPacket - kFirstPacket + 1);
                                     std::iota(all.begin(), all.end(), kFirstPacket);
                                     return all;
                                   }()};

SensorValues noise(RandomStream& random) {
  SensorValues values;
  for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
    values[static_cast<PacketId>(id)] = static_cast<std::int32_t>(random.below(65536)) - 32768;
  }
  return values;
}

TEST(StreamLayout, SaysTheSameBytesAsTheGeneralCodec) {
  RandomStream random{42};
  for (const Bytes& ids : kRequests) {
    const auto layout = StreamLayout::of(ids);
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->payload_bytes(), payload_bytes(ids));
    for (int i = 0; i < 100; ++i) {
      const SensorValues values = noise(random);
      std::array<std::uint8_t, 258> expected{};
      std::array<std::uint8_t, 258> said{};
      const auto size = encode_frame(ids, values, expected);
      ASSERT_TRUE(size);
      EXPECT_EQ(layout->encode(values, said), *size);
      EXPECT_EQ(said, expected);
    }
  }
}

TEST(StreamLayout, ReadsTheSameValuesAsTheGeneralCodec) {
  RandomStream random{43};
  for (const Bytes& ids : kRequests) {
    const auto layout = StreamLayout::of(ids);
    ASSERT_TRUE(layout);
    for (int i = 0; i < 100; ++i) {
      std::array<std::uint8_t, 258> frame{};
      const std::size_t size = layout->encode(noise(random), frame);
      const ByteView payload = ByteView{frame}.subspan(2, size - kStreamOverhead);
      SensorValues expected;
      SensorValues read;
      ASSERT_TRUE(decode_payload(payload, expected));
      EXPECT_TRUE(layout->decode(payload, read));
      EXPECT_EQ(read, expected);
    }
  }
}

TEST(StreamLayout, RefusesAPayloadOfAnotherRequestAndStoresNothing) {
  const Bytes ids{29, 13, 8, 9, 10, 11};
  const auto layout = StreamLayout::of(ids);
  ASSERT_TRUE(layout);
  std::array<std::uint8_t, 64> frame{};
  SensorValues values;
  values[PacketId::kWall] = 1;
  const std::size_t size = layout->encode(values, frame);
  const Bytes payload(frame.begin() + 2, frame.begin() + static_cast<std::ptrdiff_t>(size) - 1);
  for (const std::size_t id_at : {0u, 3u, 5u, 7u, 9u, 11u}) {
    Bytes other = payload;
    other[id_at] = 12;
    SensorValues read;
    EXPECT_FALSE(layout->decode(other, read));
    EXPECT_EQ(read, SensorValues{});
  }
  SensorValues read;
  EXPECT_FALSE(layout->decode(ByteView{payload}.first(payload.size() - 1), read));
}

TEST(StreamLayout, ThereIsNoneOfAnUnknownPacketOrOfMoreThanALengthByteCounts) {
  EXPECT_FALSE(StreamLayout::of(Bytes{7, 59}));
  EXPECT_TRUE(StreamLayout::of(Bytes{100, 100, 100}));
  EXPECT_FALSE(StreamLayout::of(Bytes{100, 100, 100, 6}));
}

TEST(StreamLayout, DoesNotWriteIntoTooSmallASpan) {
  const auto layout = StreamLayout::of(Bytes{29, 13});
  ASSERT_TRUE(layout);
  std::array<std::uint8_t, 7> small{};
  EXPECT_EQ(layout->encode({}, small), 0u);
  EXPECT_EQ(small, (std::array<std::uint8_t, 7>{}));
}

}  // namespace
}  // namespace sensotwin::robot::oi
