// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/rolled_wheels.hpp"
#include "robot/calibration/wheel_log.hpp"
#include "robot/mapping/pose_track.hpp"

namespace sensotwin::robot {

/// What the counts of some steps make of the pose.
struct CountedWay {
  Pose2 X;  ///< of the end in the frame of the beginning
  double rolled_m{0.0};
  double turned_rad{0.0};
};

/// Steps [first, end) by these wheels.
[[nodiscard]] CountedWay counted_way(const std::vector<CountedStep>& steps, std::size_t first,
                                     std::size_t end, const OdometryModel& wheels);

/// Forward speed at the end of a step, over the last few.
[[nodiscard]] double speed_at(const std::vector<CountedStep>& steps, std::size_t step,
                              const OdometryModel& wheels);

}  // namespace sensotwin::robot
