// SPDX-License-Identifier: MIT
#include "robot/ports/tcp_port.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

namespace sensotwin::robot {

struct TcpPort::Target {
  sockaddr_storage address{};
  socklen_t size{0};
};

namespace {

/// Chosen: a peer that vanished is probed this often within the silent time-out.
constexpr int kProbes = 3;

int seconds_of(Duration duration) {
  return static_cast<int>(std::chrono::ceil<std::chrono::seconds>(duration).count());
}

void set_option(int fd, int level, int name, int value) {
  // A kernel without the option detects a dead peer later; the LLRP driver's keepalives do it too.
  (void)::setsockopt(fd, level, name, &value, sizeof value);
}

void watch_peer(int fd, Duration silent_timeout) {
  const auto silent_ms = std::chrono::duration_cast<std::chrono::milliseconds>(silent_timeout).count();
  const int probe_s = std::max(1, seconds_of(silent_timeout / kProbes));
  set_option(fd, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(fd, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(fd, IPPROTO_TCP, TCP_KEEPIDLE, probe_s);
  set_option(fd, IPPROTO_TCP, TCP_KEEPINTVL, probe_s);
  set_option(fd, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
  set_option(fd, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(silent_ms));
}

}  // namespace

std::optional<TcpAddress> tcp_address(const std::string& text) {
  TcpAddress address;
  std::size_t host_end = text.size();
  const std::size_t colon = text.rfind(':');
  const bool bracketed = text.starts_with('[');
  const std::size_t bracket = text.find(']');
  if (bracketed && bracket == std::string::npos) {
    return std::nullopt;
  }
  // An address of IPv6 without brackets has several colons and no port.
  if (colon != std::string::npos && (bracketed ? colon == bracket + 1 : text.find(':') == colon)) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, address.port);
    if (error != std::errc{} || rest != end || address.port == 0) {
      return std::nullopt;
    }
    host_end = colon;
  }
  address.host = bracketed ? text.substr(1, bracket - 1) : text.substr(0, host_end);
  if (address.host.empty() || (bracketed && bracket + 1 != host_end)) {
    return std::nullopt;
  }
  return address;
}

TcpPort::TcpPort(TcpPortConfig config)
    : config_(std::move(config)),
      name_(config_.address.host + ":" + std::to_string(config_.address.port)),
      back_off_(config_.first_retry, config_.last_retry) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(config_.address.host.c_str(), std::to_string(config_.address.port).c_str(),
                                  &hints, &found);
  if (error != 0) {
    trouble_ = "cannot find '" + config_.address.host + "': " + ::gai_strerror(error);
    return;
  }
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    Target target;
    std::memcpy(&target.address, each->ai_addr, each->ai_addrlen);
    target.size = each->ai_addrlen;
    targets_.push_back(target);
  }
  ::freeaddrinfo(found);
}

TcpPort::~TcpPort() = default;

void TcpPort::do_keep(Instant now) {
  if (connected_) {
    if (!queue_.flush(descriptor_.get())) {
      lose(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
    }
  } else if (descriptor_) {
    look_whether_connected(now);
  } else if (!targets_.empty() && back_off_.is_due(now)) {
    begin(now);
  }
}

void TcpPort::begin(Instant now) {
  const Target& target = targets_[next_target_];
  next_target_ = (next_target_ + 1) % targets_.size();
  descriptor_ = Descriptor{::socket(target.address.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  if (!descriptor_) {
    give_up(now, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
    return;
  }
  watch_peer(descriptor_.get(), config_.silent_timeout);
  connect_by_ = now + config_.connect_timeout;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the sockets' own way
  const auto* const address = reinterpret_cast<const sockaddr*>(&target.address);
  if (::connect(descriptor_.get(), address, target.size) != 0 && errno != EINPROGRESS) {
    give_up(now, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
    return;
  }
  look_whether_connected(now);
}

void TcpPort::look_whether_connected(Instant now) {
  pollfd state{descriptor_.get(), POLLOUT, 0};
  if (::poll(&state, 1, 0) == 0) {
    if (now >= connect_by_) {
      give_up(now, "no answer");
    }
    return;
  }
  int error = 0;
  socklen_t size = sizeof error;
  (void)::getsockopt(descriptor_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) {
    give_up(now, std::strerror(error));  // NOLINT(concurrency-mt-unsafe): read at once
    return;
  }
  connected_ = true;
  queue_.clear();
  trouble_.clear();
  back_off_.succeeded();
  ++health_.opened;
}

void TcpPort::give_up(Instant now, const std::string& why) {
  trouble_ = "cannot connect to " + name_ + ": " + why;
  descriptor_.close();
  back_off_.failed(now);
}

void TcpPort::lose(const std::string& why) {
  trouble_ = "lost " + name_ + ": " + why;
  descriptor_.close();
  queue_.clear();
  connected_ = false;
  ++health_.lost;
}

bool TcpPort::do_write(ByteView bytes) {
  if (!connected_ || !queue_.send(descriptor_.get(), bytes)) {
    ++health_.writes_refused;
    return false;
  }
  health_.bytes_written += bytes.size();
  return true;
}

std::size_t TcpPort::do_read(std::span<std::uint8_t> into) {
  if (!connected_ || into.empty()) {
    return 0;
  }
  const ssize_t got = ::recv(descriptor_.get(), into.data(), into.size(), MSG_DONTWAIT);
  if (got > 0) {
    health_.bytes_read += static_cast<std::uint64_t>(got);
    return static_cast<std::size_t>(got);
  }
  if (got == 0) {
    lose("closed by the peer");
  } else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    lose(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe): read at once
  }
  return 0;
}

}  // namespace sensotwin::robot
