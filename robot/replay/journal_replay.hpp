// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "robot/journal/replay.hpp"

namespace sensotwin::robot {

/// Runs the program of a journal again, on what its wires said then.
/// \param file  for messages  \throws LoadError  the robot file in the journal is none that this version
/// reads
[[nodiscard]] ReplayOutcome replay(const Journal& journal, const std::filesystem::path& file);

/// What came of it: lines for people, or a JSON object.
[[nodiscard]] std::string report_of(const ReplayOutcome& outcome, const Journal& journal, bool json);

}  // namespace sensotwin::robot
