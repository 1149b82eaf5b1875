// SPDX-License-Identifier: MIT
#include "robot/sensobot/devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "robot/ports/serial_port.hpp"
#include "robot/ports/tcp_port.hpp"
#include "robot/wire/sci.hpp"

namespace sensotwin::robot {
Devices::Devices(const RobotFile& robot, const CardService& service, std::function<void(int)> on_base_open) {
  const DeviceAddresses& at = robot.devices;
  const std::string serial_remedy =
      "is it plugged in and switched on, may you open it (group dialout), and does nobody else have it?";
  if (at.base) {
    SerialPortConfig config{.path = *at.base, .on_open = std::move(on_base_open)};
    if (robot.settings.base.kind == BaseKind::kRoomba400) {
      config.baud = sci::kBaud;
    }
    slots_.push_back(
        {kBaseName, *at.base, serial_remedy, std::make_unique<SerialPort>(std::move(config)), {}});
  }
  if (at.sensors) {
    slots_.push_back(
        {kSensorsName,
         *at.sensors,
         serial_remedy,
         std::make_unique<SerialPort>(SerialPortConfig{.path = *at.sensors, .baud = at.sensors_baud}),
         {}});
  }
  if (at.llrp) {
    const TcpAddress address = tcp_address(*at.llrp).value_or(TcpAddress{*at.llrp});
    slots_.push_back({kUhfReaderName,
                      *at.llrp,
                      "is it switched on and in the same network, and is no other program connected to it?",
                      std::make_unique<TcpPort>(TcpPortConfig{.address = address}),
                      {}});
  }
  const auto add_card = [&](const char* name, const std::string& reader) {
    slots_.push_back({name,
                      reader,
                      "is it plugged in, does pcscd run, and does `pcsc_scan -r` name it so?",
                      {},
                      std::make_unique<CardPort>(CardPortConfig{.reader = reader}, service)});
  };
  if (!at.card_readers.empty()) {
    add_card(kFloorReaderName, at.card_readers[0]);
  }
  if (at.card_readers.size() > 1) {
    add_card(kForwardReaderName, at.card_readers[1]);
  }
}

void Devices::keep(Instant now) {
  for (const Slot& slot : slots_) {
    if (slot.port) {
      slot.port->keep(now);
    }
  }
}

ByteLink& Devices::port_or_none(const char* name) {
  const auto found =
      std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.name == name; });
  return found == slots_.end() ? static_cast<ByteLink&>(no_port_) : *found->port;
}

CardLink& Devices::card_or_none(const char* name) {
  const auto found =
      std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.name == name; });
  return found == slots_.end() ? static_cast<CardLink&>(no_card_) : static_cast<CardLink&>(*found->card);
}

RobotLinks Devices::links() {
  return {port_or_none(kBaseName), port_or_none(kSensorsName), port_or_none(kUhfReaderName),
          card_or_none(kFloorReaderName), card_or_none(kForwardReaderName)};
}

std::optional<ExitCode> Devices::wait_for_all(const MonotonicClock& clock, Duration longest,
                                              const std::function<std::optional<ExitCode>()>& interruption,
                                              const std::function<void(std::string_view)>& say) {
  const Instant by = clock.now() + longest;
  for (Instant next = clock.now();; next += kTick) {
    keep(clock.now());
    const std::vector<DeviceState> now = states();
    if (std::all_of(now.begin(), now.end(), [](const DeviceState& device) { return device.up; })) {
      return std::nullopt;
    }
    if (const auto code = interruption()) {
      return code;
    }
    if (clock.now() >= by) {
      for (const DeviceState& device : now) {
        if (!device.up) {
          say(fmt::format("{} ({}) is not there: {}; {}", device.name, device.address, device.trouble,
                          device.remedy));
        }
      }
      return ExitCode::kUnavailable;
    }
    clock.wait_until(next + kTick);
  }
}

std::vector<DeviceState> Devices::states() const {
  std::vector<DeviceState> states;
  for (const Slot& slot : slots_) {
    DeviceState state{slot.name, slot.address, false, {}, slot.remedy};
    if (slot.port) {
      state.up = slot.port->is_up();
      state.trouble = slot.port->trouble();
    } else {
      state.trouble = slot.card->trouble();
      state.up = slot.card->was_tried() && state.trouble.empty();
    }
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace sensotwin::robot
