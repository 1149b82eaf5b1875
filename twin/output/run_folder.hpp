// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/run_folder.hpp"
#include "twin/output/output_file.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::default_run_folder;
using robot::default_validation_folder;
using robot::Existing;
using robot::RunFolder;

}  // namespace sensotwin::twin
