// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/ports/back_off.hpp"
#include "robot/ports/descriptor.hpp"
#include "robot/ports/port.hpp"
#include "robot/ports/send_queue.hpp"

namespace sensotwin::robot {

/// "host:port", "[::1]:5084", or a host alone.
struct TcpAddress {
  std::string host;
  std::uint16_t port{5084};  ///< LLRP's own (IANA)
};
/// Nothing when `text` is no such thing.
[[nodiscard]] std::optional<TcpAddress> tcp_address(const std::string& text);

struct TcpPortConfig {
  TcpAddress address;
  /// A reader in the same network answers in milliseconds; one that boots, not at all. Chosen.
  Duration connect_timeout{std::chrono::seconds{3}};
  /// A peer that acknowledges nothing for so long is gone (TCP_USER_TIMEOUT; silence is probed twice as
  /// often). Chosen: two keepalives of the LLRP driver and some.
  Duration silent_timeout{std::chrono::seconds{5}};
  /// Chosen: what the LLRP driver waits between two set-ups.
  Duration first_retry{std::chrono::milliseconds{500}};
  Duration last_retry{std::chrono::seconds{8}};
};

/// A TCP connection that is made again when it breaks. Names are looked up once, by the constructor, which
/// may wait for it; everything after that does not wait.
class TcpPort : public Port {
 public:
  explicit TcpPort(TcpPortConfig config);
  ~TcpPort() override;
  TcpPort(const TcpPort&) = delete;
  TcpPort& operator=(const TcpPort&) = delete;

 private:
  struct Target;  ///< one address of the host

  bool do_write(ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;
  [[nodiscard]] bool do_is_up() const override { return connected_; }
  void do_keep(Instant now) override;
  void begin(Instant now);
  void look_whether_connected(Instant now);
  void give_up(Instant now, const std::string& why);
  void lose(const std::string& why);

  TcpPortConfig config_;
  std::string name_;
  std::vector<Target> targets_;
  std::size_t next_target_{0};
  BackOff back_off_;
  Descriptor descriptor_;
  bool connected_{false};
  Instant connect_by_;
  SendQueue queue_;
};

}  // namespace sensotwin::robot
