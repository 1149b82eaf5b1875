// SPDX-License-Identifier: MIT
#include "twin/serve/llrp_wire.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <utility>

namespace sensotwin::twin {
namespace {

constexpr std::size_t kChunkBytes = 16384;  // Chosen: a report of some hundred tags
/// Taken in one go before the others have their turn. Chosen: decoded within a millisecond.
constexpr int kChunksAtOnce = 8;
/// How long a connection that is over waits for its peer to see it, and a client that was told the end may
/// take to read it. Chosen: on a local network a thousand round trips.
constexpr double kPatience_s = 2.0;
/// Chosen: as many as the listener's backlog.
constexpr std::size_t kLeavingMax = 8;

void set(int socket, int level, int name, int value) {
  ::setsockopt(socket, level, name, &value, sizeof value);
}

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

LlrpWire::LlrpWire(std::string name, EmulatedUhfReader& reader, Endpoint at)
    : Wire(std::move(name)), reader_(reader), endpoint_(std::move(at)), listener_(listen_at(endpoint_)) {}

LlrpWire::~LlrpWire() {
  if (client_) {
    reader_.close();
    static_cast<void>(give_to_client(last_moved_s_));
    reader_.disconnect();
  }
}

void LlrpWire::do_watch(std::vector<pollfd>& handles) const {
  handles.push_back({.fd = listener_.get(), .events = POLLIN, .revents = 0});
  if (client_) {
    const auto events = static_cast<short>(pending_.empty() ? POLLIN : POLLIN | POLLOUT);
    handles.push_back({.fd = client_.get(), .events = events, .revents = 0});
  }
  for (const Leaving& one : leaving_) {
    handles.push_back({.fd = one.socket.get(), .events = POLLIN, .revents = 0});
  }
}

void LlrpWire::do_pump(double wall_s) {
  // Who leaves is seen before who comes: a client that dials again at once finds the reader free.
  serve_client(wall_s);
  accept_all(wall_s);
  serve_client(wall_s);
  bury(wall_s);
  tally_.reports_lost = reader_.tally().reports_lost;
}

void LlrpWire::serve_client(double wall_s) {
  if (!client_) {
    return;
  }
  const bool there = take_from_client();
  // What was asked before the end of the line is answered all the same: the peer may have closed one way.
  if (!give_to_client(wall_s) || !there) {
    drop_client();
  } else if (!reader_.is_connected() && pending_.empty()) {
    let_go(std::exchange(client_, Handle{}), wall_s);
  }
}

void LlrpWire::accept_all(double wall_s) {
  for (std::size_t i = 0; i < kLeavingMax; ++i) {
    Handle socket{::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (!socket) {
      return;
    }
    ++tally_.clients;
    set(socket.get(), IPPROTO_TCP, TCP_NODELAY, 1);
    set(socket.get(), SOL_SOCKET, SO_KEEPALIVE, 1);
    if (client_) {
      if (reader_.is_connected()) {
        static_cast<void>(reader_.connect());  // it tells its client of the other one
      }
      const robot::Bytes refusal = reader_.refusal();
      ::send(socket.get(), refusal.data(), refusal.size(), MSG_NOSIGNAL);
      ++tally_.refused;
      tally_.bytes_out += refusal.size();
      let_go(std::move(socket), wall_s);
    } else if (reader_.connect()) {
      client_ = std::move(socket);
      pending_.clear();
      sent_of_pending_ = 0;
      last_moved_s_ = wall_s;
    }
  }
}

bool LlrpWire::take_from_client() {
  std::array<std::uint8_t, kChunkBytes> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (int i = 0; i < kChunksAtOnce; ++i) {
    const ssize_t size = ::recv(client_.get(), chunk.data(), chunk.size(), 0);
    if (size <= 0) {
      return size < 0 && would_block();
    }
    tally_.bytes_in += static_cast<std::size_t>(size);
    reader_.receive(robot::ByteView{chunk}.first(static_cast<std::size_t>(size)));
  }
  return true;
}

bool LlrpWire::give_to_client(double wall_s) {
  for (int i = 0; i < kChunksAtOnce; ++i) {
    if (pending_.empty()) {
      pending_.resize(kChunkBytes);
      pending_.resize(reader_.send(pending_));
      sent_of_pending_ = 0;
      if (pending_.empty()) {
        last_moved_s_ = wall_s;
        return true;
      }
    }
    const robot::ByteView rest = robot::ByteView{pending_}.subspan(sent_of_pending_);
    const ssize_t size = ::send(client_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (size < 0) {
      // Whoever is being shown the door has to take it; a client in good standing may be slow.
      return would_block() && !(reader_.is_closing() && wall_s - last_moved_s_ > kPatience_s);
    }
    last_moved_s_ = wall_s;
    tally_.bytes_out += static_cast<std::size_t>(size);
    sent_of_pending_ += static_cast<std::size_t>(size);
    if (sent_of_pending_ == pending_.size()) {
      pending_.clear();
    }
  }
  return true;
}

void LlrpWire::drop_client() {
  tally_.bytes_dropped += pending_.size() - sent_of_pending_;
  pending_.clear();
  sent_of_pending_ = 0;
  reader_.disconnect();
  client_.reset();
}

void LlrpWire::let_go(Handle socket, double wall_s) {
  ::shutdown(socket.get(), SHUT_WR);
  if (leaving_.size() == kLeavingMax) {
    leaving_.pop_front();
  }
  leaving_.push_back({std::move(socket), wall_s + kPatience_s});
}

void LlrpWire::bury(double wall_s) {
  std::array<std::uint8_t, kChunkBytes> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::erase_if(leaving_, [&](const Leaving& one) {
    const ssize_t size = ::recv(one.socket.get(), chunk.data(), chunk.size(), 0);
    return wall_s > one.until_s || size == 0 || (size < 0 && !would_block());
  });
}

}  // namespace sensotwin::twin
