// SPDX-License-Identifier: MIT
#include <ostream>

#include "robot/replay/journal_file.hpp"
#include "robot/replay/journal_replay.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/scene/problem.hpp"

namespace sensotwin::twin {

ExitCode replay_deed(const ReplayOptions& options, Context& context) {
  try {
    const robot::Journal journal = robot::journal_in(options.journal);
    const robot::ReplayOutcome outcome = robot::replay(journal, options.journal);
    context.out << robot::report_of(outcome, journal, context.json);
    return outcome.difference ? ExitCode::kNotAccepted : ExitCode::kDone;
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<ExitCode>(error.exit_code()), error.what(), true);
  }
}

}  // namespace sensotwin::twin
