// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/dead_reckoning.hpp"

#include <algorithm>

namespace sensotwin::robot {

void DeadReckoning::drive(Instant stamp, const WheelStep& step) {
  if (size_ == 0) {
    // Where it stood one step ago, so that reads within the first step find their place.
    ring_[newest_] = {stamp - kTick, X_OR_};
    size_ = 1;
  }
  X_OR_ = advanced(X_OR_, step);
  newest_ = (newest_ + 1) % kRemembered;
  ring_[newest_] = {stamp, X_OR_};
  size_ = std::min(size_ + 1, kRemembered);
}

Pose2 DeadReckoning::pose_at(Instant at) const {
  if (size_ == 0 || at >= back(0).stamp) {
    return X_OR_;
  }
  for (std::size_t i = 1; i < size_; ++i) {
    const Moment& before = back(i);
    if (at < before.stamp) {
      continue;
    }
    const Moment& after = back(i - 1);
    const double part = to_s(at - before.stamp) / to_s(after.stamp - before.stamp);
    return {before.X_OR.p_m + part * (after.X_OR.p_m - before.X_OR.p_m),
            wrap_angle(before.X_OR.yaw_rad + part * wrap_angle(after.X_OR.yaw_rad - before.X_OR.yaw_rad))};
  }
  return back(size_ - 1).X_OR;
}

}  // namespace sensotwin::robot
