// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/wire/oi_packets.hpp"
#include "robot/wire/oi_stream.hpp"

namespace sensotwin::robot::oi {

/// Where each packet of one request lies in its frames: settled once for a stream that then brings 67 frames
/// a second. Says and reads the same bytes as encode_frame() and decode_payload(), in a third of their time.
class StreamLayout {
 public:
  /// Of `ids` in that order; groups are followed by all their packets.
  /// \returns nothing when an id is unknown, or when the payload does not fit into one length byte
  [[nodiscard]] static std::optional<StreamLayout> of(ByteView ids);

  [[nodiscard]] std::size_t payload_bytes() const { return payload_bytes_; }
  /// Writes one frame. \returns its bytes, or 0 when it does not fit
  [[nodiscard]] std::size_t encode(const SensorValues& values, std::span<std::uint8_t> into) const;
  /// Reads the payload of a verified frame. \returns false, storing nothing, when it is not that of this
  /// request
  [[nodiscard]] bool decode(ByteView payload, SensorValues& into) const;

 private:
  static constexpr std::size_t kMostBytes = 255;
  /// Rounded up to words, so that ids are compared eight bytes at a time.
  static constexpr std::size_t kWordBytes = 8;
  static constexpr std::size_t kPaddedBytes = (kMostBytes / kWordBytes + 1) * kWordBytes;
  struct Place {
    PacketId packet{};
    std::uint8_t at{0};         ///< of its first data byte in the payload
    std::uint16_t sign_bit{0};  ///< of a signed packet
  };

  StreamLayout() = default;
  void add(PacketId packet);

  std::size_t payload_bytes_{0};
  std::size_t words_count_{0};
  std::size_t bytes_count_{0};
  std::array<Place, kMostBytes> words_{};          ///< packets of two bytes
  std::array<Place, kMostBytes> bytes_{};          ///< packets of one
  std::array<std::uint8_t, kPaddedBytes> ids_{};   ///< a payload with nothing but its ids
  std::array<std::uint8_t, kPaddedBytes> mask_{};  ///< FF where an id is
};

}  // namespace sensotwin::robot::oi
