// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/text_file.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::read_text_file;

}  // namespace sensotwin::twin
