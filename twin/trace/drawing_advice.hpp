// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/settings/hallway_file.hpp"

namespace sensotwin::twin {

/// What is doubtful in a map that the reader takes, told by where its places were drawn: hallways that do not
/// run along their compass point or bearing, that are drawn much longer or shorter than said, that cross
/// where no place is, places on top of each other, places that nothing leads to from the first one, tags
/// farther off than their hallway is long, arrivals without a tag. The map may be right all the same: it
/// needs no metres.
[[nodiscard]] std::vector<robot::HallwayMapProblem> advice_on(const robot::HallwayFile& hallways);

}  // namespace sensotwin::twin
