// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "robot/output/exit_codes.hpp"
#include "robot/output/run_folder.hpp"
#include "robot/ports/card_session.hpp"
#include "robot/settings/robot_file.hpp"

namespace sensotwin::robot {

struct RobotRunOptions {
  double rate{1.0};  ///< robot's seconds in one of the machine; above 1 for a twin that is served faster
  /// All devices have to be there after this, or nothing begins. Chosen: a reader greets within two.
  double wait_s{10.0};
  /// A device that went away is waited for so long, the robot standing if it is the base.
  double patience_s{60.0};
  std::optional<std::filesystem::path> journal{};  ///< none: no journal
  CardService card_service{begin_pcsc_session};
  /// Where a page is served that draws what happens, see begin_monitor(); none: no page.
  std::optional<std::string> monitor{};
  /// Asked every step: what tells the run to stop, if anything does.
  std::function<std::optional<ExitCode>()> interruption{};
  /// A line for people.
  std::function<void(std::string_view)> say{};
};

/// How a run ended.
struct RobotRunResult {
  ExitCode exit_code{ExitCode::kDone};
  std::string summary_json;
};

/// Runs the robot file's mission on the machine, from the opening of the ports to the last stop of the
/// wheels, and leaves map.pgm and map.yaml (of a mapping mission), events.jsonl and summary.json in `folder`.
///
/// The wheels stand when it returns or throws, whatever happened, as far as anybody can still tell them to.
/// Forks (guardian.hpp): no other thread may run.
/// \throws OutputError, WebError
[[nodiscard]] RobotRunResult run_robot(const RobotFile& robot, RunFolder& folder,
                                       const RobotRunOptions& options);

}  // namespace sensotwin::robot
