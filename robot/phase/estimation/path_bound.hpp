// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/phase/estimation/ceiling_estimator.hpp"

namespace sensotwin::robot {

/// A path, the tags over it, and what is read on the way. Frame: any; the robot is told none of it.
struct PathBoundTask {
  PhaseReaderModel reader;
  WheelModel wheels;
  double height_sigma_m{0.03};  ///< of what the robot is told of the tags' heights
  std::vector<Eigen::Vector3d> tags_m;
  std::vector<std::size_t> route;  ///< indices of tags, in the order of passing
  Pose2 X_WR_start;
  double speed_mps{0.2};
  double turn_radps{2.0};  ///< on the spot at corners
  double rate_hz{20.0};    ///< rounds of all ports; or of one port after another if slot_s > 0
  double slot_s{0.0};
  int tags_ahead{2};  ///< of the destination, and behind the last, whose reads are used
  int tags_behind{2};
};

struct PathBound {
  double rms_m{0.0};              ///< over all legs but the first, which comes from the start
  std::vector<double> leg_rms_m;  ///< of each leg; the first: zero
};

/// Posterior Cramer-Rao bound of the robot's error beside the line between the tags (algorithms study, A.6):
/// the root mean square, over the path and as time passes, of the standard deviation that no unbiased
/// estimator that uses these reads and the encoders can go below. Nothing is known of the tags' places and
/// phases before (one sigma of 30 m, 100 rad).
///
/// Computed by the information recursion along the ideal path: JointFilter at the true state, all innovations
/// zero. A bound for estimating, not for driving: a robot that cannot turn on the spot is off its path by
/// more.
///
/// \pre the route is not empty, no leg but the first has length zero
[[nodiscard]] PathBound posterior_bound(const PathBoundTask& task);

}  // namespace sensotwin::robot
