// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "robot/output/exit_codes.hpp"
#include "robot/sensobot/commands.hpp"

namespace sensotwin::robot {

/// Parses `arguments` (without the program's name), does what they ask and says what went wrong. Throws
/// nothing.
[[nodiscard]] ExitCode run_sensobot(const std::vector<std::string>& arguments,
                                    const SensobotEnvironment& environment);

}  // namespace sensotwin::robot
