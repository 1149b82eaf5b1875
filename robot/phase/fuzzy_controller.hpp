// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robot/base/geometry.hpp"
#include "robot/phase/membership.hpp"

namespace sensotwin::robot {

/// Sets of the paper's Figure 5, which gives no numbers ("not to scale"). Turn rates are counter-clockwise
/// positive; the paper's output is the heading step of one control period, dtheta = rate * Ts, and a rate
/// does not change its meaning when the reader gets faster.
struct FuzzySets {
  /// Of the phase difference.
  Trapezoid negative_rad;
  Trapezoid zero_rad;
  Trapezoid positive_rad;
  /// Of the turn rate.
  Trapezoid clockwise_radps;
  Trapezoid straight_radps;
  Trapezoid counter_clockwise_radps;
  bool operator==(const FuzzySets&) const = default;
};

/// The two numbers that matter (algorithms study, A.0): zero = tri(-z, 0, z), positive a ramp from 0 to z and
/// full beyond, outputs tri(-2, -1, 0), tri(-1, 0, 1), tri(0, 1, 2) times w.
[[nodiscard]] constexpr FuzzySets fuzzy_sets(double z_rad, double w_radps) {
  return {.negative_rad = {-kPi, -kPi, -z_rad, 0.0},
          .zero_rad = triangle(-z_rad, 0.0, z_rad),
          .positive_rad = {0.0, z_rad, kPi, kPi},
          .clockwise_radps = triangle(-2.0 * w_radps, -w_radps, 0.0),
          .straight_radps = triangle(-w_radps, 0.0, w_radps),
          .counter_clockwise_radps = triangle(0.0, w_radps, 2.0 * w_radps)};
}

/// Preset P3 of the algorithms study, A.2: reproduces the paper's figures (with floor tags read within 1.5
/// cm).
inline constexpr FuzzySets kReproductionSets = fuzzy_sets(1.0, 1.1);
/// A.3: the same controller with the Roomba's full turn rate.
inline constexpr FuzzySets kTunedSets = fuzzy_sets(1.0, 2.5);

/// What is wrong with these sets, in words a person can act on; none: nothing. Output sets may not have
/// vertical edges: their union must be continuous.
[[nodiscard]] std::optional<std::string> problem_of(const FuzzySets& sets);

/// The paper's fuzzy logic controller (section IV.B): Mamdani, one input, one output, three rules,
///
///     if dphi is Neg   then CCW
///     if dphi is Zero  then Zero
///     if dphi is Pos   then CW
///
/// "min" for implication, "max" for the union, centre of area
///
///     w = integral(y mu(y) dy) / integral(mu(y) dy),   mu = max over rules of min(degree of rule, set of
///     rule).
///
/// mu is a chain of straight pieces, so both integrals are exact sums over its corners; nothing is sampled.
/// See phase_angle.hpp for the sign of dphi.
class FuzzyController {
 public:
  /// \pre no problem_of(sets)
  explicit FuzzyController(const FuzzySets& sets);

  /// Turn rate, counter-clockwise positive. A phase difference beyond the outermost sets counts as their end;
  /// one that no set contains asks for no turn. Never fails.
  [[nodiscard]] double turn_rate_radps(double phase_difference_rad) const;
  /// Equation 3's dtheta for one control period.
  [[nodiscard]] double heading_step_rad(double phase_difference_rad, double period_s) const {
    return turn_rate_radps(phase_difference_rad) * period_s;
  }
  /// Degrees to which the rules CW, Zero, CCW hold.
  [[nodiscard]] std::array<double, 3> degrees(double phase_difference_rad) const;
  [[nodiscard]] const FuzzySets& sets() const { return sets_; }

 private:
  FuzzySets sets_;
};

}  // namespace sensotwin::robot
