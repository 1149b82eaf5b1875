// SPDX-License-Identifier: MIT
#include "robot/cli/help_formatter.hpp"

#include <fmt/format.h>

#include "robot/output/exit_codes.hpp"

namespace sensotwin::robot {

HelpFormatter::HelpFormatter() {
  column_width(30);
  label("Positionals", "Operands");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) {
    return make_expanded(app);
  }
  std::string text = fmt::format("{}: {}\n", name, app->get_description());
  if (!app->get_footer().empty()) {
    text += "\nExamples:\n";
    for (const std::string& line : CLI::detail::split(app->get_footer(), '\n')) {
      text += fmt::format("  {}\n", line);
    }
  }
  text += "\n" + make_usage(app, name);
  text += make_positionals(app);
  text += make_groups(app, mode);
  if (app->get_parent() != nullptr) {
    text += make_groups(app->get_parent(), CLI::AppFormatMode::Sub);
    return text;
  }
  text += make_subcommands(app, mode);
  text += "\nExit codes:\n";
  for (const auto& [code, meaning] : kExitCodeMeanings) {
    text += fmt::format("  {:<4} {}\n", as_int(code), meaning);
  }
  return text;
}

}  // namespace sensotwin::robot
