// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/time.hpp"

namespace sensotwin::robot {

/// The machine's clock as the robot's time: the only place in robot/ that reads one. Counts from its
/// construction.
class MonotonicClock {
 public:
  /// \param rate  robot's seconds in a second of the machine: 1, or that of a twin that is served faster.
  /// \pre rate > 0
  explicit MonotonicClock(double rate = 1.0);

  [[nodiscard]] Instant now() const;
  /// Waits; returns early when a signal comes, at once when `wake` has passed.
  void wait_until(Instant wake) const;

 private:
  double rate_;
  std::int64_t begin_ns_;
};

}  // namespace sensotwin::robot
