// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "robot/base/bytes.hpp"

namespace sensotwin::robot {

/// What a descriptor could not take at once, in order, up to a bound.
class SendQueue {
 public:
  /// Chosen: 89 ms of a serial line at 115200 baud; six of the longest LLRP requests.
  static constexpr std::size_t kMost = 1024;

  /// Sends what waits, then `bytes`, as far as `fd` takes it without waiting, and keeps the rest.
  /// \returns false, sending none of `bytes`, when the rest would not fit, or when the descriptor is broken
  [[nodiscard]] bool send(int fd, ByteView bytes);
  /// Sends what waits. \returns false when the descriptor is broken
  [[nodiscard]] bool flush(int fd) { return send(fd, {}); }
  void clear() { waiting_.clear(); }
  [[nodiscard]] std::size_t size() const { return waiting_.size(); }

 private:
  Bytes waiting_;
};

}  // namespace sensotwin::robot
