// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/base/random.hpp"
#include "world/description.hpp"

namespace sensotwin::world {

/// What a compass on the robot shows.
///
///   heading = north - yaw + sum_i peak_i exp(-(d_i / radius_i)^2) + noise,  rounded to the resolution
///
/// heading clockwise from magnetic north as on a card, rad in [0, 2 pi); north and yaw counter-clockwise in
/// W, rad; d_i the distance of the robot from the i-th piece of iron, m; noise Gaussian, drawn anew for each
/// reading. Leaves out: iron that turns with the robot, tilt, the motors' own field, lag. Source: the
/// Gaussian shape is chosen, for a local distortion that fades within a metre.
class CompassField {
 public:
  CompassField(const WorldDescription& world, const CompassDescription& compass,
               const robot::RandomStream& random);
  /// Without noise and rounding, rad in [0, 2 pi).
  [[nodiscard]] double field_heading_rad(const Pose2& X_WR) const;
  /// One reading, rad in [0, 2 pi). Draws one number.
  [[nodiscard]] double read_heading_rad(const Pose2& X_WR);

 private:
  double north_yaw_rad_;
  std::vector<CompassDistortion> distortions_;
  CompassDescription compass_;
  robot::RandomStream noise_;
};

}  // namespace sensotwin::world
