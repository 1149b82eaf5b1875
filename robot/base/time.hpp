// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace sensotwin::robot {

/// Time since the program's start. A clock type without now(): nobody can read it behind another's back;
/// time enters every function as an argument, from the twin's loop or from the machine's main().
struct RobotClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<RobotClock>;
  static constexpr bool is_steady = true;  // NOLINT(readability-identifier-naming): the standard's name
};

using Instant = RobotClock::time_point;
using Duration = RobotClock::duration;

/// One Open Interface sensor update: "Roomba updates these values internally every 15 ms" (Create 2 Open
/// Interface, 2016, page 21). The control period of everything in robot/.
inline constexpr Duration kTick = std::chrono::milliseconds{15};

[[nodiscard]] constexpr double to_s(Duration d) {
  return std::chrono::duration<double>(d).count();
}
[[nodiscard]] constexpr double to_s(Instant t) {
  return to_s(t.time_since_epoch());
}
/// Nearest nanosecond. \pre |seconds| < 9e9
[[nodiscard]] constexpr Duration from_s(double seconds) {
  return Duration{static_cast<std::int64_t>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5))};
}

}  // namespace sensotwin::robot
