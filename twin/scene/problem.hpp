// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/problem.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::kExitInvalid;
using robot::kExitMissing;
using robot::kExitUsage;
using SceneError = robot::LoadError;
using robot::Place;
using robot::Problem;

}  // namespace sensotwin::twin
