// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <set>
#include <string_view>

#include "robot/drivers/roomba.hpp"
#include "robot/drivers/sensor_board.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/drivers/uhf_reader.hpp"
#include "robot/output/signals.hpp"
#include "robot/output/text_format.hpp"
#include "robot/ports/monotonic_clock.hpp"
#include "robot/sensobot/capabilities_tap.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/sensobot/devices.hpp"
#include "robot/sensobot/findings.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {
namespace {

/// Frames of a Roomba and sentences of a compass come within this when they come at all. Chosen: the start-up
/// is said four times.
constexpr double kFirstWord_s = 2.0;
/// A greeting and a set-up of six requests, each answered within a second by a reader that is awake. Chosen.
constexpr double kReaderSetUp_s = 6.0;

/// Every driver on its device, for as long as the check takes. Drives no wheel.
class Probe {
 public:
  Probe(const RobotFile& robot, const CardService& service)
      : robot_(robot),
        devices_(robot, service, {}),
        links_(devices_.links()),
        tap_(links_.uhf_reader),
        base_(links_.base, base_config_of(robot.settings.base)),
        sensor_board_(links_.sensors),
        uhf_(tap_, uhf_config_of(robot.settings.uhf_reader)),
        floor_(links_.floor_reader, card_config_of(robot.settings.floor_reader)),
        forward_(links_.forward_reader, card_config_of(robot.settings.forward_reader)) {}

  /// Until everything that answers was listened to for `seconds`, or somebody interrupts.
  void listen(double seconds) {
    const double settle_s = robot_.devices.llrp ? kReaderSetUp_s : kFirstWord_s;
    Instant next = clock_.now();
    std::optional<Instant> until;
    while (!pending_interruption() && (!until || next < *until)) {
      step(next);
      if (!until && (answers() || next >= Instant{from_s(settle_s)})) {
        until = next + from_s(seconds);
        begin_ = {base_.health().frames_good, sensor_board_.health().headings, uhf_.health().reads};
      }
      next += kTick;
      clock_.wait_until(next);
    }
    listened_s_ = seconds;
    base_.shut_down();
    uhf_.shut_down();
    devices_.keep(clock_.now());
  }

  [[nodiscard]] std::vector<Finding> findings() {
    std::vector<Finding> findings;
    for (const DeviceState& state : devices_.states()) {
      Finding finding{
          .device = state.name, .address = state.address, .trouble = state.trouble, .remedy = state.remedy};
      finding.ok = state.up;
      if (state.up) {
        look_at(finding);
      }
      findings.push_back(std::move(finding));
    }
    return findings;
  }

 private:
  struct Counts {
    std::uint64_t frames{0};
    std::uint64_t headings{0};
    std::uint64_t reads{0};
  };

  void step(Instant now) {
    devices_.keep(now);
    base_.step(now);
    sensor_board_.step(now);
    uhf_.step(now);
    floor_.step(now);
    forward_.step(now);
    while (floor_.next_event() || forward_.next_event()) {
    }
    if (base_.fresh() != nullptr) {
      state_ = *base_.fresh();
    }
    for (const UhfRead& read : uhf_.reads()) {
      ++reads_by_antenna_[read.antenna];
      tags_.insert(read.epc);
    }
  }

  [[nodiscard]] bool answers() const {
    const DeviceAddresses& at = robot_.devices;
    return (!at.base || state_) && (!at.sensors || sensor_board_.health().headings > 0) &&
           (!at.llrp || uhf_.status() == UhfReaderStatus::kReading);
  }

  [[nodiscard]] std::string rate(std::uint64_t count, std::uint64_t before) const {
    return fmt::format("{:.1f}", static_cast<double>(count - before) / listened_s_);
  }

  void look_at(Finding& finding) {
    if (finding.device == kBaseName) {
      look_at_base(finding);
    } else if (finding.device == kSensorsName) {
      look_at_sensors(finding);
    } else if (finding.device == kUhfReaderName) {
      look_at_uhf_reader(finding);
    } else {
      look_at_card_reader(finding, finding.device == kFloorReaderName ? floor_ : forward_);
    }
  }

