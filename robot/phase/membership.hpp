// SPDX-License-Identifier: MIT
#pragma once

namespace sensotwin::robot {

/// "Linear triangular and trapezoidal membership functions" (Gueaieb & Miah, section IV.B): 0 outside the
/// feet, 1 between the shoulders, straight in between. In the unit of what is being judged.
struct Trapezoid {
  double left_foot{0.0};
  double left_shoulder{0.0};
  double right_shoulder{0.0};
  double right_foot{0.0};

  /// Degree to which x belongs to the set, 0..1. A vertical edge belongs to the set.
  [[nodiscard]] constexpr double degree(double x) const {
    if (x < left_foot || x > right_foot) {
      return 0.0;
    }
    if (x < left_shoulder) {
      return (x - left_foot) / (left_shoulder - left_foot);
    }
    if (x > right_shoulder) {
      return (right_foot - x) / (right_foot - right_shoulder);
    }
    return 1.0;
  }
  /// Feet and shoulders in order, some width.
  [[nodiscard]] constexpr bool well_formed() const {
    return left_foot <= left_shoulder && left_shoulder <= right_shoulder && right_shoulder <= right_foot &&
           left_foot < right_foot;
  }
  bool operator==(const Trapezoid&) const = default;
};

[[nodiscard]] constexpr Trapezoid triangle(double left, double peak, double right) {
  return {left, peak, peak, right};
}

}  // namespace sensotwin::robot
