// SPDX-License-Identifier: MIT
#pragma once

#include "robot/ports/guardian.hpp"

namespace sensotwin::robot {

/// Forks the process that stops a Roomba when this one cannot. No other thread may run yet.
/// \throws OutputError  kInternal: the system gives no process
[[nodiscard]] Guardian begin_base_guardian();

}  // namespace sensotwin::robot
