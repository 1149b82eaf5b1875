// SPDX-License-Identifier: MIT
#include "twin/serve/card_wire.hpp"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <utility>

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using robot::ByteView;

constexpr std::uint8_t kTellAtr = 4;

/// Chosen: someone who starts pcscd later waits no longer.
constexpr double kRedial_s = 1.0;
/// Chosen: five of six tags come while somebody waits for them, and listing the readers stays bearable.
constexpr double kHoldAnswer_s = 1.0;
/// What pcscd may take to notice a tag. Chosen: two looks and some.
constexpr double kNoticed_s = 1.5;
/// What a client of pcscd may take to speak to a tag that pcscd has noticed. Chosen: ten of sensobot's looks,
/// two SCardConnects. Who only watches costs so much a tag.
constexpr double kSpeaks_s = 0.1;
/// When the client has only just come. Chosen: it opens its other devices too.
constexpr double kFirst_s = 1.0;
/// And to look once more, when one has gone. Chosen: sensobot looks every 7 ms.
constexpr double kLooks_s = 0.015;
/// Seven of pcscd's looks (0.4 s each) without one for us.
constexpr double kSilent_s = 3.0;
/// A message has a length of 16 bits, and we read no second one before the first is answered.
constexpr std::size_t kMessageMax = 2 + 65535;

}  // namespace

Bytes icode_sli_atr() {
  return {0x3B, 0x8F, 0x80, 0x01, 0x80, 0x4F, 0x0C, 0xA0, 0x00, 0x00,
          0x03, 0x06, 0x0B, 0x00, 0x14, 0x00, 0x00, 0x00, 0x00, 0x77};
}

CardWire::CardWire(std::string name, robot::CardLink& reader, Endpoint vpcd)
    : Wire(std::move(name)), reader_(reader), vpcd_(std::move(vpcd)) {}

void CardWire::do_watch(std::vector<pollfd>& handles) const {
  // While a tag works on a command nothing more is read: the next tick brings the answer.
  if (socket_ && !exchange_) {
    const auto events = static_cast<short>(out_.empty() ? POLLIN : POLLIN | POLLOUT);
    handles.push_back({.fd = socket_.get(), .events = events, .revents = 0});
  }
  if (left_) {
    handles.push_back({.fd = left_.get(), .events = POLLIN, .revents = 0});
  }
}

void CardWire::do_pump(double wall_s) {
  look_at_field(wall_s);
  see_whether_noticed(wall_s);
  if (!socket_ && wall_s >= dial_again_s_) {
    dial(wall_s);
  }
  if (socket_) {
    listen(wall_s);
  }
  if (asked_) {
    tell_atr(wall_s);
  }
}

void CardWire::tell_atr(double wall_s) {
  if (present_) {
    asked_ = false;
    noticed_s_ = told_in_ ? noticed_s_ : wall_s;
    told_in_ = true;
    answer(icode_sli_atr());
  } else if (wall_s - asked_s_ >= kHoldAnswer_s) {
    hang_up();
  }
}

void CardWire::look_at_field(double wall_s) {
  const bool present = reader_.presence() == robot::CardPresence::kPresent;
  if (exchange_) {
    finish_exchange();
  }
  if (present_ && !present && told_in_) {
    take_leave(wall_s);
  }
  if (present_ != present) {
    changed_s_ = wall_s;
    spoken_to_ = false;
  }
  present_ = present;
}

/// Closes one way only: vpcd sees the end when it looks, ends its side too, and so tells us that it has seen.
void CardWire::take_leave(double wall_s) {
  ::shutdown(socket_.get(), SHUT_WR);
  left_ = std::move(socket_);
  hang_up();
  dial_again_s_ = wall_s;
}

void CardWire::see_whether_noticed(double wall_s) {
  std::array<std::uint8_t, 4096> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  if (left_) {
    const ssize_t size = ::recv(left_.get(), chunk.data(), chunk.size(), 0);
    if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) {
      left_.reset();
      noticed_s_ = wall_s;
    }
  }
}

