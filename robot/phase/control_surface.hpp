// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/phase/fuzzy_controller.hpp"

namespace sensotwin::robot {

/// The paper's Figure 5 and what follows from it, as points to draw: taken from the controller that steers,
/// not from a formula beside it.
struct ControlSurface {
  struct Input {
    double phase_difference_rad;
    double negative, zero, positive;  ///< degrees of the input sets
    double turn_rate_radps;           ///< what the controller answers
  };
  struct Output {
    double turn_rate_radps;
    double clockwise, straight, counter_clockwise;  ///< degrees of the output sets
  };
  std::vector<Input> inputs;    ///< evenly over (-pi, pi], or as far as the input sets reach
  std::vector<Output> outputs;  ///< evenly over what the output sets cover
};

/// \param points  of each list. \pre points >= 2
[[nodiscard]] ControlSurface control_surface(const FuzzyController& controller, int points);

}  // namespace sensotwin::robot
