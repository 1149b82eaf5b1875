// SPDX-License-Identifier: MIT
#include "twin/serve/tcp.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <memory>
#include <system_error>

#include "twin/serve/serve_error.hpp"

namespace sensotwin::twin {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

/// Addresses in figures only: a name server that does not answer would hold up everything.
Addresses addresses_of(const Endpoint& endpoint, int flags) {
  addrinfo wanted{};
  wanted.ai_flags = flags | AI_NUMERICHOST | AI_NUMERICSERV;
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string host = endpoint.host == "localhost" ? "127.0.0.1" : endpoint.host;
  const std::string port = std::to_string(endpoint.port);
  if (::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found) != 0) {
    found = nullptr;
  }
  return {found, ::freeaddrinfo};
}

Handle socket_for(const addrinfo& address) {
  return Handle{::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
}

void set_option(const Handle& socket, int level, int name) {
  const int on = 1;
  ::setsockopt(socket.get(), level, name, &on, sizeof on);
}

[[nodiscard]] std::uint16_t port_of(const Handle& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                             : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace

std::optional<Endpoint> endpoint_from(std::string_view text) {
  Endpoint endpoint;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    std::string_view host = text.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) {
      host = host.substr(1, host.size() - 2);
    } else if (host.find(':') != std::string_view::npos) {
      return std::nullopt;  // an IPv6 address without brackets
    }
    endpoint.host = host;
    text.remove_prefix(colon + 1);
  }
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), endpoint.port);
  if (error != std::errc{} || stop != text.data() + text.size() || endpoint.host.empty()) {
    return std::nullopt;
  }
  return endpoint;
}

std::string to_text(const Endpoint& endpoint) {
  const bool v6 = endpoint.host.find(':') != std::string::npos;
  const std::string host = v6 ? "[" + endpoint.host + "]" : endpoint.host;
  return fmt::format("{}:{}", host, endpoint.port);
}

Handle listen_at(Endpoint& at) {
  const auto refuse = [&at](const std::string& reason) {
    throw ServeError(fmt::format("cannot listen at {}: {}", to_text(at), reason));
  };
  const Addresses addresses = addresses_of(at, AI_PASSIVE);
  if (!addresses) {
    refuse("no such address; give it in figures, for instance 0.0.0.0 for all of this machine's");
  }
  Handle socket = socket_for(*addresses);
  // A port whose last connection ended a moment ago is free.
  set_option(socket, SOL_SOCKET, SO_REUSEADDR);
  constexpr int kBacklog = 8;  // Chosen: only one is served, the others are sent away at once
  if (!socket || ::bind(socket.get(), addresses->ai_addr, addresses->ai_addrlen) != 0 ||
      ::listen(socket.get(), kBacklog) != 0) {
    refuse(std::system_category().message(errno));
  }
  at.port = port_of(socket);
  return socket;
}

std::optional<Handle> begin_to_connect(const Endpoint& at) {
  const Addresses addresses = addresses_of(at, 0);
  if (!addresses) {
    errno = EADDRNOTAVAIL;
    return std::nullopt;
  }
  Handle socket = socket_for(*addresses);
  set_option(socket, IPPROTO_TCP, TCP_NODELAY);
  if (!socket ||
      (::connect(socket.get(), addresses->ai_addr, addresses->ai_addrlen) != 0 && errno != EINPROGRESS)) {
    return std::nullopt;
  }
  return socket;
}

}  // namespace sensotwin::twin
