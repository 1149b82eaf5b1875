// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/random.hpp"
#include "twin/serve/handle.hpp"
#include "twin/serve/tcp.hpp"

/// Clients of the served wires, as other programs are: by what the operating system offers.
namespace sensotwin::twin {

/// Does `step` again and again until `done`, some two seconds at most: the kernel hands bytes on when it
/// likes. \returns whether it was done in time
[[nodiscard]] inline bool eventually(const std::function<bool()>& done, const std::function<void()>& step) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (!done()) {
    if (std::chrono::steady_clock::now() > limit) {
      return false;
    }
    step();
    ::poll(nullptr, 0, 1);
  }
  return true;
}

/// What has come to `descriptor`, after at most `wait_ms` for its first byte.
[[nodiscard]] inline robot::Bytes heard_at(int descriptor, int wait_ms = 0) {
  robot::Bytes all;
  pollfd end{.fd = descriptor, .events = POLLIN, .revents = 0};
  std::array<std::uint8_t, 65536> chunk{};
  while (::poll(&end, 1, all.empty() ? wait_ms : 0) == 1 && (end.revents & POLLIN) != 0) {
    const ssize_t size = ::read(descriptor, chunk.data(), chunk.size());
    if (size <= 0) {
      break;
    }
    all.insert(all.end(), chunk.begin(), chunk.begin() + size);
  }
  return all;
}

/// A program that has a serial port open.
class PortClient {
 public:
  /// \param speed  B115200 and the like; 0: sets nothing
  explicit PortClient(const std::filesystem::path& port, speed_t speed = 0)
      : end_(::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    EXPECT_TRUE(end_) << port;
    if (speed != 0) {
      termios settings{};
      ::tcgetattr(end_.get(), &settings);
      ::cfmakeraw(&settings);
      ::cfsetispeed(&settings, speed);
      ::cfsetospeed(&settings, speed);
      ::tcsetattr(end_.get(), TCSANOW, &settings);
    }
  }
  /// \returns how many the kernel took
  std::size_t say(const robot::Bytes& bytes) const {
    const ssize_t size = ::write(end_.get(), bytes.data(), bytes.size());
    return size < 0 ? 0 : static_cast<std::size_t>(size);
  }
  [[nodiscard]] robot::Bytes hear(int wait_ms = 0) const { return heard_at(end_.get(), wait_ms); }
  [[nodiscard]] int descriptor() const { return end_.get(); }

 private:
  Handle end_;
};

/// A program that has connected to a TCP port.
class TcpClient {
 public:
  explicit TcpClient(const Endpoint& at) : socket_(std::move(*begin_to_connect(at))) {}
  std::size_t say(robot::ByteView bytes) const {
    const ssize_t size = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return size < 0 ? 0 : static_cast<std::size_t>(size);
  }
  [[nodiscard]] robot::Bytes hear(int wait_ms = 0) const { return heard_at(socket_.get(), wait_ms); }
  /// The other side has ended the connection, and all it said has been heard.
  [[nodiscard]] bool is_over() const {
    std::uint8_t byte = 0;
    return ::recv(socket_.get(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  }
  [[nodiscard]] int descriptor() const { return socket_.get(); }

 private:
  Handle socket_;
};

/// Bytes without a meaning, always the same.
[[nodiscard]] inline robot::Bytes noise(std::size_t size) {
  robot::RandomStream random{20261122};
  robot::Bytes bytes(size);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(random.below(256));
  }
  return bytes;
}

}  // namespace sensotwin::twin
