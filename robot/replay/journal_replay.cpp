// SPDX-License-Identifier: MIT
#include "robot/replay/journal_replay.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "robot/settings/robot_file.hpp"
#include "robot/settings/robot_program.hpp"

namespace sensotwin::robot {

ReplayOutcome replay(const Journal& journal, const std::filesystem::path& file) {
  const RobotFile robot = read_robot_text(journal.robot_file, file);
  ReplayWires wires;
  RobotProgram program({wires.bytes(Wire::kBase), wires.bytes(Wire::kSensors), wires.bytes(Wire::kUhfReader),
                        wires.cards(Wire::kFloorReader), wires.cards(Wire::kForwardReader)},
                       robot.settings);
  return wires.run(
      journal, [&](Instant now) { program.step(now); }, [&] { program.shut_down(); });
}

std::string report_of(const ReplayOutcome& outcome, const Journal& journal, bool json) {
  if (json) {
    nlohmann::ordered_json report{{"same", !outcome.difference},
                                  {"steps", outcome.steps},
                                  {"replayed_s", to_s(outcome.end)},
                                  {"bytes_compared", outcome.bytes_compared},
                                  {"bytes_torn", journal.bytes_torn}};
    if (outcome.difference) {
      report["difference"] = {{"t_s", to_s(outcome.difference->at)},
                              {"recorded", outcome.difference->recorded},
                              {"replayed", outcome.difference->replayed}};
    }
    return report.dump(2) + "\n";
  }
  std::string text = fmt::format("{} steps, {:.3f} s, {} bytes of commands compared\n", outcome.steps,
                                 to_s(outcome.end), outcome.bytes_compared);
  if (journal.bytes_torn > 0) {
    text += fmt::format("the last {} bytes of the file are no whole step: the run was cut off there\n",
                        journal.bytes_torn);
  }
  if (outcome.difference) {
    text += fmt::format("differs at {:.6f} s\n  recorded  {}\n  replayed  {}\n", to_s(outcome.difference->at),
                        outcome.difference->recorded, outcome.difference->replayed);
  } else {
    text += "the same, byte for byte\n";
  }
  return text;
}

}  // namespace sensotwin::robot
