// SPDX-License-Identifier: MIT
#include "robot/sensobot/robot_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "robot/ports/guardian.hpp"
#include "robot/ports/monotonic_clock.hpp"
#include "robot/replay/journal_file.hpp"
#include "robot/replay/wiring.hpp"
#include "robot/sensobot/base_guardian.hpp"
#include "robot/sensobot/devices.hpp"
#include "robot/sensobot/robot_recorder.hpp"
#include "robot/settings/robot_program.hpp"
#include "robot/telemetry/monitor.hpp"
#include "robot/telemetry/program_tap.hpp"

namespace sensotwin::robot {
namespace {

/// Steps between two looks at which devices are there. Chosen: a seventh of a second.
constexpr int kLookEvery = 10;
/// Steps between two lines on how far it is. Chosen: half a minute.
constexpr int kTellEvery = 2000;
/// Without a good frame for so long at the start, the Roomba is not there. Chosen: six start-ups said.
constexpr Duration kFirstFrameBy = std::chrono::seconds{3};
/// What is said last has left the queues by then. Chosen.
constexpr Duration kLastWords = std::chrono::milliseconds{45};

/// One run, from the opening of the ports on.
class Run {
 public:
  Run(const RobotFile& robot, RunFolder& folder, const RobotRunOptions& options, Guardian& guardian)
      : robot_(robot),
        options_(options),
        guardian_(guardian),
        clock_(options.rate),
        recorder_(robot, folder),
        devices_(robot, options.card_service, [this](int port) { guardian_lives_ = guardian_.watch(port); }),
        journal_(options.journal, robot_yaml(robot)),
        wiring_(devices_.links(), journal_.writer()),
        program_(wiring_.links(), robot.settings) {
    begin_monitor_page();
    for (const DeviceState& device : devices_.states()) {
      device_notes_.push_back({device.up, {}, false});
    }
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  /// However it ends, the wheels are told to stand.
  ~Run() { shut_down(); }

  RobotRunResult go() {
    ExitCode code = wait_for_devices();
    if (code == ExitCode::kDone) {
      code = drive();
    }
    shut_down();
    if (tap_) {
      tap_->ended(clock_.now(), figures_.outcome);
      monitor_->hub().flush();
    }
    figures_.run_s = to_s(clock_.now() - begun_);
    if (const JournalWriter* journal = journal_.writer()) {
      figures_.journal_bytes = journal->bytes_written();
      figures_.journal_complete = !journal->failed();
    }
    return {code, recorder_.finish(program_, figures_)};
  }

 private:
  struct DeviceNote {
    bool up{false};
    std::optional<Instant> gone_since;
    bool ever_up{false};
  };

  void say(const std::string& line) const {
    if (options_.say) {
      options_.say(line);
    }
  }

  /// The machine's time in the robot's.
  [[nodiscard]] Duration paced(Duration machine) const { return from_s(to_s(machine) * options_.rate); }

  ExitCode interrupted(ExitCode code) {
    figures_.outcome = "interrupted";
    return code;
  }

  /// After the guardian was begun: the page has threads.
  void begin_monitor_page() {
    if (!options_.monitor) {
      return;
    }
    monitor_ = begin_monitor(*options_.monitor);
    say("monitor at " + monitor_->url());
    const std::string name = std::filesystem::path(robot_.file).stem().string();
    tap_.emplace(monitor_->hub(), card_of(robot_.settings, name, "sensobot run"));
    recorder_.listen([this](Instant now, std::string_view event, std::initializer_list<EventField> fields) {
      tap_->heard(now, event, fields);
    });
  }

  void show(Instant now) {
    if (!tap_) {
      return;
    }
    if (const MappingProgram* mapping = program_.mapping()) {
      tap_->after_step(now, *mapping);
    } else if (const HallwayProgram* hallway = program_.hallway()) {
      tap_->after_step(now, *hallway);
    } else {
      tap_->after_step(now, *program_.phase());
    }
  }

  /// Nothing moves before every device is there.
  ExitCode wait_for_devices() {
    const auto code = devices_.wait_for_all(clock_, paced(from_s(options_.wait_s)), options_.interruption,
                                            [this](std::string_view line) { say(std::string{line}); });
    begun_ = clock_.now();
    if (code == ExitCode::kUnavailable) {
      for (const DeviceState& device : devices_.states()) {
        if (!device.up) {
          recorder_.record(begun_, device);
        }
      }
    }
    if (code) {
      figures_.outcome = *code == ExitCode::kUnavailable ? "device_missing" : "interrupted";
    }
    return code.value_or(ExitCode::kDone);
  }

  ExitCode drive() {
    Instant next = clock_.now();
    const Instant limit = begun_ + from_s(robot_.time_limit_s);
    while (!program_.done()) {
      step();
      if (const auto code = options_.interruption()) {
        say("stopping");
        return interrupted(*code);
      }
      if (const auto why = reason_to_end(limit)) {
        return *why;
      }
      next += kTick;
      const Instant now = clock_.now();
      if (now > next + kTick) {
        ++figures_.steps_late;
        figures_.latest_step_s = std::max(figures_.latest_step_s, to_s(now - next));
        next = now;
      }
      guardian_lives_ = wait_beating(clock_, options_.rate, next, guardian_) && guardian_lives_;
    }
    return judge();
  }

  void step() {
    const Instant now = clock_.now();
    devices_.keep(now);
    program_.step(now);
    if (JournalWriter* journal = journal_.writer()) {
      journal->end_step(now);
    }
    recorder_.record(program_);
    show(now);
    if (figures_.steps % kLookEvery == 0) {
      look_at_devices(now);
    }
    if (++figures_.steps % kTellEvery == 0) {
      say(fmt::format("{:.0f} s: {}", to_s(now - begun_), recorder_.progress(program_)));
    }
  }

  void look_at_devices(Instant now) {
    const std::vector<DeviceState> states = devices_.states();
    for (std::size_t i = 0; i < states.size(); ++i) {
      DeviceNote& note = device_notes_[i];
      if (states[i].up == note.up && note.ever_up) {
        continue;
      }
      note.up = states[i].up;
      recorder_.record(now, states[i]);
      if (!states[i].up) {
        note.gone_since = now;
        say(fmt::format("{:.1f} s: {} is gone ({}); trying again", to_s(now - begun_), states[i].name,
                        states[i].trouble));
      } else if (note.gone_since) {
        note.gone_since.reset();
        say(fmt::format("{:.1f} s: {} is back", to_s(now - begun_), states[i].name));
      }
      note.ever_up = true;
    }
  }

  std::optional<ExitCode> reason_to_end(Instant limit) {
    const Instant now = clock_.now();
    if (!guardian_lives_) {
      say("the guardian process is gone: without it nobody would stop the robot if this program died");
      figures_.outcome = "guardian_lost";
      return ExitCode::kInternal;
    }
    if (program_.base().health().frames_good == 0 && now - begun_ >= paced(kFirstFrameBy)) {
      say(fmt::format(
          "the Roomba ({}) does not answer: is it switched on, is robot.base.kind right, do RXD and "
          "TXD cross?",
          robot_.devices.base.value_or("")));
      figures_.outcome = "device_missing";
      return ExitCode::kUnavailable;
    }
    for (const DeviceNote& note : device_notes_) {
      if (note.gone_since && now - *note.gone_since >= paced(from_s(options_.patience_s))) {
        say(fmt::format("it did not come back within {:g} s", options_.patience_s));
        figures_.outcome = "device_lost";
        return ExitCode::kUnavailable;
      }
    }
    if (now >= limit) {
      say(fmt::format("the time limit of {:g} s is over", robot_.time_limit_s));
      figures_.outcome = "time_limit";
      return ExitCode::kNotAccepted;
    }
    return std::nullopt;
  }

  ExitCode judge() {
    const bool good = (program_.phase() == nullptr || program_.phase()->arrived()) &&
                      (program_.hallway() == nullptr || program_.hallway()->arrived());
    figures_.outcome = good ? "done" : "not_arrived";
    return good ? ExitCode::kDone : ExitCode::kNotAccepted;
  }

  void shut_down() {
    if (std::exchange(shut_down_, true)) {
      return;
    }
    program_.shut_down();
    if (JournalWriter* journal = journal_.writer()) {
      journal->end_run(clock_.now());
    }
    const Instant until = clock_.now() + paced(kLastWords);
    for (Instant now = clock_.now(); now < until; now = clock_.now()) {
      devices_.keep(now);
      clock_.wait_until(now + kTick);
    }
    guardian_.release();
  }

  const RobotFile& robot_;
  const RobotRunOptions& options_;
  Guardian& guardian_;
  MonotonicClock clock_;
  std::unique_ptr<Monitor> monitor_;
  std::optional<ProgramTap> tap_;
  RobotRecorder recorder_;
  bool guardian_lives_{true};
  Devices devices_;
  JournalFile journal_;
  Wiring wiring_;
  RobotProgram program_;
  std::vector<DeviceNote> device_notes_;
  RunFigures figures_;
  Instant begun_;
  bool shut_down_{false};
};

}  // namespace

RobotRunResult run_robot(const RobotFile& robot, RunFolder& folder, const RobotRunOptions& options) {
  Guardian guardian = begin_base_guardian();
  Run run(robot, folder, options, guardian);
  return run.go();
}

}  // namespace sensotwin::robot
