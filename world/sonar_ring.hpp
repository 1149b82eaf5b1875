// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robot/base/random.hpp"
#include "world/description.hpp"
#include "world/obstacles.hpp"

namespace sensotwin::world {

/// Ultrasonic rangefinders: what each hears.
///
///   range = least distance from the transducer to anything that answers within its cone, + noise
///
/// A wall answers where the sound meets it within the specular limit of its normal, and where nothing stands
/// before it; ends and corners of walls answer near by; round legs always. Rays every degree of the cone feel
/// for walls, discs and corners are exact. Leaves out: echoes by way of several walls, what lies above or
/// below the plane of the transducers, the time a reading takes (30 ms to 5 m and back), temperature. Source:
/// specular reflection of 40 kHz sound as every introduction to Polaroid sonars tells it (Leonard and
/// Durrant-Whyte, IEEE Trans. Robotics Autom. 7(3), 1991: planes and corners answer, the rest is a mirror).
class SonarRing {
 public:
  SonarRing(const SonarDescription& sonar, const robot::RandomStream& random);

  /// Ranges without noise, dropouts and cross-talk, from the transducers, m; in the order of the bearings.
  /// \param pushed  outlines of what can be pushed, in W
  [[nodiscard]] std::vector<std::optional<double>> echoes_m(const ObstacleIndex& fixed,
                                                            std::span<const Outline> pushed,
                                                            const Pose2& X_WR) const;
  /// One reading of all. Draws noise.
  [[nodiscard]] std::vector<std::optional<double>> read_m(const ObstacleIndex& fixed,
                                                          std::span<const Outline> pushed, const Pose2& X_WR);

 private:
  /// What may answer at all from where the robot is.
  [[nodiscard]] Outline within_reach(const ObstacleIndex& fixed, std::span<const Outline> pushed,
                                     const Vec2& at_m) const;
  [[nodiscard]] std::optional<double> echo_m(const Outline& around, const Vec2& from_m,
                                             double bearing_rad) const;

  SonarDescription sonar_;
  robot::RandomStream noise_;
};

}  // namespace sensotwin::world