  void look_at_base(Finding& finding) {
    const LinkHealth& health = base_.health();
    if (!state_) {
      finding.ok = false;
      finding.trouble =
          fmt::format("it does not answer ({} bytes came, none of them a frame)", health.bytes_skipped);
      finding.remedy = "is it switched on, is robot.base.kind right, do RXD and TXD cross?";
      return;
    }
    static constexpr std::array<std::string_view, 4> kModes{"off", "passive", "safe", "full"};
    static constexpr std::array<std::string_view, 6> kCharging{
        "not charging", "reconditioning", "charging", "trickle charging", "waiting", "fault"};
    const bool sci = robot_.settings.base.kind == BaseKind::kRoomba400;
    auto& facts = finding.facts;
    facts.emplace_back("interface",
                       sci ? "SCI (Roomba 400)" : "Open Interface (Create 2, Roomba 500 to 900)");
    facts.emplace_back("firmware", "not told by this interface");
    if (state_->mode) {
      facts.emplace_back("mode", kModes[static_cast<std::size_t>(*state_->mode) % kModes.size()]);
    }
    facts.emplace_back("frames_per_s", rate(health.frames_good, begin_.frames));
    facts.emplace_back("frames_corrupt", std::to_string(health.frames_corrupt));
    facts.emplace_back("battery_mah", fmt::format("{} of {}", state_->charge_mah, state_->capacity_mah));
    facts.emplace_back("battery_v", fmt::format("{:.1f}", state_->battery_mv / 1000.0));
    facts.emplace_back("charging", kCharging[static_cast<std::size_t>(state_->charging) % kCharging.size()]);
    if (state_->wheel_drop_left || state_->wheel_drop_right) {
      facts.emplace_back("note", "a wheel hangs: it will not drive");
    }
  }

  void look_at_sensors(Finding& finding) {
    const SensorBoardHealth& health = sensor_board_.health();
    if (health.headings == 0) {
      finding.ok = false;
      finding.trouble = fmt::format("no heading came ({} sentences with a bad checksum, {} of other kinds)",
                                    health.bad_checksum, health.other);
      finding.remedy =
          "is devices.sensors_baud the board's (4800, 9600 or 38400), and does it send HCHDM or HCHDG?";
      return;
    }
    finding.facts.emplace_back("headings_per_s", rate(health.headings, begin_.headings));
    finding.facts.emplace_back("sentences_corrupt", std::to_string(health.bad_checksum + health.bad_frame));
    if (sensor_board_.compass()) {
      const double yaw_deg = deg_from_rad(sensor_board_.compass()->yaw_from_north_rad);
      finding.facts.emplace_back("heading_deg",
                                 fmt::format("{:.1f}", yaw_deg > 0.0 ? 360.0 - yaw_deg : -yaw_deg));
    }
  }

  void look_at_uhf_reader(Finding& finding) {
    const auto& general = tap_.general();
    if (general) {
      finding.facts.emplace_back("model",
                                 fmt::format("{} of manufacturer {}", general->model, general->manufacturer));
      finding.facts.emplace_back("firmware", general->firmware);
      finding.facts.emplace_back("antennas", std::to_string(general->antennas));
    }
    if (uhf_.health().setups == 0) {
      finding.ok = false;
      finding.trouble = uhf_.last_fault() == UhfReaderFault::kBusy
                            ? "another client has it"
                            : fmt::format("it could not be set up (fault {}: {})",
                                          static_cast<int>(uhf_.last_fault()), uhf_.refusal().description);
      finding.remedy =
          "end other programs that use it; are robot.uhf_reader.antennas the ports that are there?";
      return;
    }
    finding.facts.emplace_back("phase", uhf_.has_phase() ? "yes, Impinj's extension" : "no");
    finding.facts.emplace_back("channels", std::to_string(uhf_.channels_hz().size()));
    finding.facts.emplace_back("reads_per_s", rate(uhf_.health().reads, begin_.reads));
    finding.facts.emplace_back("tags_in_sight", std::to_string(tags_.size()));
    for (const auto& [antenna, reads] : reads_by_antenna_) {
      finding.facts.emplace_back(fmt::format("reads_antenna_{}", antenna), std::to_string(reads));
    }
  }

  static void look_at_card_reader(Finding& finding, const TagReader& reader) {
    finding.facts.emplace_back("tag", reader.tag() ? uid_text(reader.tag()->uid) : "none in the field");
    if (reader.health().reversed_uid > 0) {
      finding.ok = false;
      finding.trouble = "it gives UIDs the other way round";
      finding.remedy = "set uid_order to the other of msb_first and lsb_first";
    }
  }

  const RobotFile& robot_;
  MonotonicClock clock_;
  Devices devices_;
  RobotLinks links_;
  CapabilitiesTap tap_;
  Roomba base_;
  SensorBoard sensor_board_;
  UhfReader uhf_;
  TagReader floor_;
  TagReader forward_;
  std::optional<RoombaState> state_;
  std::map<std::uint16_t, std::uint64_t> reads_by_antenna_;
  std::set<Epc> tags_;
  Counts begin_;
  double listened_s_{0.0};
};

}  // namespace

ExitCode check_command(const CheckCommandOptions& options, const SensobotEnvironment& environment) {
  const RobotFile robot =
      read_robot_file(options.robot, options.devices, RobotFileUse::kCheck, options.calibration);
  Probe probe(robot, environment.card_service);
  probe.listen(options.seconds);
  const std::vector<Finding> findings = probe.findings();
  environment.out << (options.json ? findings_json(findings) : findings_text(findings));
  if (const auto code = pending_interruption()) {
    return *code;
  }
  const bool ok = std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.ok; });
  return ok ? ExitCode::kDone : ExitCode::kUnavailable;
}

}  // namespace sensotwin::robot
