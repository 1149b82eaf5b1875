// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_link.hpp"

#include <algorithm>

#include "twin/devices/emulated_uhf_reader.hpp"

namespace sensotwin::twin {
namespace {

/// What a sender's buffers take while the line is silent. Chosen: more than a client says in a minute.
constexpr std::size_t kMaxWritten = 65536;

}  // namespace

void UhfLink::step(robot::Instant now) {
  if (cut_ || reader_.is_connected()) {
    dial_at_.reset();
    return;
  }
  if (!dial_at_) {
    dial_at_ = now + redial_after_;
  }
  if (*dial_at_ <= now) {
    static_cast<void>(reader_.connect());
    dial_at_.reset();
  }
}

void UhfLink::cut() {
  cut_ = true;
  injected_.clear();
  written_.clear();
  reader_.disconnect();
}

void UhfLink::set_silent(bool silent) {
  silent_ = silent;
  if (!silent_ && !written_.empty()) {
    reader_.receive(written_);
    written_.clear();
  }
}

void UhfLink::inject(robot::ByteView bytes) {
  injected_.insert(injected_.end(), bytes.begin(), bytes.end());
}

bool UhfLink::do_is_up() const {
  return !cut_ && reader_.is_connected();
}

bool UhfLink::do_write(robot::ByteView bytes) {
  if (!do_is_up()) {
    return false;
  }
  if (!silent_) {
    reader_.receive(bytes);
    return true;
  }
  if (written_.size() + bytes.size() > kMaxWritten) {
    return false;
  }
  written_.insert(written_.end(), bytes.begin(), bytes.end());
  return true;
}

std::size_t UhfLink::do_read(std::span<std::uint8_t> into) {
  if (silent_ || !do_is_up()) {
    return 0;
  }
  const std::size_t first = std::min(into.size(), injected_.size());
  std::copy_n(injected_.begin(), first, into.begin());
  injected_.erase(injected_.begin(), injected_.begin() + static_cast<std::ptrdiff_t>(first));
  std::size_t n = reader_.send(into.subspan(first));
  const std::size_t lost = std::min(lose_, n);
  std::copy(into.begin() + static_cast<std::ptrdiff_t>(first + lost),
            into.begin() + static_cast<std::ptrdiff_t>(first + n),
            into.begin() + static_cast<std::ptrdiff_t>(first));
  lose_ -= lost;
  n -= lost;
  return first + n;
}

}  // namespace sensotwin::twin
