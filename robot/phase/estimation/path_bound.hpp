// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "robot/drivers/uhf_read.hpp"
#include "robot/phase/estimation/ceiling_estimator.hpp"
#include "robot/phase/estimation/tag_path.hpp"

namespace sensotwin::robot {

/// A read on the way, of which only who, by which port, on which frequency and how loud count.
struct BoundRead {
  std::size_t tag{0};  ///< index in PathBoundTask::tags_m
  UhfRead read;
};

/// The ideal robot's way over a moment, frame W.
struct BoundMotion {
  double begin_s{0.0};
  double end_s{0.0};
  Pose2 X_WR_begin;
  Pose2 X_WR_end;
};

/// A path, the tags over it, and what is read on the way. Frame: any; the robot is told none of it.
struct PathBoundTask {
  PhaseReaderModel reader;
  WheelModel wheels;
  double height_sigma_m{0.03};  ///< of what the robot is told of the tags' heights
  std::vector<Eigen::Vector3d> tags_m;
  std::vector<std::size_t> route;  ///< indices of tags, in the order of passing
  TagPathKind path{TagPathKind::kPolyline};
  bool circle_left{true};       ///< counter-clockwise
  double circle_radius_m{2.0};  ///< kCircleAbout
  double circle_laps{1.0};      ///< kCircleAbout
  Pose2 X_WR_start;
  double speed_mps{0.2};
  double turn_radps{2.0};  ///< on the spot at corners
  double rate_hz{20.0};    ///< rounds of all ports; or of one port after another if slot_s > 0
  double slot_s{0.0};
  int tags_ahead{2};  ///< of the destination, and behind the last, whose reads are used
  int tags_behind{2};
  /// What is read in a moment, valid until the next call; if empty, every tag in each round.
  std::function<std::span<const BoundRead>(const BoundMotion&)> hear;
};

struct PathBound {
  double rms_m{0.0};              ///< over all legs but the first, which comes from the start
  double first_half_rms_m{0.0};   ///< of these legs: the first of two laps
  double second_half_rms_m{0.0};  ///< the later one
  std::vector<double> leg_rms_m;  ///< of each leg; the first: zero
};

/// Posterior Cramer-Rao bound of the robot's error beside the path between the tags (algorithms study, A.6):
/// the root mean square, over the path and as time passes, of the standard deviation that no unbiased
/// estimator that uses these reads and the encoders can go below. Nothing is known of the tags' places and
/// phases before (one sigma of 30 m, 100 rad).
///
/// Computed by the information recursion along the ideal path: JointFilter at the true state, all innovations
/// zero. Places of a curve depend on several tags; how much on each is found by differences. A bound for
/// estimating, not for driving: a robot that cannot turn on the spot is off its path by more. The echoes'
/// part holds for echoes as PhaseNoise describes them.
///
/// \pre the route is not empty, no leg but the first has length zero; a circle through tags has three
[[nodiscard]] PathBound posterior_bound(const PathBoundTask& task);

}  // namespace sensotwin::robot
