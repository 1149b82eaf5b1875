// SPDX-License-Identifier: MIT
#include "world/compass_field.hpp"

#include <cmath>

namespace sensotwin::world {
namespace {

constexpr double kTurn_rad = 2.0 * robot::kPi;

double in_one_turn(double rad) {
  const double r = std::fmod(rad, kTurn_rad);
  return r < 0.0 ? r + kTurn_rad : r;
}

}  // namespace

CompassField::CompassField(const WorldDescription& world, const CompassDescription& compass,
                           const robot::RandomStream& random)
    : north_yaw_rad_(world.north_yaw_rad),
      distortions_(world.compass_distortions),
      compass_(compass),
      noise_(random.fork("noise")) {}

double CompassField::field_heading_rad(const Pose2& X_WR) const {
  double heading_rad = north_yaw_rad_ - X_WR.yaw_rad;
  for (const CompassDistortion& iron : distortions_) {
    const double d = (X_WR.p_m - iron.at_m).norm() / iron.radius_m;
    heading_rad += iron.peak_rad * std::exp(-d * d);
  }
  return in_one_turn(heading_rad);
}

double CompassField::read_heading_rad(const Pose2& X_WR) {
  const double heading_rad = field_heading_rad(X_WR) + compass_.noise_sigma_rad * noise_.normal();
  const double step_rad = compass_.resolution_rad;
  return in_one_turn(step_rad > 0.0 ? std::round(heading_rad / step_rad) * step_rad : heading_rad);
}

}  // namespace sensotwin::world
