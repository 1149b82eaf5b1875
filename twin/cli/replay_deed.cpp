// SPDX-License-Identifier: MIT
#include <ostream>

#include "robot/config/problem.hpp"
#include "robot/replay/journal_file.hpp"
#include "robot/replay/journal_replay.hpp"
#include "twin/cli/deeds.hpp"

namespace sensotwin::twin {

robot::ExitCode replay_deed(const ReplayOptions& options, Context& context) {
  try {
    const robot::Journal journal = robot::journal_in(options.journal);
    const robot::ReplayOutcome outcome = robot::replay(journal, options.journal);
    context.out << robot::report_of(outcome, journal, context.json);
    return outcome.difference ? robot::ExitCode::kNotAccepted : robot::ExitCode::kDone;
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  }
}

}  // namespace sensotwin::twin
