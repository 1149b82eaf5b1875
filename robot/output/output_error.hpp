// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "robot/output/exit_codes.hpp"

namespace sensotwin::robot {

/// A file or folder of a run could not be written. Thrown by everything in this folder; its text names the
/// file and the system's reason, in one line.
class OutputError : public std::runtime_error {
 public:
  OutputError(ExitCode exit_code, const std::string& what)
      : std::runtime_error(what), exit_code_(exit_code) {}
  /// kCannotCreate, or kIoError once something had been written.
  [[nodiscard]] ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

}  // namespace sensotwin::robot
