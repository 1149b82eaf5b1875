// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::robot {

/// The name that `given` was most likely meant to be, as " (did you mean 'run'?)", or nothing when none is
/// near: more than a third of the letters would have to change (chosen: 'rnu' finds 'run', 'fly' finds
/// nothing). Swapped neighbours count as one change. The first of equally near names wins.
[[nodiscard]] std::string did_you_mean(std::string_view given, const std::vector<std::string>& names);

}  // namespace sensotwin::robot
