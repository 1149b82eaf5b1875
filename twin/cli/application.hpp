// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "twin/cli/command.hpp"

namespace sensotwin::twin {

/// What main knows of the process and hands down, so that a test can be another process.
struct Environment {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal{false};
  bool no_color{false};  ///< NO_COLOR is set and not empty (no-color.org)
  ProgressStyle progress{};
  std::function<double()> wall_s;
  std::function<std::string()> utc;
};

/// Parses `arguments` (without the program's name), runs the command that they name and says what went wrong.
/// Throws nothing. \returns the process's exit code
[[nodiscard]] robot::ExitCode run_application(const std::vector<std::string>& arguments,
                                              const std::vector<Command>& commands,
                                              const Environment& environment);

}  // namespace sensotwin::twin
