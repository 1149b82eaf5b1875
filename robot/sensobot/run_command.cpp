// SPDX-License-Identifier: MIT
#include <ostream>
#include <string_view>

#include "robot/journal/journal_bytes.hpp"
#include "robot/output/run_folder.hpp"
#include "robot/output/signals.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/sensobot/robot_run.hpp"
#include "robot/settings/robot_file.hpp"

namespace sensotwin::robot {
namespace {

/// A map id that no earlier run had, as good as 32 bits allow: a hash of the time.
std::uint32_t fresh_map_id(std::string_view utc) {
  const std::uint32_t hash = check_of(Bytes(utc.begin(), utc.end()));
  return hash == 0 ? 1 : hash;
}

}  // namespace

ExitCode run_command(const RunCommandOptions& options, const SensobotEnvironment& environment) {
  RobotFile robot = read_robot_file(options.robot, options.devices, RobotFileUse::kRun, options.calibration);
  const std::string utc = environment.utc();
  if (!robot.map_id_given) {
    robot.settings.map_id = fresh_map_id(utc);
    robot.map_id_given = true;  // so that the journal's copy of the file is the one that ran
  }
  if (options.rate > 1.0) {
    // The wire to a card keeps the machine's time, not that of a twin that is served faster.
    robot.settings.floor_reader.exchange_limit_s *= options.rate;
    robot.settings.forward_reader.exchange_limit_s *= options.rate;
  }
  const std::filesystem::path path =
      options.out.value_or(std::filesystem::path{"runs"} / (options.robot.stem().string() + "-" + utc));
  RunFolder folder(path, options.force ? Existing::kReplace : Existing::kRefuse);
  RobotRunOptions run{.rate = options.rate, .wait_s = options.wait_s, .patience_s = options.patience_s};
  if (!options.no_journal) {
    run.journal = options.journal.value_or(path / "journal");
  }
  run.monitor = options.monitor;
  run.card_service = environment.card_service;
  run.interruption = pending_interruption;
  run.say = [&](std::string_view line) {
    if (!options.quiet) {
      environment.err << line << '\n' << std::flush;
    }
  };
  const RobotRunResult result = run_robot(robot, folder, run);
  run.say("results in " + path.string());
  if (options.json) {
    environment.out << result.summary_json;
  }
  return result.exit_code;
}

}  // namespace sensotwin::robot
