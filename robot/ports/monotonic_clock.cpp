// SPDX-License-Identifier: MIT
#include "robot/ports/monotonic_clock.hpp"

#include <cassert>
#include <ctime>

namespace sensotwin::robot {
namespace {

constexpr std::int64_t kNsInSecond = 1'000'000'000;

std::int64_t machine_ns() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<std::int64_t>(time.tv_sec) * kNsInSecond + time.tv_nsec;
}

}  // namespace

MonotonicClock::MonotonicClock(double rate) : rate_(rate), begin_ns_(machine_ns()) {
  assert(rate > 0.0);
}

Instant MonotonicClock::now() const {
  const std::int64_t since_ns = machine_ns() - begin_ns_;
  return Instant{
      Duration{rate_ == 1.0 ? since_ns : static_cast<std::int64_t>(static_cast<double>(since_ns) * rate_)}};
}

void MonotonicClock::wait_until(Instant wake) const {
  const auto since_ns =
      static_cast<std::int64_t>(static_cast<double>(wake.time_since_epoch().count()) / rate_);
  const std::int64_t at_ns = begin_ns_ + since_ns;
  const timespec at{static_cast<time_t>(at_ns / kNsInSecond), static_cast<long>(at_ns % kNsInSecond)};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
}

}  // namespace sensotwin::robot
