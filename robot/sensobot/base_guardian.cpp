// SPDX-License-Identifier: MIT
#include "robot/sensobot/base_guardian.hpp"

#include <cstring>
#include <string>
#include <utility>

#include "robot/drivers/emergency_stop.hpp"
#include "robot/output/output_error.hpp"

namespace sensotwin::robot {

Guardian begin_base_guardian() {
  auto guardian = Guardian::begin({.stop = emergency_stop(), .farewell = emergency_farewell()});
  if (!guardian) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): read at once
    throw OutputError(ExitCode::kInternal,
                      std::string{"cannot begin the process that stops the robot when this one dies: "} +
                          std::strerror(guardian.error()));
  }
  return std::move(*guardian);
}

bool wait_beating(const MonotonicClock& clock, double rate, Instant wake, Guardian& guardian) {
  // A control step of the machine's time, four of which the guardian waits for.
  const Duration pause = from_s(to_s(kTick) * rate);
  bool lives = guardian.beat();
  for (Instant now = clock.now(); now + pause < wake && lives; now = clock.now()) {
    clock.wait_until(now + pause);
    lives = guardian.beat();
  }
  clock.wait_until(wake);
  return lives;
}

}  // namespace sensotwin::robot
