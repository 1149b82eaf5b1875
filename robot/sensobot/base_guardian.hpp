// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/time.hpp"
#include "robot/ports/guardian.hpp"
#include "robot/ports/monotonic_clock.hpp"

namespace sensotwin::robot {

/// Forks the process that stops a Roomba when this one cannot. No other thread may run yet.
/// \throws OutputError  kInternal: the system gives no process
[[nodiscard]] Guardian begin_base_guardian();

/// Waits, and tells the guardian that the program lives. It counts seconds of the machine: behind a twin in
/// slow motion a step of the robot takes longer than its patience. \param rate  of `clock`
/// \returns false when the guardian is gone
[[nodiscard]] bool wait_beating(const MonotonicClock& clock, double rate, Instant wake, Guardian& guardian);

}  // namespace sensotwin::robot
