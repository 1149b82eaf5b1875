// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/event_log.hpp"
#include "twin/output/output_file.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::EventField;
using robot::EventLog;

}  // namespace sensotwin::twin