bool CardWire::is_settled(double wall_s) const {
  const bool known = present_ ? told_in_ && (spoken_to_ || wall_s - noticed_s_ > kSpeaks_s)
                              : !left_ && wall_s - noticed_s_ > kLooks_s;
  if (peer_ == Peer::kUnknown) {
    // Dialled, and pcscd has not come by yet: it will, or there is none.
    return wall_s - dialled_s_ > kSilent_s;
  }
  return known || peer_ != Peer::kServing || wall_s - changed_s_ > kNoticed_s;
}

void CardWire::await_client(double wall_s) {
  spoken_to_ = false;
  changed_s_ = wall_s;
  noticed_s_ = wall_s + kFirst_s - kSpeaks_s;
}

void CardWire::dial(double wall_s) {
  dial_again_s_ = wall_s + kRedial_s;
  dialled_s_ = wall_s;
  auto socket = begin_to_connect(vpcd_);
  if (!socket) {
    peer_ = Peer::kAbsent;
    return;
  }
  socket_ = std::move(*socket);
}

void CardWire::hang_up() {
  tally_.bytes_dropped += out_.size();
  socket_.reset();
  in_.clear();
  out_.clear();
  heard_ = told_in_ = exchange_ = asked_ = false;
}

void CardWire::listen(double wall_s) {
  std::array<std::uint8_t, 4096> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  while (socket_ && !exchange_ && in_.size() < kMessageMax) {
    const ssize_t size = ::recv(socket_.get(), chunk.data(), chunk.size(), 0);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) {
      break;
    }
    if (size <= 0) {
      // Refused, or pcscd has gone. It may be back by the next dial.
      peer_ = heard_ ? Peer::kUnknown : Peer::kAbsent;
      hang_up();
      return;
    }
    heard_ = true;
    tally_.clients += peer_ == Peer::kServing ? 0 : 1;
    peer_ = Peer::kServing;
    dial_again_s_ = wall_s;  // once it has taken us up it will again
    asked_s_ = wall_s;
    tally_.bytes_in += static_cast<std::size_t>(size);
    in_.insert(in_.end(), chunk.begin(), chunk.begin() + size);
    while (socket_ && take_message()) {
    }
  }
  if (socket_) {
    send_rest();
    if (!heard_ && wall_s - dialled_s_ > kSilent_s) {
      peer_ = Peer::kSilent;
    }
  }
}

bool CardWire::take_message() {
  if (exchange_ || in_.size() < 2) {
    return false;
  }
  const std::size_t size = robot::u16_from_be(in_[0], in_[1]);
  if (in_.size() < 2 + size) {
    return false;
  }
  const Bytes message(in_.begin() + 2, in_.begin() + 2 + static_cast<std::ptrdiff_t>(size));
  in_.erase(in_.begin(), in_.begin() + 2 + static_cast<std::ptrdiff_t>(size));
  obey(message);
  return true;
}

void CardWire::obey(ByteView message) {
  if (message.size() == 1) {
    // A tag in the field is powered, and has no state to lose: power off, power on and reset change nothing,
    // and none of them is answered.
    asked_ = asked_ || message[0] == kTellAtr;
    return;
  }
  if (message.empty()) {
    return;
  }
  if (present_ && reader_.begin(message)) {
    exchange_ = true;
    spoken_to_ = true;
  } else {
    hang_up();
  }
}

void CardWire::finish_exchange() {
  const auto outcome = reader_.poll();
  if (!outcome) {
    return;
  }
  exchange_ = false;
  if (*outcome) {
    answer(**outcome);
  } else {
    hang_up();  // pcscd reports a failed transmission, then a removed card
  }
}

void CardWire::answer(ByteView bytes) {
  out_.push_back(robot::high_byte(static_cast<std::uint16_t>(bytes.size())));
  out_.push_back(robot::low_byte(static_cast<std::uint16_t>(bytes.size())));
  out_.insert(out_.end(), bytes.begin(), bytes.end());
  send_rest();
}

void CardWire::send_rest() {
  if (out_.empty()) {
    return;
  }
  const ssize_t size = ::send(socket_.get(), out_.data(), out_.size(), MSG_NOSIGNAL);
  if (size > 0) {
    tally_.bytes_out += static_cast<std::size_t>(size);
    out_.erase(out_.begin(), out_.begin() + size);
  }
}

}  // namespace sensotwin::twin
