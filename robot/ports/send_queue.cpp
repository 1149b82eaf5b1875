// SPDX-License-Identifier: MIT
#include "robot/ports/send_queue.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

namespace sensotwin::robot {
namespace {

/// Bytes taken, 0 when there is no room now; nothing when the descriptor is broken.
std::optional<std::size_t> give(int fd, ByteView bytes) {
  // A socket whose peer is gone must not raise SIGPIPE; a terminal knows no flags.
  ssize_t taken = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (taken < 0 && errno == ENOTSOCK) {
    taken = ::write(fd, bytes.data(), bytes.size());
  }
  if (taken >= 0) {
    return static_cast<std::size_t>(taken);
  }
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) {
    return 0;
  }
  return std::nullopt;
}

}  // namespace

bool SendQueue::send(int fd, ByteView bytes) {
  if (!waiting_.empty()) {
    const auto taken = give(fd, waiting_);
    if (!taken) {
      return false;
    }
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(*taken));
  }
  if (waiting_.size() + bytes.size() > kMost) {
    return false;
  }
  if (waiting_.empty() && !bytes.empty()) {
    const auto taken = give(fd, bytes);
    if (!taken) {
      return false;
    }
    bytes = bytes.subspan(*taken);
  }
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  return true;
}

}  // namespace sensotwin::robot
