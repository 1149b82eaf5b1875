// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/nearest_name.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::did_you_mean;

}  // namespace sensotwin::twin
