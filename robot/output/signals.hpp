// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/output/exit_codes.hpp"

namespace sensotwin::robot {

/// SIGINT and SIGTERM set a flag that loops ask for; a second SIGINT ends the process at once with 130.
/// SIGPIPE ends it quietly with its own status, as a shell expects of the left side of a pipe. SIGXFSZ is
/// ignored, so that a file-size limit is an error of write() like a full disk. Call once, from main.
void install_signal_handlers();

/// The same for a program that moves a machine: SIGHUP, the terminal that went away, counts as SIGTERM, and
/// whoever reads its output may leave without ending it.
void install_machine_signal_handlers();

/// kInterrupted or kTerminated once such a signal has arrived: end in order, leave valid files.
[[nodiscard]] std::optional<ExitCode> pending_interruption();

}  // namespace sensotwin::robot
