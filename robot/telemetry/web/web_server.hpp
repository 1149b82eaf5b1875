// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "robot/telemetry/web/site.hpp"
#include "robot/telemetry/web/web_address.hpp"

namespace sensotwin::robot {

struct WebServerOptions {
  WebAddress address{};
  /// A page that takes no writes takes no bodies. The map tracer's pictures need more.
  std::size_t body_bytes{0};
  /// Request line and headers. Chosen: what servers usually take.
  std::size_t header_bytes{16 * 1024};
  /// Chosen: a hundred browsers look at a monitor and each may ask for a page besides.
  std::size_t connections{160};
  std::size_t streams{120};
  std::chrono::milliseconds request_time{std::chrono::seconds{10}};  ///< chosen: slow networks, not attackers
  std::chrono::milliseconds write_time{std::chrono::seconds{20}};  ///< chosen: a phone that lost its network
  /// A stream without news says so this often, and so learns that its client went away. Chosen.
  std::chrono::milliseconds heartbeat{std::chrono::seconds{5}};
};

/// Serves a site over HTTP/1.1, one request a connection, in threads of its own that run at low priority.
/// Nothing of it ever runs in the caller's thread.
class WebServer {
 public:
  /// Binds and begins to serve. When bound to anything but loopback it asks for a token of its own making.
  /// \throws WebError: the address cannot be had
  WebServer(Site site, const WebServerOptions& options);
  /// Streams send what there is to be sent, for half a second at most; then all connections are ended and the
  /// threads waited for.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  [[nodiscard]] const WebAddress& address() const;
  /// What a browser opens, with the token where one is asked for. An address of all interfaces (0.0.0.0) is
  /// named as it is: put this machine's name there.
  [[nodiscard]] std::string url() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sensotwin::robot
