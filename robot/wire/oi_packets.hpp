// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

/// The sensor packets of the Open Interface. Source: Create 2 Open Interface (2016), pages 23 to 32 and 37.
namespace sensotwin::robot::oi {

enum class PacketId : std::uint8_t {
  kBumpsAndWheelDrops = 7,
  kWall = 8,
  kCliffLeft = 9,
  kCliffFrontLeft = 10,
  kCliffFrontRight = 11,
  kCliffRight = 12,
  kVirtualWall = 13,
  kOvercurrents = 14,
  kDirt = 15,
  kUnused16 = 16,  ///< always 0; SCI: dirt detector right
  kInfraredOmni = 17,
  kButtons = 18,
  kDistance = 19,  ///< mm since last read in any form
  kAngle = 20,     ///< degrees since last read, counter-clockwise; SCI: (right - left) / 2 in mm
  kChargingState = 21,
  kVoltage = 22,      ///< mV
  kCurrent = 23,      ///< mA, negative when discharging
  kTemperature = 24,  ///< degrees Celsius
  kCharge = 25,       ///< mAh
  kCapacity = 26,     ///< mAh
  kWallSignal = 27,
  kCliffLeftSignal = 28,
  kCliffFrontLeftSignal = 29,
  kCliffFrontRightSignal = 30,
  kCliffRightSignal = 31,
  kUnused32 = 32,
  kUnused33 = 33,
  kChargingSources = 34,
  kMode = 35,
  kSongNumber = 36,
  kSongPlaying = 37,
  kStreamPackets = 38,
  kRequestedVelocity = 39,  ///< mm/s
  kRequestedRadius = 40,    ///< mm
  kRequestedRight = 41,     ///< mm/s
  kRequestedLeft = 42,      ///< mm/s
  kEncoderLeft = 43,        ///< counts, wrapping: Ticks
  kEncoderRight = 44,
  kLightBumper = 45,
  kLightBumpLeft = 46,
  kLightBumpFrontLeft = 47,
  kLightBumpCenterLeft = 48,
  kLightBumpCenterRight = 49,
  kLightBumpFrontRight = 50,
  kLightBumpRight = 51,
  kInfraredLeft = 52,
  kInfraredRight = 53,
  kLeftMotorCurrent = 54,       ///< mA
  kRightMotorCurrent = 55,      ///< mA
  kMainBrushMotorCurrent = 56,  ///< mA
  kSideBrushMotorCurrent = 57,  ///< mA
  kStasis = 58,
};

inline constexpr std::uint8_t kFirstPacket = 7;
inline constexpr std::uint8_t kLastPacket = 58;

/// Bits of packet 7.
inline constexpr int kBumpRight = 1;
inline constexpr int kBumpLeft = 2;
inline constexpr int kWheelDropRight = 4;
inline constexpr int kWheelDropLeft = 8;
/// Bits of packet 14.
inline constexpr int kOvercurrentSideBrush = 1;
inline constexpr int kOvercurrentMainBrush = 4;
inline constexpr int kOvercurrentRightWheel = 8;
inline constexpr int kOvercurrentLeftWheel = 16;
/// Bits of packet 34.
inline constexpr int kInternalCharger = 1;
inline constexpr int kHomeBase = 2;
/// Bits of packet 58.
inline constexpr int kForwardProgress = 1;

/// Codes of packet 21.
enum class ChargingState : std::uint8_t {
  kNotCharging,
  kReconditioning,
  kFullCharging,
  kTrickle,
  kWaiting,
  kFault,
};

/// How one packet travels. Values outside min..max are not refused: robots send them.
struct PacketInfo {
  std::uint8_t size{0};  ///< bytes; 0: there is no such packet
  bool is_signed{false};
  std::int32_t min{0};
  std::int32_t max{0};
};
/// \returns size 0 for ids that name no single packet
[[nodiscard]] const PacketInfo& packet_info(std::uint8_t id);

/// A run of packets that one id asks for (page 37): 0 to 6, 100, 101, 106, 107; 102 to 105 do not exist.
/// A single packet is a run of one.
struct PacketRun {
  std::uint8_t first{0};
  std::uint8_t last{0};
  std::uint8_t size{0};  ///< bytes; 0: nobody answers to this id
};
[[nodiscard]] const PacketRun& packet_run(std::uint8_t id);

/// The packet, or group, `id` brings `packet`.
[[nodiscard]] inline bool covers(std::uint8_t id, PacketId packet) {
  const PacketRun& run = packet_run(id);
  return run.first <= static_cast<std::uint8_t>(packet) && static_cast<std::uint8_t>(packet) <= run.last;
}

/// The value of every packet, as a number.
class SensorValues {
 public:
  [[nodiscard]] constexpr std::int32_t& operator[](PacketId id) {
    return values_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] constexpr std::int32_t operator[](PacketId id) const {
    return values_[static_cast<std::size_t>(id)];
  }
  bool operator==(const SensorValues&) const = default;

 private:
  std::array<std::int32_t, kLastPacket + 1> values_{};
};

enum class PacketError : std::uint8_t {
  kUnknownPacket,  ///< no packet or group has this id
  kTooShort,       ///< the bytes end before the packet does
  kNoRoom,         ///< the packet does not fit into the span
};

/// Writes the data bytes of a packet or group, without its id: the answer to command 142.
/// Values are cut to their 8 or 16 bits. \returns bytes written, kUnknownPacket or kNoRoom
[[nodiscard]] Result<std::size_t, PacketError> encode_packet(std::uint8_t id, const SensorValues& values,
                                                             std::span<std::uint8_t> into);
/// Reads the data bytes of a packet or group. \returns bytes consumed, kUnknownPacket or kTooShort; on an
/// error nothing is stored.
[[nodiscard]] Result<std::size_t, PacketError> decode_packet(std::uint8_t id, ByteView from,
                                                             SensorValues& into);

}  // namespace sensotwin::robot::oi
