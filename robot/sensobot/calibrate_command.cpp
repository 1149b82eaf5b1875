// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/output/signals.hpp"
#include "robot/sensobot/base_guardian.hpp"
#include "robot/sensobot/calibration_drive.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/sensobot/devices.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {
namespace {

constexpr Duration kDevicesBy = std::chrono::seconds{10};
/// A Roomba that is not ready to drive for so long will not be. Chosen: six start-ups said.
constexpr Duration kReadyBy = std::chrono::seconds{3};

/// The drive of a calibration on the machine's devices.
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
        links_(devices_.links()),
        base_(links_.base, base_config_of(robot.settings.base)),
        sensor_board_(links_.sensors),
        tags_(links_.floor_reader, card_config_of(robot.settings.floor_reader)),
        metres_per_count_(mapping_wheels(robot.settings.base)),
        drive_({.wheel_base_m = robot.settings.base.wheel_base_m,
                .turns = options.turns,
                .tags = options.tags,
                .tile_m = robot.settings.tile_m}) {}
  CalibrationRun(const CalibrationRun&) = delete;
  CalibrationRun& operator=(const CalibrationRun&) = delete;
  /// However it ends, the wheels are told to stand.
  ~CalibrationRun() {
    base_.shut_down();
    devices_.keep(clock_.now());
    guardian_.release();
  }

  ExitCode go() {
    const auto say = [this](std::string_view line) { environment_.err << line << '\n'; };
    if (const auto code =
            devices_.wait_for_all(clock_, from_s(to_s(kDevicesBy) * rate_), pending_interruption, say)) {
      return *code;
    }
    Instant ready_by = clock_.now() + from_s(to_s(kReadyBy) * rate_);
    for (Instant next = clock_.now(); !drive_.done(); next += kTick) {
      const Instant now = clock_.now();
      step(now);
      if (const auto code = pending_interruption()) {
        return *code;
      }
      if (base_.status() == RoombaStatus::kReady) {
        ready_by = now + from_s(to_s(kReadyBy) * rate_);
      } else if (now >= ready_by || !guardian_lives_) {
        say("the Roomba is not ready to drive: is it switched on, off its charger, all wheels on the floor?");
        return ExitCode::kUnavailable;
      }
      clock_.wait_until(next + kTick);
    }
    return ExitCode::kDone;
  }
  [[nodiscard]] const CalibrationResult& result() const { return drive_.result(); }

 private:
  static double mapping_wheels(const BaseSettings& base) {
    return kPi * base.wheel_diameter_m / base.counts_per_turn;
  }

  void step(Instant now) {
    devices_.keep(now);
    base_.step(now);
    sensor_board_.step(now);
    tags_.step(now);
    guardian_lives_ = guardian_.beat() && guardian_lives_;
    while (const auto event = tags_.next_event()) {
      sensed_.tag_entered = sensed_.tag_entered || std::holds_alternative<TagEntered>(*event);
      sensed_.tag_left = sensed_.tag_left || std::holds_alternative<TagLeft>(*event);
    }
    if (const auto& reading = sensor_board_.compass(); reading && reading->stamp > compass_stamp_) {
      compass_stamp_ = reading->stamp;
      sensed_.yaw_from_north_rad = reading->yaw_from_north_rad;
    }
    const RoombaState* const state = base_.fresh();
    if (state == nullptr || base_.status() != RoombaStatus::kReady || !state->encoders) {
      return;
    }
    if (last_counts_) {
      sensed_.left_m += metres_per_count_ * (state->encoders->left - last_counts_->left);
      sensed_.right_m += metres_per_count_ * (state->encoders->right - last_counts_->right);
    }
    last_counts_ = state->encoders;
    sensed_.now = now;
    sensed_.bumped = state->bump_left || state->bump_right;
    (void)base_.drive(drive_.step(sensed_));
    sensed_.tag_entered = false;
    sensed_.tag_left = false;
    sensed_.yaw_from_north_rad.reset();
  }

