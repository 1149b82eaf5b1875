// SPDX-License-Identifier: MIT
#include "robot/sensobot/application.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "robot/cli/help_formatter.hpp"
#include "robot/config/problem.hpp"
#include "robot/output/output_error.hpp"
#include "robot/telemetry/web/web_address.hpp"
#include "robot/telemetry/web/web_error.hpp"

namespace sensotwin::robot {
namespace {

constexpr double kLongest_s = 1e6;  ///< chosen: eleven days

template <class Options>
void add_robot_options(CLI::App& app, Options& options) {
  app.add_option("robot", options.robot, "Robot file (YAML)")->required()->option_text("ROBOT.yaml");
  app.add_option_function<std::string>(
         "--devices", [&options](const std::string& file) { options.devices = file; },
         "Take the section devices: from here; twin serve writes such a file")
      ->option_text("FILE");
  app.add_option_function<std::string>(
         "--calibration", [&options](const std::string& file) { options.calibration = file; },
         "Lay what sensobot calibrate measured over the robot file")
      ->option_text("FILE");
}

void add_run(CLI::App& app, RunCommandOptions& options) {
  add_robot_options(app, options);
  app.add_option_function<std::string>(
         "--out", [&options](const std::string& folder) { options.out = folder; },
         "Folder of the run (default runs/<robot>-<time>)")
      ->option_text("DIR");
  app.add_flag("--force", options.force, "Replace the files of a run in that folder");
  app.add_option_function<std::string>(
         "--journal", [&options](const std::string& file) { options.journal = file; },
         "Write all bytes of all wires here (default DIR/journal)")
      ->option_text("FILE");
  app.add_flag("--no-journal", options.no_journal, "Write no journal");
  app.add_option_function<std::vector<std::string>>(
         "--monitor",
         [&options](const std::vector<std::string>& given) {
           options.monitor = given.empty() ? "" : given.front();
         },
         "Serve a page that draws what happens (127.0.0.1:8420, else any free port); a token is asked for "
         "when it is reached from other machines")
      ->option_text("[HOST:PORT]")
      ->expected(0, 1)
      ->check(complaint_about_web_address);
  app.add_option("--rate", options.rate, "Seconds of the robot in one of the clock: the --rtf of twin serve")
      ->option_text("X")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_option("--wait", options.wait_s, "Seconds until every device has to be there (10)")
      ->option_text("S")
      ->check(CLI::Range(0.0, kLongest_s));
  app.add_option("--patience", options.patience_s, "Seconds to wait for a device that went away (60)")
      ->option_text("S")
      ->check(CLI::Range(0.0, kLongest_s));
  app.add_flag("--json", options.json, "summary.json on stdout too");
  app.add_flag("-q,--quiet", options.quiet, "Say only what went wrong");
}

void add_check(CLI::App& app, CheckCommandOptions& options) {
  add_robot_options(app, options);
  app.add_option("--seconds", options.seconds, "How long to listen to each device (2)")
      ->option_text("S")
      ->check(CLI::Range(0.5, 600.0));
  app.add_flag("--json", options.json, "What was found as JSON on stdout");
}

void add_calibrate(CLI::App& app, CalibrateCommandOptions& options) {
  add_robot_options(app, options);
  app.add_option("--turns", options.plan.turns, "Turns each way round, by the compass; 0: none (5)")
      ->option_text("N")
      ->check(CLI::Range(0, 100));
  app.add_option("--laps", options.plan.laps, "Laps each way round a square of floor tags; 0: none (3)")
      ->option_text("N")
      ->check(CLI::Range(0, 30));
  app.add_option("--side", options.plan.side, "Of that square, in tiles (2)")
      ->option_text("N")
      ->check(CLI::Range(1, 20));
  app.add_option("--speed", options.plan.speed_mps, "On the square, m/s (0.15)")
      ->option_text("V")
      ->check(CLI::Range(0.03, 0.4));
  app.add_option("--spins", options.plan.spins,
                 "Turns under a ceiling tag at each of four spots, for the UHF antennas (0)")
      ->option_text("N")
      ->check(CLI::Range(0, 50));
  app.add_option("--tag", options.plan.tag, "That tag's name (the file's first)")->option_text("NAME");
  app.add_option_function<std::string>(
         "--out", [&options](const std::string& file) { options.out = file; },
         "Write what was measured here, for --calibration (default: stdout)")
      ->option_text("FILE");
  app.add_option("--rate", options.rate, "Seconds of the robot in one of the clock: the --rtf of twin serve")
      ->option_text("X")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_flag("--json", options.json, "The figures as JSON on stdout");
}

/// Every command with its options, and what it does.
struct Commands {
  RunCommandOptions run;
  CheckCommandOptions check;
  CalibrateCommandOptions calibrate;
  MonitorCommandOptions monitor;
  ReplayCommandOptions replay;
  ShowCommandOptions show;

