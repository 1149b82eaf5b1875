// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"

namespace sensotwin::robot::llrp {

inline constexpr std::size_t kHeaderBytes = 10;
inline constexpr std::uint8_t kVersion = 1;
/// Reports of a reader stay below 32 KiB (protocols study, 2.1: the smallest buffer among the clients seen),
/// capabilities of a real R420 are 1.2 KiB. Chosen: twice the former.
inline constexpr std::size_t kDefaultMaxFrameBytes = 65536;

struct FrameHeader {
  std::uint8_t version{kVersion};
  std::uint16_t type{0};
  std::uint32_t id{0};
  bool operator==(const FrameHeader&) const = default;
};
struct Frame {
  FrameHeader header;
  ByteView body;
};

enum class FrameError : std::uint8_t {
  kReservedBits,  ///< the three bits before the version are not 0
  kTooShort,      ///< announced length below 10
  kTooLong,       ///< announced length above the limit
};

/// Finds messages in what a connection delivers, however it is cut.
///
///     3 bits 0, 3 bits version, 10 bits type | u32 length of all | u32 id | body
///
/// LLRP has no checksum and no start mark: after a length that cannot be, nobody knows where the next message
/// begins. A reader then closes the connection (protocols study, 2.8). Who cannot close goes on calling
/// next(): the decoder hunts, byte by byte, for the next header of version 1 with reserved bits 0, a length
/// within the limit and a type that LLRP 1.0.1 has, and reports nothing more until it finds one. Allocates
/// its buffer once. Source: LLRP 1.0.1, 16.1.
class FrameDecoder {
 public:
  explicit FrameDecoder(std::size_t max_frame_bytes = kDefaultMaxFrameBytes);

  /// Room for bytes from the link; never empty after next() returned nothing. Valid until the next call of
  /// any member; made known by received(). Invalidates the last frame.
  [[nodiscard]] std::span<std::uint8_t> room();
  /// \pre count <= room().size()
  void received(std::size_t count);
  /// The next message among the received bytes. \returns nothing when more bytes are needed, else the frame
  /// (valid until the next call of room()), or any FrameError; the hunt begins then
  [[nodiscard]] std::optional<Result<Frame, FrameError>> next();
  /// Bytes that belonged to no frame, since construction.
  [[nodiscard]] std::uint64_t bytes_skipped() const { return skipped_; }
  [[nodiscard]] bool is_hunting() const { return hunting_; }
  /// Bytes of a message that has begun and is not complete.
  [[nodiscard]] std::size_t held() const { return end_ - begin_; }
  /// Forgets what is held, as for a new connection.
  void reset();

 private:
  [[nodiscard]] std::optional<FrameError> fault_of_header() const;
  [[nodiscard]] std::size_t announced() const;
  [[nodiscard]] bool is_plausible() const;

  std::size_t max_;
  Bytes buffer_;
  std::size_t begin_{0};
  std::size_t end_{0};
  bool hunting_{false};
  std::uint64_t skipped_{0};
};

/// Whether LLRP 1.0.1 has a message of this type.
[[nodiscard]] bool is_message_type(std::uint16_t type);

}  // namespace sensotwin::robot::llrp
