// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/number_text.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::degrees_for;
using robot::number_text;

}  // namespace sensotwin::twin
