// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "robot/base/time.hpp"

namespace sensotwin::robot {

/// Maps a reader's UTC time stamps onto the robot's clock.
///
/// A stamp u that arrives at a shows that the clocks differ by a - u, less the delay of the report, which is
/// never negative. So the smallest a - u seen is the best estimate, wrong by the delay of the least delayed
/// report (a control period, 15 ms, at most while reports come often), and no stamp it maps lies after its
/// arrival. The smallest is taken over the last 10 to 20 s only, so that it follows two quartzes that drift
/// apart: 50 ppm make 1 ms in 20 s. A stamp that would map further back than any report is delayed shows that
/// the reader's clock was set back; the estimate starts anew then. Mapped stamps may step back a little when
/// a better estimate comes: they are not forced into order.
class ReaderClock {
 public:
  /// A stamp has arrived. \param now  never earlier than before
  void learn(std::uint64_t reader_utc_us, Instant now);
  /// \pre learn() was called
  [[nodiscard]] Instant at(std::uint64_t reader_utc_us) const;
  [[nodiscard]] bool is_set() const { return window_start_.has_value(); }
  /// How often the reader's clock was seen to be set back.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }

 private:
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();

  std::optional<Instant> window_start_;
  std::int64_t current_ns_{kNone};   ///< smallest difference in the window under way
  std::int64_t previous_ns_{kNone};  ///< and in the one before
  std::uint32_t restarts_{0};
};

}  // namespace sensotwin::robot
