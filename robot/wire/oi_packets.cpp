// SPDX-License-Identifier: MIT
#include "robot/wire/oi_packets.hpp"

#include "robot/wire/oi_packet_tables.hpp"

namespace sensotwin::robot::oi {

const PacketInfo& packet_info(std::uint8_t id) {
  return detail::kPackets[id];
}

const PacketRun& packet_run(std::uint8_t id) {
  return detail::kRuns[id];
}

Result<std::size_t, PacketError> encode_packet(std::uint8_t id, const SensorValues& values,
                                               std::span<std::uint8_t> into) {
  const PacketRun run = packet_run(id);
  if (run.size == 0) {
    return Unexpected{PacketError::kUnknownPacket};
  }
  if (into.size() < run.size) {
    return Unexpected{PacketError::kNoRoom};
  }
  static_cast<void>(detail::write_run(run, values, into.data()));
  return std::size_t{run.size};
}

Result<std::size_t, PacketError> decode_packet(std::uint8_t id, ByteView from, SensorValues& into) {
  const PacketRun run = packet_run(id);
  if (run.size == 0) {
    return Unexpected{PacketError::kUnknownPacket};
  }
  if (from.size() < run.size) {
    return Unexpected{PacketError::kTooShort};
  }
  static_cast<void>(detail::read_run(run, from.data(), into));
  return std::size_t{run.size};
}

}  // namespace sensotwin::robot::oi
