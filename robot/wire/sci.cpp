// SPDX-License-Identifier: MIT
#include "robot/wire/sci.hpp"

namespace sensotwin::robot::sci {

Result<std::size_t, oi::PacketError> encode_sensors(std::uint8_t code, const oi::SensorValues& values,
                                                    std::span<std::uint8_t> into) {
  if (code > kLastGroup) {
    return Unexpected{oi::PacketError::kUnknownPacket};
  }
  return oi::encode_packet(code, values, into);
}

Result<std::size_t, oi::PacketError> decode_sensors(std::uint8_t code, ByteView from,
                                                    oi::SensorValues& into) {
  if (code > kLastGroup) {
    return Unexpected{oi::PacketError::kUnknownPacket};
  }
  return oi::decode_packet(code, from, into);
}

}  // namespace sensotwin::robot::sci
