// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// The six infrared beams in the bumper: where each looks, and how far away the thing is that answers.
struct LightBumper {
  /// Direction of each beam in R, left to right.
  std::array<double, 6> yaw_R_rad{rad_from_deg(65),  rad_from_deg(38),  rad_from_deg(14),
                                  rad_from_deg(-14), rad_from_deg(-38), rad_from_deg(-65)};
  double shell_radius_m{0.17};
  /// signal = full * (near / (near + range))^2: intensity of a diffuse surface, saturating at contact.
  double full_signal{4095.0};
  double near_m{0.05};
  /// Farther than this a beam is not believed: surfaces differ too much.
  double trusted_range_m{0.20};

  /// \returns range from the shell, or nothing when nothing near answers.
  [[nodiscard]] std::optional<double> range_m(std::uint16_t signal) const {
    if (signal == 0) {
      return std::nullopt;
    }
    const double range = near_m * (std::sqrt(full_signal / signal) - 1.0);
    return range <= trusted_range_m ? std::optional{range} : std::nullopt;
  }
};

}  // namespace sensotwin::robot
