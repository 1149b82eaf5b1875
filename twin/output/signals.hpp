// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/signals.hpp"
#include "twin/output/exit_codes.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::install_signal_handlers;
using robot::pending_interruption;

}  // namespace sensotwin::twin
