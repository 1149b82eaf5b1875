// SPDX-License-Identifier: MIT
#include "robot/sensobot/commands.hpp"

namespace sensotwin::robot {

ExitCode check_command(const CheckCommandOptions&, const SensobotEnvironment&) {
  return ExitCode::kDone;
}

}  // namespace sensotwin::robot
