// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sensotwin::robot {

/// Where pages are served.
struct WebAddress {
  std::string host{"127.0.0.1"};
  std::uint16_t port{0};  ///< 0: any free one

  bool operator==(const WebAddress&) const = default;
};

/// "host:port", "[::1]:port", "host", ":port" or "port", of 127.0.0.1 when no host is named; nothing for
/// anything else. Hosts are addresses in figures, or localhost.
[[nodiscard]] std::optional<WebAddress> web_address(std::string_view text);
/// For command lines: what is wrong with an address, in words; empty where nothing is, or where none is
/// given.
[[nodiscard]] std::string complaint_about_web_address(const std::string& text);
/// Only programs of this machine reach it.
[[nodiscard]] bool is_loopback(std::string_view host);
/// "127.0.0.1:8080", "[::1]:8080"
[[nodiscard]] std::string to_text(const WebAddress& address);

}  // namespace sensotwin::robot
