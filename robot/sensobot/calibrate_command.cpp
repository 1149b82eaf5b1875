// SPDX-License-Identifier: MIT
#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "robot/calibration/calibration_program.hpp"
#include "robot/calibration/calibration_report.hpp"
#include "robot/config/problem.hpp"
#include "robot/output/output_error.hpp"
#include "robot/output/output_file.hpp"
#include "robot/output/signals.hpp"
#include "robot/sensobot/base_guardian.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/sensobot/devices.hpp"

namespace sensotwin::robot {
namespace {

constexpr Duration kDevicesBy = std::chrono::seconds{10};
/// A Roomba that is not ready to drive for so long will not be. Chosen: six start-ups said.
constexpr Duration kReadyBy = std::chrono::seconds{3};
/// What is said last has left the queues by then. Chosen.
constexpr Duration kLastWords = std::chrono::milliseconds{45};
/// Steps between two lines on how far it is. Chosen: half a minute.
constexpr int kTellEvery = 2000;

/// The program of a calibration on the machine's devices.
class CalibrationRun {
 public:
  CalibrationRun(const RobotFile& robot, const CalibrateCommandOptions& options,
                 const SensobotEnvironment& environment, Guardian& guardian)
      : environment_(environment),
        guardian_(guardian),
        clock_(options.rate),
        rate_(options.rate),
        devices_(robot, environment.card_service,
                 [this](int port) { guardian_lives_ = guardian_.watch(port) && guardian_lives_; }),
        program_(devices_.links(), robot.settings, options.plan) {}
  CalibrationRun(const CalibrationRun&) = delete;
  CalibrationRun& operator=(const CalibrationRun&) = delete;
  /// However it ends, the wheels are told to stand.
  ~CalibrationRun() {
    program_.shut_down();
    const Instant until = clock_.now() + paced(kLastWords);
    for (Instant now = clock_.now(); now < until; now = clock_.now()) {
      devices_.keep(now);
      clock_.wait_until(now + kTick);
    }
    guardian_.release();
  }

  ExitCode go() {
    if (const auto code = devices_.wait_for_all(clock_, paced(kDevicesBy), pending_interruption,
                                                [this](std::string_view line) { say(line); })) {
      return *code;
    }
    Instant ready_by = clock_.now() + paced(kReadyBy);
    Instant next = clock_.now();
    for (int steps = 1; !program_.done(); ++steps) {
      const Instant now = clock_.now();
      devices_.keep(now);
      program_.step(now);
      if (const auto code = pending_interruption()) {
        say("stopping: nothing was measured");
        return *code;
      }
      if (program_.base().status() == RoombaStatus::kReady) {
        ready_by = now + paced(kReadyBy);
      } else if (now >= ready_by || !guardian_lives_) {
        say("the Roomba is not ready to drive: is it switched on, off its charger, all wheels on the floor?");
        return ExitCode::kUnavailable;
      }
      if (steps % kTellEvery == 0) {
        say(program_.progress());
      }
      next = std::max(next + kTick, now);
      guardian_lives_ = wait_beating(clock_, rate_, next, guardian_) && guardian_lives_;
    }
    return ExitCode::kDone;
  }
  [[nodiscard]] const CalibrationResult& result() const { return program_.result(); }

 private:
  void say(std::string_view line) const { environment_.err << line << '\n' << std::flush; }
  [[nodiscard]] Duration paced(Duration machine) const { return from_s(to_s(machine) * rate_); }

  const SensobotEnvironment& environment_;
  Guardian& guardian_;
  bool guardian_lives_{true};
  MonotonicClock clock_;
  double rate_;
  Devices devices_;
  CalibrationProgram program_;
};

/// \throws LoadError
void need_devices(const RobotFile& robot, const CalibrationPlan& plan) {
  std::vector<Problem> problems;
  const auto need = [&](bool there, const char* key, const char* what) {
    if (!there) {
      problems.push_back({{robot.file, 0, 0}, "devices", std::string{"'"} + key + "' is missing", what});
    }
  };
  need(robot.devices.base.has_value(), "base", "a calibration drives");
  need(plan.turns == 0 || robot.devices.sensors.has_value(), "sensors",
       "turns are measured by the compass; --turns 0 leaves them out");
  need(plan.laps == 0 || !robot.devices.card_readers.empty(), "card_readers",
       "laps are measured by floor tags; --laps 0 leaves them out");
  need(plan.spins == 0 || robot.devices.llrp.has_value(), "llrp", "antennas are measured by the UHF reader");
  if (robot.settings.base.kind == BaseKind::kRoomba400) {
    problems.push_back({{robot.file, 0, 0},
                        "robot.base.kind",
                        "a Roomba 400 has no encoders to calibrate",
                        "expected create2"});
  }
  const auto& tags = robot.settings.ceiling_tags;
  const bool named = plan.tag.empty() || std::any_of(tags.begin(), tags.end(), [&](const KnownTag& tag) {
                       return tag.name == plan.tag;
                     });
  if (plan.spins > 0 && (tags.empty() || !named)) {
    problems.push_back({{robot.file, 0, 0},
                        "place.ceiling_tags",
                        tags.empty() ? "is empty" : "has no tag '" + plan.tag + "'",
                        "expected the tag under which the robot stands, and its height"});
  }
  if (!problems.empty()) {
    throw LoadError(problems, kExitInvalid);
  }
}

std::string next_steps(const CalibrateCommandOptions& options) {
  const std::string robot = options.robot.string();
  return options.out ? "next: sensobot run " + robot + " --calibration " + options.out->string() + "\n"
                     : "next: put these lines into " + robot + ", or say --out FILE and sensobot run " +
                           robot + " --calibration FILE\n";
}

}  // namespace

ExitCode calibrate_command(const CalibrateCommandOptions& options, const SensobotEnvironment& environment) {
  const RobotFile robot =
      read_robot_file(options.robot, options.devices, RobotFileUse::kCheck, options.calibration);
  need_devices(robot, options.plan);
  Guardian guardian = begin_base_guardian();
  CalibrationRun run(robot, options, environment, guardian);
  if (const ExitCode code = run.go(); code != ExitCode::kDone) {
    return code;
  }
  const CalibrationResult& result = run.result();
  environment.err << calibration_text(result, robot.settings);
  const std::string about =
      "measured " + environment.utc() + " by sensobot calibrate " + options.robot.filename().string();
  if (!result.fault.empty()) {
    environment.err << "came to nothing: " << result.fault << '\n';
    return ExitCode::kNotAccepted;
  }
  const std::string yaml = calibration_yaml(result, robot.settings, about);
  if (options.out) {
    OutputFile file(*options.out);
    file.append(yaml);
    file.finish();
  }
  if (options.json) {
    environment.out << calibration_json(result, robot.settings);
  } else if (!options.out) {
    environment.out << yaml;
  }
  environment.err << next_steps(options);
  return ExitCode::kDone;
}

}  // namespace sensotwin::robot
