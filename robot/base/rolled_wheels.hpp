// SPDX-License-Identifier: MIT
#pragma once

namespace sensotwin::robot {

/// Way of each wheel over the floor.
struct RolledWheels {
  double left_m{0.0};
  double right_m{0.0};
};

/// What encoder counts say of it. Unequal wheels share the mean: factors 2 / (1 + ratio) and
/// 2 ratio / (1 + ratio), ratio = right diameter / left diameter (Borenstein and Feng 1996, eq. 5.10
/// to 5.12). Model: has metres_per_count, of the mean of both wheels, and wheel_ratio.
template <class Model>
[[nodiscard]] RolledWheels rolled_m(const Model& model, int counts_left, int counts_right) {
  if (model.wheel_ratio == 1.0) {
    return {counts_left * model.metres_per_count, counts_right * model.metres_per_count};
  }
  const double left_m = 2.0 / (1.0 + model.wheel_ratio) * model.metres_per_count;
  return {counts_left * left_m, counts_right * left_m * model.wheel_ratio};
}

}  // namespace sensotwin::robot
