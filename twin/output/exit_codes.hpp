// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/exit_codes.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::as_int;
using robot::ExitCode;
using robot::ExitCodeMeaning;
using robot::kExitCodeMeanings;

}  // namespace sensotwin::twin
