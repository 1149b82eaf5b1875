// SPDX-License-Identifier: MIT
#pragma once

#include <httplib.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

#include "robot/ports/descriptor.hpp"

namespace sensotwin::robot {

/// A client's socket that cannot hold up a thread: a request arrives as a whole by a deadline and within a
/// number of bytes, however slowly it drips, and each write is taken within a time, however slowly it is
/// read. Does not own the socket.
class DeadlineStream : public httplib::Stream {
 public:
  struct Limits {
    std::chrono::milliseconds request;  ///< from accept to its last byte
    std::chrono::milliseconds write;    ///< each
    std::size_t request_bytes;          ///< request line, headers and body
  };
  /// \param stop  readable as soon as everything is to end; outlives the stream
  DeadlineStream(int socket, const Limits& limits, const Descriptor& stop);

  [[nodiscard]] bool is_readable() const override { return begin_ < end_; }
  [[nodiscard]] bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  /// All of it, or -1.
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  void set_deadline(std::chrono::milliseconds from_now);
  /// Waits until the socket is ready for `events`. \returns false past the deadline, or when all is to end
  [[nodiscard]] bool wait(short events) const;
  [[nodiscard]] bool fill();

  int socket_;
  Limits limits_;
  const Descriptor& stop_;
  Descriptor timer_;  ///< readable once the deadline is past
  std::size_t bytes_left_;
  std::array<char, 4096> buffer_{};
  std::size_t begin_{0};
  std::size_t end_{0};
};

}  // namespace sensotwin::robot
