// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/web_address.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace sensotwin::robot {
namespace {

bool is_address_in_figures(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  return ::inet_pton(AF_INET, host.c_str(), bytes.data()) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), bytes.data()) == 1;
}

bool is_all_figures(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<std::uint16_t> port_from(std::string_view text) {
  std::uint16_t port = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, port);
  return is_all_figures(text) && error == std::errc{} && stop == end ? std::optional{port} : std::nullopt;
}

}  // namespace

std::optional<WebAddress> web_address(std::string_view text) {
  WebAddress address;
  std::string_view host;
  std::string_view port;
  if (text.starts_with('[')) {
    const std::size_t bracket = text.find(']');
    if (bracket == std::string_view::npos) {
      return std::nullopt;
    }
    host = text.substr(1, bracket - 1);
    const std::string_view rest = text.substr(bracket + 1);
    if (host.find(':') == std::string_view::npos || (!rest.empty() && !rest.starts_with(':'))) {
      return std::nullopt;
    }
    port = rest.empty() ? "0" : rest.substr(1);
  } else if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    host = colon == 0 ? std::string_view{address.host} : text.substr(0, colon);
    port = text.substr(colon + 1);
  } else {
    host = is_all_figures(text) ? std::string_view{address.host} : text;
    port = is_all_figures(text) ? text : "0";
  }
  const auto number = port_from(port);
  // An IPv6 address stands in brackets here: without, its last part would be taken for the port.
  const bool bare_v6 = !text.starts_with('[') && host.find(':') != std::string_view::npos;
  std::string name = host == "localhost" ? "127.0.0.1" : std::string(host);
  if (!number || bare_v6 || !is_address_in_figures(name)) {
    return std::nullopt;
  }
  address.host = std::move(name);
  address.port = *number;
  return address;
}

std::string complaint_about_web_address(const std::string& text) {
  return text.empty() || web_address(text)
             ? std::string{}
             : "'" + text +
                   "' is no address to serve a page at: host:port, :port or host, the host in figures "
                   "(0.0.0.0: all of this machine's)";
}

bool is_loopback(std::string_view host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

std::string to_text(const WebAddress& address) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return (v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace sensotwin::robot
