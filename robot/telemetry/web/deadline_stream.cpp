// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/deadline_stream.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace sensotwin::robot {

DeadlineStream::DeadlineStream(int socket, const Limits& limits, const Descriptor& stop)
    : socket_(socket),
      limits_(limits),
      stop_(stop),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
      bytes_left_(limits.request_bytes) {
  set_deadline(limits.request);
}

void DeadlineStream::set_deadline(std::chrono::milliseconds from_now) {
  constexpr long kMillisecond_ns = 1'000'000;
  itimerspec at{};
  at.it_value.tv_sec = from_now.count() / 1000;
  at.it_value.tv_nsec = from_now.count() % 1000 * kMillisecond_ns;
  (void)::timerfd_settime(timer_.get(), 0, &at, nullptr);
}

bool DeadlineStream::wait(short events) const {
  std::array<pollfd, 3> handles{{{.fd = socket_, .events = events, .revents = 0},
                                 {.fd = timer_.get(), .events = POLLIN, .revents = 0},
                                 {.fd = stop_.get(), .events = POLLIN, .revents = 0}}};
  if (!timer_) {
    return false;  // no handles left: better no answer than a thread that waits for ever
  }
  int ready = 0;
  do {
    ready = ::poll(handles.data(), handles.size(), -1);
  } while (ready < 0 && errno == EINTR);
  return ready > 0 && handles[1].revents == 0 && handles[2].revents == 0;
}

bool DeadlineStream::is_writable() const {
  pollfd handle{.fd = socket_, .events = POLLOUT, .revents = 0};
  return ::poll(&handle, 1, 0) > 0 && (handle.revents & (POLLERR | POLLHUP)) == 0;
}

bool DeadlineStream::fill() {
  if (!wait(POLLIN)) {
    return false;
  }
  const ssize_t got = ::recv(socket_, buffer_.data(), std::min(buffer_.size(), bytes_left_), MSG_DONTWAIT);
  if (got <= 0) {
    return false;
  }
  begin_ = 0;
  end_ = static_cast<std::size_t>(got);
  bytes_left_ -= end_;
  return true;
}

ssize_t DeadlineStream::read(char* to, std::size_t size) {
  if (begin_ == end_ && (bytes_left_ == 0 || !fill())) {
    return -1;
  }
  const std::size_t count = std::min(size, end_ - begin_);
  std::memcpy(to, buffer_.data() + begin_, count);
  begin_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t DeadlineStream::write(const char* from, std::size_t size) {
  set_deadline(limits_.write);
  std::size_t done = 0;
  while (done < size) {
    if (!wait(POLLOUT)) {
      return -1;
    }
    const ssize_t sent = ::send(socket_, from + done, size - done, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && errno != EAGAIN && errno != EINTR) {
      return -1;
    }
    done += sent > 0 ? static_cast<std::size_t>(sent) : 0;
  }
  return static_cast<ssize_t>(size);
}

// Nothing is done by where a client comes from.
void DeadlineStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip.clear();
  port = 0;
}

void DeadlineStream::get_local_ip_and_port(std::string& ip, int& port) const {
  ip.clear();
  port = 0;
}

}  // namespace sensotwin::robot
