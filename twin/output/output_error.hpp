// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/output_error.hpp"
#include "twin/output/exit_codes.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::OutputError;

}  // namespace sensotwin::twin
