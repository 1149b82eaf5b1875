// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "robot/wire/oi_packets.hpp"

/// The layout of all packets, and the two inner loops that every sensor byte passes through; shared by the
/// packet and the stream codec so that a frame costs no call and no Result for each of its packets.
namespace sensotwin::robot::oi::detail {

inline constexpr PacketInfo kBit{1, false, 0, 1};
inline constexpr PacketInfo kByte{1, false, 0, 255};
inline constexpr PacketInfo kSignal{2, false, 0, 4095};
inline constexpr PacketInfo kSpeed{2, true, -500, 500};
inline constexpr PacketInfo kSigned16{2, true, -32768, 32767};
inline constexpr PacketInfo kUnsigned16{2, false, 0, 65535};
inline constexpr PacketInfo kNothing{1, false, 0, 0};

inline constexpr std::array<PacketInfo, 256> kPackets = [] {
  std::array<PacketInfo, 256> table{};
  constexpr std::array<PacketInfo, kLastPacket - kFirstPacket + 1> packets{{
      {1, false, 0, 15},  // 7 bumps and wheel drops
      kBit,
      kBit,
      kBit,
      kBit,
      kBit,
      kBit,               // 8 wall, 9..12 cliffs, 13 virtual wall
      {1, false, 0, 31},  // 14 overcurrents
      kByte,
      kNothing,
      kByte,
      kByte,  // 15 dirt, 16 unused, 17 infrared, 18 buttons
      kSigned16,
      kSigned16,         // 19 distance, 20 angle
      {1, false, 0, 5},  // 21 charging state
      kUnsigned16,
      kSigned16,             // 22 voltage, 23 current
      {1, true, -128, 127},  // 24 temperature
      kUnsigned16,
      kUnsigned16,          // 25 charge, 26 capacity
      {2, false, 0, 1023},  // 27 wall signal
      kSignal,
      kSignal,
      kSignal,
      kSignal,  // 28..31 cliff signals
      kNothing,
      {2, false, 0, 0},  // 32, 33 unused
      {1, false, 0, 3},
      {1, false, 0, 3},  // 34 charging sources, 35 mode
      {1, false, 0, 15},
      kBit,                // 36 song number, 37 song playing
      {1, false, 0, 108},  // 38 stream packets
      kSpeed,
      kSigned16,
      kSpeed,
      kSpeed,  // 39..42 requested velocity, radius, right, left
      kSigned16,
      kSigned16,           // 43, 44 encoder counts
      {1, false, 0, 127},  // 45 light bumper
      kSignal,
      kSignal,
      kSignal,
      kSignal,
      kSignal,
      kSignal,  // 46..51 light bump signals
      kByte,
      kByte,  // 52, 53 infrared left, right
      kSigned16,
      kSigned16,
      kSigned16,
      kSigned16,         // 54..57 motor currents
      {1, false, 0, 3},  // 58 stasis
  }};
  for (std::size_t i = 0; i < packets.size(); ++i) {
    table[kFirstPacket + i] = packets[i];
  }
  return table;
}();

inline constexpr std::array<PacketRun, 256> kRuns = [] {
  std::array<PacketRun, 256> table{};
  for (std::uint8_t id = kFirstPacket; id <= kLastPacket; ++id) {
    table[id] = {id, id, 0};
  }
  table[0] = {7, 26, 0};
  table[1] = {7, 16, 0};
  table[2] = {17, 20, 0};
  table[3] = {21, 26, 0};
  table[4] = {27, 34, 0};
  table[5] = {35, 42, 0};
  table[6] = {7, 42, 0};
  table[100] = {7, 58, 0};
  table[101] = {43, 58, 0};
  table[106] = {46, 51, 0};
  table[107] = {54, 58, 0};
  for (PacketRun& run : table) {
    for (std::size_t id = run.first; run.last != 0 && id <= run.last; ++id) {
      run.size = static_cast<std::uint8_t>(run.size + kPackets[id].size);
    }
  }
  return table;
}();

// Sizes that the manual prints (page 37).
static_assert(kRuns[0].size == 26 && kRuns[1].size == 10 && kRuns[2].size == 6 && kRuns[3].size == 10);
static_assert(kRuns[4].size == 14 && kRuns[5].size == 12 && kRuns[6].size == 52 && kRuns[100].size == 80);
static_assert(kRuns[101].size == 28 && kRuns[106].size == 12 && kRuns[107].size == 9);

/// Writes the data bytes of `run`. \pre `out` has run.size bytes. \returns one past the last byte
[[nodiscard]] inline std::uint8_t* write_run(PacketRun run, const SensorValues& values, std::uint8_t* out) {
  for (unsigned packet = run.first; packet <= run.last; ++packet) {
    const auto bits = static_cast<std::uint16_t>(values[static_cast<PacketId>(packet)]);
    if (kPackets[packet].size == 2) {
      *out++ = high_byte(bits);
    }
    *out++ = low_byte(bits);
  }
  return out;
}

/// Reads the data bytes of `run`. \pre `in` has run.size bytes. \returns one past the last byte
[[nodiscard]] inline const std::uint8_t* read_run(PacketRun run, const std::uint8_t* in, SensorValues& into) {
  for (unsigned packet = run.first; packet <= run.last; ++packet) {
    const PacketInfo& info = kPackets[packet];
    std::int32_t value = *in++;
    if (info.size == 2) {
      value = (value << 8) | *in++;
      value = info.is_signed ? static_cast<std::int16_t>(value) : value;
    } else if (info.is_signed) {
      value = (value ^ 0x80) - 0x80;  // the sign of 8 bits carried on
    }
    into[static_cast<PacketId>(packet)] = value;
  }
  return in;
}

}  // namespace sensotwin::robot::oi::detail
