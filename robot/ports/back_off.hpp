// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "robot/base/time.hpp"

namespace sensotwin::robot {

/// When to try again what failed: after a pause that doubles from failure to failure.
class BackOff {
 public:
  BackOff(Duration first, Duration last) : first_(first), last_(last), pause_(first) {}

  [[nodiscard]] bool is_due(Instant now) const { return !again_at_ || now >= *again_at_; }
  void failed(Instant now) {
    again_at_ = now + pause_;
    pause_ = std::min(2 * pause_, last_);
  }
  void succeeded() {
    pause_ = first_;
    again_at_.reset();
  }

 private:
  Duration first_;
  Duration last_;
  Duration pause_;
  std::optional<Instant> again_at_;
};

}  // namespace sensotwin::robot
