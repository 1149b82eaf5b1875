// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/map_export.hpp"
#include "twin/output/run_folder.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::GridCell;
using robot::map_yaml_text;
using robot::OccupancyGrid;
using robot::pgm_text;
using robot::write_map;

}  // namespace sensotwin::twin
