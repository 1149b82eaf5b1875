// SPDX-License-Identifier: MIT
#include "robot/drivers/reader_clock.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace sensotwin::robot {
namespace {

constexpr Duration kWindow = std::chrono::seconds{10};
/// Chosen: longer than any report waits in a reader or a network that still works.
constexpr Duration kLongestDelay = std::chrono::seconds{10};

/// Stamps beyond what 64 bits of nanoseconds hold (year 2262) are no dates: they wrap and map anywhere, but
/// do no harm.
[[nodiscard]] std::int64_t ns_of(std::uint64_t us) {
  return static_cast<std::int64_t>(us * 1000u);
}
[[nodiscard]] std::int64_t difference(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

}  // namespace

void ReaderClock::learn(std::uint64_t reader_utc_us, Instant now) {
  const std::int64_t offset_ns = difference(now.time_since_epoch().count(), ns_of(reader_utc_us));
  if (window_start_ && now - *window_start_ >= kWindow) {
    previous_ns_ = current_ns_;
    current_ns_ = kNone;
    window_start_ = now;
  }
  const std::int64_t best = std::min(current_ns_, previous_ns_);
  if (best != kNone && difference(offset_ns, best) > kLongestDelay.count()) {
    ++restarts_;
    current_ns_ = previous_ns_ = kNone;
    window_start_.reset();
  }
  if (!window_start_) {
    window_start_ = now;
  }
  current_ns_ = std::min(current_ns_, offset_ns);
}

Instant ReaderClock::at(std::uint64_t reader_utc_us) const {
  assert(is_set());
  const auto best = static_cast<std::uint64_t>(std::min(current_ns_, previous_ns_));
  return Instant{
      Duration{static_cast<std::int64_t>(static_cast<std::uint64_t>(ns_of(reader_utc_us)) + best)}};
}

}  // namespace sensotwin::robot