  void set_up(CLI::App& app) {
    CLI::App* sub = app.add_subcommand("run", "run the robot's mission on its real devices");
    sub->footer(
        "sensobot run robot.yaml\n"
        "sensobot run robot.yaml --out runs/kitchen --patience 20\n"
        "sensobot run robot.yaml --monitor 0.0.0.0:8420    # seen from a phone, with the token that is "
        "printed\n"
        "sensobot run robot.yaml --devices served/devices.yaml --rate 4    # behind twin serve --rtf 4");
    add_run(*sub, run);
    sub = app.add_subcommand("check", "test every device, moving nothing, and print what was found");
    sub->footer("sensobot check robot.yaml\nsensobot check robot.yaml --json | jq .devices");
    add_check(*sub, check);
    sub = app.add_subcommand(
        "calibrate",
        "measure wheels and antennas by driving over floor tags and turning under a ceiling tag");
    sub->footer(
        "sensobot calibrate robot.yaml --out measured.yaml             # over a corner of 3 by 3 floor tags\n"
        "sensobot calibrate robot.yaml --laps 0                        # the wheel base alone, anywhere\n"
        "sensobot calibrate robot.yaml --turns 0 --laps 0 --spins 4    # under a ceiling tag");
    add_calibrate(*sub, calibrate);
    sub = app.add_subcommand("monitor", "show several robots on one page: those whose monitors are named");
    sub->footer(
        "sensobot monitor http://192.168.1.7:8420/?token=... http://192.168.1.8:8420/?token=...\n"
        "sensobot monitor --at 0.0.0.0:8421 http://127.0.0.1:8420/");
    sub->add_option("url", monitor.urls, "Address of a monitor, as its program printed it")
        ->required()
        ->option_text("URL...");
    sub->add_option("--at", monitor.at, "Where to serve the page (127.0.0.1:8420, else any free port)")
        ->option_text("HOST:PORT")
        ->check(complaint_about_web_address);
    sub = app.add_subcommand("replay", "run the program of a journal again and compare its commands");
    sub->footer("sensobot replay runs/kitchen/journal");
    sub->add_option("journal", replay.journal, "What sensobot run or twin run --journal wrote")
        ->required()
        ->option_text("JOURNAL");
    sub->add_flag("--json", replay.json, "The outcome as JSON on stdout");
    sub = app.add_subcommand("show", "print a robot file with all defaults");
    sub->footer("sensobot show robot.yaml");
    add_robot_options(*sub, show);
  }

  ExitCode obey(const std::string& command, const SensobotEnvironment& environment) const {
    if (command == "run") {
      return run_command(run, environment);
    }
    if (command == "check") {
      return check_command(check, environment);
    }
    if (command == "calibrate") {
      return calibrate_command(calibrate, environment);
    }
    if (command == "monitor") {
      return monitor_command(monitor, environment);
    }
    return command == "replay" ? replay_command(replay, environment) : show_command(show, environment);
  }
};

ExitCode obey_guarded(const Commands& commands, const std::string& command,
                      const SensobotEnvironment& environment) {
  try {
    return commands.obey(command, environment);
  } catch (const LoadError& error) {
    environment.err << error.what() << '\n';
    return static_cast<ExitCode>(error.exit_code());
  } catch (const OutputError& error) {
    environment.err << "error: " << error.what() << '\n';
    return error.exit_code();
  } catch (const WebError& error) {
    environment.err << "error: " << error.what() << '\n';
    return ExitCode::kUnavailable;
  } catch (const std::exception& error) {
    environment.err << "error: internal: " << error.what() << '\n';
    return ExitCode::kInternal;
  }
}

/// Results that did not reach stdout (a full disk behind '>') are no success.
ExitCode checked_stdout(ExitCode code, const SensobotEnvironment& environment) {
  environment.out.flush();
  if (environment.out.good()) {
    return code;
  }
  environment.err << "error: cannot write to standard output\n";
  return ExitCode::kIoError;
}

}  // namespace

ExitCode run_sensobot(const std::vector<std::string>& arguments, const SensobotEnvironment& environment) {
  CLI::App app{"drives a Roomba that maps and navigates by RFID", "sensobot"};
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(0, 1);
  app.footer("sensobot check robot.yaml\nsensobot run robot.yaml");
  bool version = false;
  app.add_flag("--version", version, "Print the version");
  Commands commands;
  commands.set_up(app);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp& help) {
    (void)app.exit(help, environment.out, environment.err);
    return checked_stdout(ExitCode::kDone, environment);
  } catch (const CLI::ParseError& error) {
    environment.err << "error: " << error.what() << "\n'sensobot --help' shows how it is used\n";
    return ExitCode::kWrongCommandLine;
  }
  if (version) {
    environment.out << "sensobot " << SENSOTWIN_VERSION << '\n';
    return checked_stdout(ExitCode::kDone, environment);
  }
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) {
    environment.err << "error: a command is missing\n'sensobot --help' shows how it is used\n";
    return ExitCode::kWrongCommandLine;
  }
  return checked_stdout(obey_guarded(commands, chosen.front()->get_name(), environment), environment);
}

}  // namespace sensotwin::robot
