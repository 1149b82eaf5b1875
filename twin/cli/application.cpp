// SPDX-License-Identifier: MIT
#include "twin/cli/application.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>

#include "robot/cli/help_formatter.hpp"
#include "robot/config/nearest_name.hpp"
#include "robot/output/output_error.hpp"
#include "twin/cli/version.hpp"

namespace sensotwin::twin {
namespace {

constexpr const char* kRed = "\x1b[31m";
constexpr const char* kYellow = "\x1b[33m";
constexpr const char* kPlain = "\x1b[0m";

struct GlobalOptions {
  bool version{false};
  bool json{false};
  bool quiet{false};
  bool verbose{false};
  bool no_color{false};
  std::string color{"auto"};
};

void add_global_options(CLI::App& app, GlobalOptions& options) {
  app.set_help_flag("-h,--help", "Print this help");
  app.add_flag("--version", options.version, "Print the version; with --json also those of the libraries");
  app.add_flag("--json", options.json, "Results as JSON on stdout");
  auto* quiet = app.add_flag("-q,--quiet", options.quiet, "Say only what went wrong");
  quiet->option_text(" ");
  app.add_flag("-v,--verbose", options.verbose, "Say more")->excludes(quiet)->option_text(" ");
  app.add_option("--color", options.color, "Colour on stderr; NO_COLOR in the environment means never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->option_text("auto|always|never");
  app.add_flag("--no-color", options.no_color, "The same as --color never");
  for (CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    option->group("Global options");
  }
}

bool color_wanted(const GlobalOptions& options, const Environment& environment) {
  if (options.no_color || options.color == "never") {
    return false;
  }
  return options.color == "always" || (environment.err_is_terminal && !environment.no_color);
}

/// Before the command line is understood, what it says of colour is not known either.
void complain(const Environment& environment, bool color, std::string_view what) {
  environment.err << (color ? kRed : "") << "error:" << (color ? kPlain : "") << ' ' << what << '\n';
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

/// Names a word that nobody knows, which says more than what CLI11 finds missing because of it.
std::optional<std::string> unknown_word(const CLI::App& app, const std::vector<Command>& commands) {
  const auto chosen = app.get_subcommands();
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) {
    return std::nullopt;
  }
  const std::string word = words.front().substr(0, words.front().find('='));
  if (word.starts_with("-")) {
    std::vector<std::string> names = option_names(app);
    if (!chosen.empty()) {
      const auto own = option_names(*chosen.front());
      names.insert(names.begin(), own.begin(), own.end());
    }
    return "unknown option '" + word + "'" + robot::did_you_mean(word, names);
  }
  if (chosen.empty()) {
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const Command& command : commands) {
      names.push_back(command.name);
    }
    return "unknown command '" + word + "'" + robot::did_you_mean(word, names);
  }
  return "unexpected operand '" + word + "'";
}

robot::ExitCode refuse_command_line(const CLI::App& app, const std::vector<Command>& commands,
                                    const Environment& environment, const std::string& reason) {
  const auto chosen = app.get_subcommands();
  const std::string program = "twin" + (chosen.empty() ? "" : " " + chosen.front()->get_name());
  complain(environment, environment.err_is_terminal && !environment.no_color,
           unknown_word(app, commands).value_or(reason));
  environment.err << "'" << program << " --help' shows how it is used\n";
  return robot::ExitCode::kWrongCommandLine;
}

robot::ExitCode run_guarded(const Command& command, Context& context, const Environment& environment) {
  try {
    return command.run(context);
  } catch (const robot::OutputError& error) {
    complain(environment, context.color, error.what());
    return error.exit_code();
  } catch (const CommandError& error) {
    if (error.complete()) {
      environment.err << error.what() << '\n';
    } else {
      complain(environment, context.color, error.what());
    }
    return error.exit_code();
  } catch (const std::exception& error) {
    complain(environment, context.color, std::string("internal: ") + error.what());
    return robot::ExitCode::kInternal;
  }
}

/// Results that did not reach stdout (a full disk behind '>') are no success.
robot::ExitCode checked_stdout(robot::ExitCode code, const Environment& environment) {
  environment.out.flush();
  if (environment.out.good()) {
    return code;
  }
  complain(environment, false, "cannot write to standard output");
  return robot::ExitCode::kIoError;
}

}  // namespace

void Context::say(std::string_view line) const {
  if (verbosity != Verbosity::kQuiet) {
    talk << line << '\n';
  }
}

void Context::say_more(std::string_view line) const {
  if (verbosity == Verbosity::kVerbose) {
    talk << line << '\n';
  }
}

void Context::warn(std::string_view line) const {
  talk << (color ? kYellow : "") << "warning:" << (color ? kPlain : "") << ' ' << line << '\n';
}

robot::ExitCode run_application(const std::vector<std::string>& arguments,
                                const std::vector<Command>& commands, const Environment& environment) {
  CLI::App app{"a digital twin of a Roomba that maps and navigates by RFID", "twin"};
  app.formatter(std::make_shared<robot::HelpFormatter>());
  app.fallthrough();
  app.require_subcommand(0, 1);
  app.footer("twin list scenes\ntwin doctor");
  GlobalOptions global;
  add_global_options(app, global);
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->group("Commands");
    sub->footer(command.examples);
    command.set_up(*sub);
  }
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp& help) {
    (void)app.exit(help, environment.out, environment.err);
    return checked_stdout(robot::ExitCode::kDone, environment);
  } catch (const CLI::ParseError& error) {
    return refuse_command_line(app, commands, environment, error.what());
  }
  if (global.version) {
    environment.out << (global.json ? version_json() : version_text());
    return checked_stdout(robot::ExitCode::kDone, environment);
  }
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) {
    return refuse_command_line(app, commands, environment, "a command is missing");
  }
  Context context{.out = environment.out,
                  .talk = environment.err,
                  .json = global.json,
                  .verbosity = global.quiet     ? Verbosity::kQuiet
                               : global.verbose ? Verbosity::kVerbose
                                                : Verbosity::kNormal,
                  .color = color_wanted(global, environment),
                  .progress = environment.progress,
                  .wall_s = environment.wall_s,
                  .utc = environment.utc};
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& c) { return c.name == chosen.front()->get_name(); });
  return checked_stdout(run_guarded(*command, context, environment), environment);
}

}  // namespace sensotwin::twin
