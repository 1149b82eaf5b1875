// SPDX-License-Identifier: MIT
#include <ostream>

#include "robot/replay/journal_file.hpp"
#include "robot/replay/journal_replay.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/settings/robot_file.hpp"

namespace sensotwin::robot {

ExitCode replay_command(const ReplayCommandOptions& options, const SensobotEnvironment& environment) {
  const Journal journal = journal_in(options.journal);
  const ReplayOutcome outcome = replay(journal, options.journal);
  environment.out << report_of(outcome, journal, options.json);
  return outcome.difference ? ExitCode::kNotAccepted : ExitCode::kDone;
}

ExitCode show_command(const ShowCommandOptions& options, const SensobotEnvironment& environment) {
  environment.out << robot_yaml(
      read_robot_file(options.robot, options.devices, RobotFileUse::kRun, options.calibration));
  return ExitCode::kDone;
}

}  // namespace sensotwin::robot
