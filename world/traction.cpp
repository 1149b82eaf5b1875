// SPDX-License-Identifier: MIT
#include "world/traction.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::world {
namespace {

constexpr double kGravity_mps2 = 9.81;
/// Slowest speed in the creep law. Chosen: well below any commanded speed (the slowest is 28.5 mm/s, C.2).
constexpr double kCreepFloor_mps = 0.01;

/// What brings the vector (x, y) within `limit`, at most 1. The squares decide nearly always, and spare the
/// root.
double within(double x, double y, double limit) {
  constexpr double kSurely = 1.0 - 1e-12;  // more than squares and root round off
  if (x * x + y * y < kSurely * limit * limit) {
    return 1.0;
  }
  const double size = std::hypot(x, y);
  return size > limit ? limit / size : 1.0;
}

}  // namespace

Traction::Traction(const RoombaDescription& base, const Floor& floor, const BodyMass& body, double step_s,
                   const robot::RandomStream& random)
    : body_(body),
      floor_(floor),
      step_s_(step_s),
      arm_m_(0.0),
      diameter_ratio_{1.0, 1.0},
      rad_per_mps_{},
      speed_change_mps_(base.wheel_acceleration_mps2 * step_s),
      load_N_(0.5 * base.drive_wheel_load * base.mass_kg * kGravity_mps2),
      drag_mps_(floor.rolling_resistance * kGravity_mps2 * step_s),
      drag_rps_(floor.friction * 2.0 * load_N_ * floor.scrub_arm_m / body.inertia_kgm2 * step_s),
      grip_Ns_(floor.friction * load_N_ * step_s),
      creep_per_Ns_(grip_Ns_ > 0.0 ? floor.creep / grip_Ns_ : 0.0),
      inverse_step_(1.0 / step_s),
      inverse_mass_(1.0 / body.mass_kg),
      random_{random.fork("slip/left"), random.fork("slip/right")} {
  robot::RandomStream manufacture = random.fork("manufacture");
  arm_m_ = 0.5 * base.wheel_base_m * (1.0 + base.wheel_base_sigma * manufacture.normal());
  for (std::size_t i = 0; i < 2; ++i) {
    diameter_ratio_[i] = 1.0 + base.wheel_diameter_sigma * manufacture.normal();
    rad_per_mps_[i] = step_s / (0.5 * base.wheel_diameter_m * diameter_ratio_[i]);
  }
  const double arm2 = arm_m_ * arm_m_;
  self_ = inverse_mass_ + arm2 / body_.inertia_kgm2;
  cross_ = inverse_mass_ - arm2 / body_.inertia_kgm2;
  arm_per_inertia_ = arm_m_ / body_.inertia_kgm2;
}

void Traction::turn_wheels(const std::array<double, 2>& target_mps) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double change_mps = target_mps[i] * diameter_ratio_[i] - wheel_mps_[i];
    wheel_mps_[i] += std::clamp(change_mps, -speed_change_mps_, speed_change_mps_);
    angle_rad_[i] += wheel_mps_[i] * rad_per_mps_[i];
  }
}

double Traction::unevenness(std::size_t wheel) {
  if (floor_.roughness <= 0.0) {
    return 0.0;
  }
  slip_left_m_[wheel] -= std::abs(wheel_mps_[wheel]) * step_s_;
  if (slip_left_m_[wheel] <= 0.0) {
    slip_left_m_[wheel] += floor_.roughness_length_m;
    // A wheel that loses more than half its way is no longer on a floor this law is about.
    slip_[wheel] = std::min(0.5, -floor_.roughness * std::log(1.0 - random_[wheel].uniform()));
  }
  return slip_[wheel];
}

std::array<double, 2> Traction::surface_mps() {
  return {wheel_mps_[0] * (1.0 - unevenness(0)), wheel_mps_[1] * (1.0 - unevenness(1))};
}

void Traction::drag(BodyVelocity& v) const {
  const double speed_mps = std::sqrt(v.forward_mps * v.forward_mps + v.left_mps * v.left_mps);
  const double keep = speed_mps > drag_mps_ ? 1.0 - drag_mps_ / speed_mps : 0.0;
  v.forward_mps *= keep;
  v.left_mps *= keep;
  v.turn_rps -= std::clamp(v.turn_rps, -drag_rps_, drag_rps_);
}

BodyVelocity Traction::apply(BodyVelocity v, const Footing& footing) {
  drag(v);
  const std::array<double, 2> surface = surface_mps();
  // Nap: the pile leads a rolling wheel towards the way it lies, most when the robot drives across it.
  const double across = std::sin(floor_.nap_yaw_rad - footing.yaw_rad);
  const double nap_mps =
      floor_.nap_drift * across * std::abs(across) * 0.5 * (std::abs(surface[0]) + std::abs(surface[1]));

  std::array<double, 2> softness{};  // 1/kg
  std::array<double, 2> wanted_mps{};
  std::array<double, 2> limit_Ns{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double point_mps = v.forward_mps + (i == 0 ? -arm_m_ : arm_m_) * v.turn_rps;
    const double reference_mps = std::max({std::abs(surface[i]), std::abs(point_mps), kCreepFloor_mps});
    const bool grips = footing.on_floor[i] && grip_Ns_ > 0.0;
    limit_Ns[i] = grips ? grip_Ns_ : 0.0;
    // A wheel in the air has an infinitely soft contact; 1e12 keeps the arithmetic finite.
    softness[i] = grips ? creep_per_Ns_ * reference_mps : 1e12;
    wanted_mps[i] = surface[i] - point_mps;
  }
  // Both tyres lengthwise: the two by two system of their impulses. The first is solved here; it may be held
  // back by its friction, and the second then answers to what came through.
  const double a = self_ + softness[0];
  const double b = self_ + softness[1];
  std::array<double, 2> along_Ns{(b * wanted_mps[0] - cross_ * wanted_mps[1]) / (a * b - cross_ * cross_),
                                 0.0};
  const double inverse_b = 1.0 / b;
  // Sideways they give way together, s0 s1 / (s0 + s1), each by its share: the impulse is wanted / (1/m +
  // that), the share of a tyre the other's softness / (s0 + s1).
  const double sideways =
      (nap_mps - v.left_mps) / (inverse_mass_ * (softness[0] + softness[1]) + softness[0] * softness[1]);
  double across_Ns = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double share_Ns = sideways * softness[1 - i];
    if (i == 1) {
      along_Ns[1] = (wanted_mps[1] - cross_ * along_Ns[0]) * inverse_b;
    }
    const double scale = within(along_Ns[i], share_Ns, limit_Ns[i]);
    along_Ns[i] *= scale;
    across_Ns += scale * share_Ns;
    force_N_[i] = along_Ns[i] * inverse_step_;
  }
  v.forward_mps += (along_Ns[0] + along_Ns[1]) * inverse_mass_;
  v.turn_rps += arm_per_inertia_ * (along_Ns[1] - along_Ns[0]);
  v.left_mps += across_Ns * inverse_mass_;
  work_J_ += along_Ns[0] * surface[0] + along_Ns[1] * surface[1] + across_Ns * nap_mps;
  return v;
}

}  // namespace sensotwin::world
