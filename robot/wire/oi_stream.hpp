// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/wire/oi_packets.hpp"

namespace sensotwin::robot::oi {

inline constexpr std::uint8_t kStreamHeader = 19;
/// Header, length and checksum.
inline constexpr std::size_t kStreamOverhead = 3;
/// What fits into 15 ms at 115200 baud (page 22), and what is left of it for ids and data.
inline constexpr std::size_t kMaxFrameBytes = 172;
inline constexpr std::size_t kMaxPayloadBytes = kMaxFrameBytes - kStreamOverhead;

enum class StreamError : std::uint8_t {
  kBadChecksum,    ///< a complete frame whose sum is not 0 modulo 256
  kBadLength,      ///< the announced length is not the one expected, or above what fits into 15 ms
  kUnknownPacket,  ///< the payload names a packet that does not exist
  kTooShort,       ///< the payload ends in the middle of a packet
  kNoRoom,         ///< the frame does not fit into the span, or its payload into one length byte
};

/// Sum modulo 256. \pre a thousand bytes at most
[[nodiscard]] std::uint8_t sum_of(ByteView bytes);

/// Finds stream frames in what a serial port delivers.
///
///     19 | n | n bytes of (packet id, data)... | checksum
///
/// The checksum makes the sum of all bytes of the frame, header included, zero modulo 256. After a frame that
/// fails, the hunt for the next header goes on one byte after the failed one, so that a 19 among the data
/// costs no good frame; failures inside the bytes of one that was reported already are not reported again.
/// Never allocates, never waits. Source: Create 2 Open Interface (2016), pages 21 and 22, command 148.
class StreamDecoder {
 public:
  /// \param payload_bytes  the n to accept, when the request is known: noise is then told from frames at once
  explicit StreamDecoder(std::optional<std::uint8_t> payload_bytes = std::nullopt)
      : expected_(payload_bytes) {}

  /// Room for bytes from the port, never empty after next() returned nothing; valid until the next call of
  /// any member. What was written there is made known by received(). Invalidates the last payload.
  [[nodiscard]] std::span<std::uint8_t> room();
  /// \pre count <= room().size()
  void received(std::size_t count);
  /// The next frame among the received bytes.
  /// \returns nothing when more bytes are needed, else the payload (ids and data, checksum verified; valid
  ///          until the next call of room()), or kBadChecksum, or kBadLength
  [[nodiscard]] std::optional<Result<ByteView, StreamError>> next();
  /// Bytes that belonged to no good frame, since construction.
  [[nodiscard]] std::uint64_t bytes_skipped() const { return skipped_; }
  /// Forgets what is held, as when a port was opened anew.
  void reset();

 private:
  [[nodiscard]] std::size_t held() const { return end_ - begin_; }
  [[nodiscard]] std::optional<Result<ByteView, StreamError>> reject(StreamError error,
                                                                    std::size_t frame_bytes);
  void skip(std::size_t count);

  /// Twice the longest frame (258): a whole one always fits behind the rest of another.
  static constexpr std::size_t kBufferBytes = 516;
  std::optional<std::uint8_t> expected_;
  std::array<std::uint8_t, kBufferBytes> buffer_{};
  std::size_t begin_{0};
  std::size_t end_{0};
  std::size_t rejected_end_{0};  ///< failures before this position were reported already
  std::uint64_t skipped_{0};
};

/// Reads the payload of a verified frame; ids in any order, groups followed by all their packets. \returns
/// the number of ids, kUnknownPacket or kTooShort; on an error the packets before it are stored.
[[nodiscard]] Result<std::size_t, StreamError> decode_payload(ByteView payload, SensorValues& into);

/// Writes one frame with the packets `ids`, in that order. \returns its bytes, kUnknownPacket, or kNoRoom
[[nodiscard]] Result<std::size_t, StreamError> encode_frame(ByteView ids, const SensorValues& values,
                                                            std::span<std::uint8_t> into);

/// Payload bytes n of a stream of `ids`; unknown ids count nothing.
[[nodiscard]] std::size_t payload_bytes(ByteView ids);

}  // namespace sensotwin::robot::oi
