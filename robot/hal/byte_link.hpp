// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/base/bytes.hpp"

namespace sensotwin::robot {

/// Bytes to and from one device: serial port, TCP socket or emulated device. The only seam between drivers
/// and the rest; whoever implements it may sit at the other end of a cable or of an array.
class ByteLink {
 public:
  virtual ~ByteLink() = default;
  /// Queues all of `bytes`, in order, without waiting. \returns false when the link is down (nothing queued).
  [[nodiscard]] bool write(ByteView bytes) { return do_write(bytes); }
  /// Moves what has arrived into `into`, without waiting. \returns number of bytes moved, 0 when none.
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> into) { return do_read(into); }
  /// False once the peer is known to be gone; a later true means that it came back.
  [[nodiscard]] bool is_up() const { return do_is_up(); }

 private:
  virtual bool do_write(ByteView bytes) = 0;
  virtual std::size_t do_read(std::span<std::uint8_t> into) = 0;
  [[nodiscard]] virtual bool do_is_up() const { return true; }
};

}  // namespace sensotwin::robot