  const SensobotEnvironment& environment_;
  Guardian& guardian_;
  bool guardian_lives_{true};
  MonotonicClock clock_;
  double rate_;
  Devices devices_;
  RobotLinks links_;
  Roomba base_;
  SensorBoard sensor_board_;
  TagReader tags_;
  double metres_per_count_;
  CalibrationDrive drive_;
  CalibrationSensed sensed_;
  std::optional<EncoderCounts> last_counts_;
  Instant compass_stamp_;
};

/// Mean of two measurements, and how far they are from it.
struct Measured {
  double value{0.0};
  double spread{0.0};
};
Measured mean_of(const std::array<double, 2>& both) {
  return {0.5 * (both[0] + both[1]), 0.5 * std::abs(both[0] - both[1])};
}

/// \throws LoadError
void need_devices(const RobotFile& robot, const CalibrateCommandOptions& options) {
  std::vector<Problem> problems;
  const auto need = [&](bool there, const char* key) {
    if (!there) {
      problems.push_back(
          {{robot.file, 0, 0}, "devices", std::string{"'"} + key + "' is missing", "a calibration needs it"});
    }
  };
  need(robot.devices.base.has_value(), "base");
  need(options.turns == 0 || robot.devices.sensors.has_value(), "sensors");
  need(options.tags == 0 || !robot.devices.card_readers.empty(), "card_readers");
  if (robot.settings.base.kind == BaseKind::kRoomba400) {
    problems.push_back({{robot.file, 0, 0},
                        "robot.base.kind",
                        "a Roomba 400 has no encoders to calibrate",
                        "expected create2"});
  }
  if (!problems.empty()) {
    throw LoadError(problems, kExitInvalid);
  }
}

}  // namespace

ExitCode calibrate_command(const CalibrateCommandOptions& options, const SensobotEnvironment& environment) {
  const RobotFile robot = read_robot_file(options.robot, options.devices, RobotFileUse::kCheck);
  need_devices(robot, options);
  Guardian guardian = begin_base_guardian();
  CalibrationRun run(robot, options, environment, guardian);
  if (const ExitCode code = run.go(); code != ExitCode::kDone) {
    return code;
  }
  const CalibrationResult& result = run.result();
  if (result.fault != CalibrationFault::kNone) {
    environment.err << "nothing was measured: " << say(result.fault) << '\n';
    return ExitCode::kNotAccepted;
  }
  const Measured way = options.tags > 0 ? mean_of(result.way_scale) : Measured{1.0, 0.0};
  const double diameter_m = robot.settings.base.wheel_diameter_m * way.value;
  // The base was measured with the ways of the wheels as they were told: longer ones turn as much on a base
  // as much longer.
  const Measured base = options.turns > 0 ? mean_of(result.wheel_base_m) : Measured{};
  if (options.json) {
    nlohmann::ordered_json figures;
    if (options.turns > 0) {
      figures["wheel_base_m"] = base.value * way.value;
      figures["wheel_base_spread_m"] = base.spread * way.value;
    }
    if (options.tags > 0) {
      figures["wheel_diameter_m"] = diameter_m;
      figures["wheel_diameter_spread_m"] = robot.settings.base.wheel_diameter_m * way.spread;
    }
    environment.out << figures.dump(2) << '\n';
    return ExitCode::kDone;
  }
  environment.out << "robot:\n  base:\n";
  if (options.turns > 0) {
    environment.out << fmt::format(
        "    wheel_base_m: {:.5f}      # left and right differ from it by {:.5f}\n", base.value * way.value,
        base.spread * way.value);
  }
  if (options.tags > 0) {
    environment.out << fmt::format(
        "    wheel_diameter_m: {:.5f}  # forward and back differ from it by {:.5f}\n", diameter_m,
        robot.settings.base.wheel_diameter_m * way.spread);
  }
  return ExitCode::kDone;
}

}  // namespace sensotwin::robot
