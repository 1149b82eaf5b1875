// SPDX-License-Identifier: MIT
#pragma once

namespace sensotwin::robot {

/// Speeds of the two wheels over the floor, positive forward.
struct WheelSpeeds {
  double left_mps{0.0};
  double right_mps{0.0};
  bool operator==(const WheelSpeeds&) const = default;
};

}  // namespace sensotwin::robot
