// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "robot/base/random.hpp"
#include "world/description.hpp"

namespace sensotwin::world {

/// Velocity of the body in R: forward and left, m/s; turning, rad/s counter-clockwise.
struct BodyVelocity {
  double forward_mps{0.0};
  double left_mps{0.0};
  double turn_rps{0.0};
};
struct BodyMass {
  double mass_kg{0.0};
  double inertia_kgm2{0.0};  ///< about the vertical through the centre, which is the middle of the axle
};

/// What the floor under the robot is like at this step.
struct Footing {
  std::array<bool, 2> on_floor{true, true};  ///< left and right wheel; false over a hole
  double yaw_rad{0.0};                       ///< of the robot in W: the nap lies in W
};

/// Two driven wheels with rubber tyres on a floor, and the castor and pile that drag.
///
/// Each step of h seconds:
///
///   wheel    w <- w + clamp(target * D/D0 - w, -a h, a h)          surface speed, m/s
///            wheel angle <- wheel angle + 2 w / D * h               what the encoder counts
///   drag     v <- v - min(|v|, c g h) v/|v|;  the same for turning with the scrub moment mu N e
///   tyre     f = mu N (w (1 - s) - v_wheel) / (creep * max(|w|, |v_wheel|, v0)),  |f| <= mu N
///
/// | symbol | meaning                                                                        | unit |
/// |--------|--------------------------------------------------------------------------------|------|
/// | D, D0  | true and nominal wheel diameter; the wheel's controller knows the nominal one    | m    |
/// | a      | acceleration limit of the wheel's controller                                    | m/s2 |
/// | c      | rolling resistance of castor and pile                                           | -    |
/// | mu, N  | friction, load on one driven wheel                                              | -, N |
/// | e      | arm of the scrub moment: the contact patch turns on itself                      | m    |
/// | s      | unevenness: part of the way that the pile takes, constant over a length,        | -    |
/// |        | exponentially distributed, so never negative                                    |      |
/// | v0     | keeps the law finite at rest                                                    | m/s  |
///
/// Sideways the same law holds for both tyres together with the nap's drift as target, and the friction
/// circle joins the two directions of each tyre. The force is taken at the end of the step (implicit Euler),
/// hence stable for any step, and it never does more work than the wheels' surfaces bring in. Frames: R (see
/// BodyVelocity). Valid for a rigid robot whose weight rests evenly on both wheels. Leaves out: load transfer
/// in braking, wheel inertia, pile that remembers earlier passages. Source: creep law as in the linear range
/// of the brush model, [Pacejka2012] section 3.2; both directions together section 3.2.3; implicit friction
/// as in [Catto2009].
class Traction {
 public:
  Traction(const RoombaDescription& base, const Floor& floor, const BodyMass& body, double step_s,
           const robot::RandomStream& random);

  /// Turns the wheels for one step towards the targets (nominal surface speeds, left and right).
  void turn_wheels(const std::array<double, 2>& target_mps);
  /// Velocity of the body after one step of drag and tyre forces.
  [[nodiscard]] BodyVelocity apply(BodyVelocity v, const Footing& footing);

  /// Cumulative rotation of each wheel, positive forward.
  [[nodiscard]] const std::array<double, 2>& wheel_angle_rad() const { return angle_rad_; }
  [[nodiscard]] const std::array<double, 2>& wheel_mps() const { return wheel_mps_; }
  /// Tractive force of each tyre in the last step, along the wheel, N.
  [[nodiscard]] const std::array<double, 2>& force_N() const { return force_N_; }
  /// Work that the wheels' surfaces have done on the body since the start, J. Braking counts negative.
  [[nodiscard]] double work_J() const { return work_J_; }

 private:
  void drag(BodyVelocity& v) const;
  [[nodiscard]] std::array<double, 2> surface_mps();
  [[nodiscard]] double unevenness(std::size_t wheel);

  BodyMass body_;
  Floor floor_;
  double step_s_;
  double arm_m_;                          ///< half the true wheel base
  std::array<double, 2> diameter_ratio_;  ///< true over nominal
  std::array<double, 2> rad_per_mps_;     ///< turn of each wheel in one step at 1 m/s
  double speed_change_mps_;
  double load_N_;  ///< on one driven wheel
  // What one step of drag and tyre forces needs of the above.
  double drag_mps_;       ///< speed lost to rolling resistance
  double drag_rps_{0.0};  ///< the same of turning
  double grip_Ns_;        ///< largest impulse of one tyre
  double creep_per_Ns_;   ///< softness of a tyre for each m/s
  double inverse_step_;   ///< 1/s
  double inverse_mass_;   ///< 1/kg
  double self_{0.0};      ///< 1/kg, a wheel's impulse on the speed at that wheel
  double cross_{0.0};     ///< 1/kg, on the speed at the other
  double arm_per_inertia_{0.0};
  std::array<robot::RandomStream, 2> random_;
  std::array<double, 2> slip_{};
  std::array<double, 2> slip_left_m_{};  ///< way until the next draw
  std::array<double, 2> wheel_mps_{};
  std::array<double, 2> angle_rad_{};
  std::array<double, 2> force_N_{};
  double work_J_{0.0};
};

}  // namespace sensotwin::world
