// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/output_file.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::OutputFile;
using robot::part_path_of;

}  // namespace sensotwin::twin
