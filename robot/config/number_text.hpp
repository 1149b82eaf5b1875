// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sensotwin::robot {

/// The fewest digits that read back as the same number. \pre finite
[[nodiscard]] std::string number_text(double value);

/// The degrees, with the fewest digits, that the reader turns into these radians (the nearest when none
/// does).
[[nodiscard]] double degrees_for(double rad);

}  // namespace sensotwin::robot
