// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "twin/serve/handle.hpp"

namespace sensotwin::twin {

/// A TCP port of a machine.
struct Endpoint {
  std::string host{"127.0.0.1"};
  std::uint16_t port{0};

  bool operator==(const Endpoint&) const = default;
};

/// "host:port", "[::1]:port" or "port" of 127.0.0.1; nothing for anything else. Hosts are not looked up here.
[[nodiscard]] std::optional<Endpoint> endpoint_from(std::string_view text);
/// As endpoint_from() takes it.
[[nodiscard]] std::string to_text(const Endpoint& endpoint);

/// Waits for clients there, without blocking. \param at  port 0: any free one; afterwards the one it is
/// \throws ServeError naming host, port and reason
[[nodiscard]] Handle listen_at(Endpoint& at);

/// Begins to connect, without waiting: the handle is writable when it is done. Nothing, with the reason in
/// errno, when it cannot even begin. \param at  an address, or "localhost"
[[nodiscard]] std::optional<Handle> begin_to_connect(const Endpoint& at);

}  // namespace sensotwin::twin
