// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/wire/oi_packets.hpp"

/// Where the Roomba 400 differs from the Open Interface. Its commands are oi::kSerialCommandInterface; its
/// four sensor groups are laid out as the groups 0 to 3 of the later robots, with the meanings below. It
/// answers neither single packets nor its mode, and has no encoder counts. Source: iRobot Roomba Serial
/// Command Interface (SCI) Specification, 2005.
namespace sensotwin::robot::sci {

/// Bit of packet 7 besides those of the Open Interface.
inline constexpr int kWheelDropCaster = 16;
/// Bit of packet 14 besides those of the Open Interface.
inline constexpr int kOvercurrentVacuum = 2;
/// Bits of packet 18.
inline constexpr int kButtonMax = 1;
inline constexpr int kButtonClean = 2;
inline constexpr int kButtonSpot = 4;
inline constexpr int kButtonPower = 8;

inline constexpr double kWheelBase_m = 0.258;
inline constexpr int kBaud = 57600;
inline constexpr std::uint8_t kSongs = 16;

/// Codes of the Sensors command: everything (26 bytes), then its three parts (10, 6, 10).
inline constexpr std::uint8_t kAllSensors = 0;
inline constexpr std::uint8_t kLastGroup = 3;
inline constexpr std::size_t kAllSensorsBytes = 26;

/// Counter-clockwise turn of packet 20, which carries (right - left) / 2 in mm on this robot.
[[nodiscard]] constexpr double turn_rad(std::int32_t angle_mm) {
  return 2.0 * angle_mm * 1e-3 / kWheelBase_m;
}

/// \returns bytes written, kUnknownPacket for codes above 3, or kNoRoom
[[nodiscard]] Result<std::size_t, oi::PacketError> encode_sensors(std::uint8_t code,
                                                                  const oi::SensorValues& values,
                                                                  std::span<std::uint8_t> into);
/// \returns bytes consumed, kUnknownPacket for codes above 3, or kTooShort
[[nodiscard]] Result<std::size_t, oi::PacketError> decode_sensors(std::uint8_t code, ByteView from,
                                                                  oi::SensorValues& into);

}  // namespace sensotwin::robot::sci
