// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "robot/base/bytes.hpp"
#include "twin/serve/handle.hpp"

namespace sensotwin::twin {

/// A serial port whose other end is this process: Linux's pseudo-terminal, with a symbolic link that stays
/// the same from start to start.
///
/// The twin keeps no end of its own open on the client's side, so that it sees clients come and go. While
/// nobody has it open, the port is raw and at the device's speed, so that even a client that sets nothing
/// gets bytes and no echo; what one client has left unread, the next does not find.
class PseudoTerminal {
 public:
  /// \param link  replaced when it is a symbolic link already  \param baud  that clients find set
  /// \throws ServeError
  PseudoTerminal(const std::filesystem::path& link, int baud);
  /// Removes the link.
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Where clients open it: absolute.
  [[nodiscard]] const std::filesystem::path& link() const { return link_; }
  /// /dev/pts/N
  [[nodiscard]] const std::string& device() const { return device_; }
  [[nodiscard]] int descriptor() const { return master_.get(); }

  [[nodiscard]] bool has_client() const;
  /// What clients wrote, without waiting. \returns bytes moved
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> into);
  /// \returns how many the kernel took, at once; 0 when it is full
  [[nodiscard]] std::size_t write(robot::ByteView bytes);
  /// After the last client has left: its unread bytes are lost, its settings undone.
  void renew();
  /// The speed the client has set; nothing for one without a name.
  [[nodiscard]] std::optional<int> client_baud() const;
  /// Bytes written that the client has not read yet; nothing when that cannot be told.
  [[nodiscard]] std::optional<std::size_t> unread() const;

 private:
  std::filesystem::path link_;
  int baud_;
  Handle master_;
  std::string device_;
};

}  // namespace sensotwin::twin
