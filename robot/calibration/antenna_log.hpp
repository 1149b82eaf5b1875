// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/drivers/uhf_read.hpp"

namespace sensotwin::robot {

/// One read of the tag under which the robot turned, and where the robot was by its wheels then.
struct PlacedRead {
  UhfRead read;
  Pose2 X_OR;
  std::size_t spot{0};  ///< one after the other
};

}  // namespace sensotwin::robot
