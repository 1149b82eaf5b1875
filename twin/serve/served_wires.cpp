// SPDX-License-Identifier: MIT
#include "twin/serve/served_wires.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "twin/serve/serve_error.hpp"

namespace sensotwin::twin {
namespace {

/// What the sensor boards of protocols study, 3 speak at ten sentences a second.
constexpr int kSensorBaud = 38400;
constexpr std::uint16_t kLlrpPort = 5084;  // IANA's

}  // namespace

ServedWires::ServedWires(ServedTwin& twin, const WireSettings& settings, const std::filesystem::path& folder,
                         const Say& warn)
    : twin_(twin) {
  open_terminals(settings, folder);
  if (twin_.uhf_reader() != nullptr) {
    open_llrp(settings, warn);
  }
  if (settings.vpcd) {
    open_cards(*settings.vpcd);
  }
  had_client_.assign(wires_.size(), false);
}

void ServedWires::open_terminals(const WireSettings& settings, const std::filesystem::path& folder) {
  EmulatedRoomba& roomba = twin_.machine().roomba();
  TerminalWireOptions oi;
  oi.baud = roomba.baud();
  oi.device_baud = [&roomba] { return roomba.baud(); };
  oi.strict_baud = settings.strict_baud;
  // A serial cable's driver raises RTS when the port is opened, and the cable has it on the BRC pin.
  oi.on_client = [&roomba] { roomba.pulse_brc(); };
  auto base =
      std::make_unique<TerminalWire>("base", folder / "base", twin_.machine().serial(), std::move(oi));
  base_ = base.get();
  devices_.base = base->terminal().link();
  wires_.push_back(std::move(base));

  TerminalWireOptions nmea;
  nmea.baud = kSensorBaud;
  auto sensors = std::make_unique<TerminalWire>("sensors", folder / "sensors", twin_.machine().sensor_board(),
                                                std::move(nmea));
  devices_.sensors = sensors->terminal().link();
  wires_.push_back(std::move(sensors));
}

void ServedWires::open_llrp(const WireSettings& settings, const Say& warn) {
  const Endpoint at = settings.llrp.value_or(Endpoint{.port = kLlrpPort});
  std::unique_ptr<LlrpWire> wire;
  try {
    wire = std::make_unique<LlrpWire>("llrp", *twin_.uhf_reader(), at);
  } catch (const ServeError& error) {
    if (settings.llrp) {
      throw;
    }
    wire = std::make_unique<LlrpWire>("llrp", *twin_.uhf_reader(), Endpoint{});
    warn(fmt::format("{}; the UHF reader is at {} instead", error.what(), to_text(wire->endpoint())));
  }
  devices_.llrp = to_text(wire->endpoint());
  wires_.push_back(std::move(wire));
}

void ServedWires::open_cards(const Endpoint& vpcd) {
  card_service_.emplace();
  const auto open = [&](const char* name, robot::CardLink& reader, int slot) {
    Endpoint at = vpcd;
    at.port = static_cast<std::uint16_t>(at.port + slot);
    auto wire = std::make_unique<CardWire>(name, reader, at);
    cards_.push_back(wire.get());
    wires_.push_back(std::move(wire));
  };
  open("floor card", twin_.machine().floor_reader(), 0);
  open("forward card", twin_.forward_reader(), 1);
}

void ServedWires::pump(double wall_s) {
  for (const auto& wire : wires_) {
    wire->pump(wall_s);
  }
  if (base_->has_client() && !driven_) {
    for (CardWire* card : cards_) {
      card->await_client(wall_s);
    }
  }
  driven_ = base_->has_client();
}

void ServedWires::watch(std::vector<pollfd>& handles) const {
  for (const auto& wire : wires_) {
    wire->watch(handles);
  }
}

bool ServedWires::cards_are_settled(double wall_s) const {
  return std::ranges::all_of(cards_, [wall_s](const CardWire* card) { return card->is_settled(wall_s); });
}

std::optional<Devices> ServedWires::devices() {
  const auto is = [](CardWire::Peer peer) {
    return [peer](const CardWire* card) { return card->peer() == peer; };
  };
  if (devices_.card_readers.empty() && !cards_.empty()) {
    if (std::ranges::all_of(cards_, is(CardWire::Peer::kServing))) {
      card_service_->renew();
      devices_.card_readers = virtual_slots_among(card_service_->readers());
    } else if (std::ranges::any_of(cards_, is(CardWire::Peer::kUnknown))) {
      return std::nullopt;
    }
  }
  return devices_;
}

void ServedWires::tell(const Say& say, const Say& warn) {
  for (std::size_t i = 0; i < wires_.size(); ++i) {
    if (wires_[i]->has_client() != had_client_[i]) {
      had_client_[i] = !had_client_[i];
      say(fmt::format("{}: a client has {}", wires_[i]->name(), had_client_[i] ? "come" : "left"));
    }
  }
  tell_of_baud(warn);
  tell_of_cards(warn);
}

void ServedWires::tell_of_baud(const Say& warn) {
  if (base_->wrong_baud() && !told_of_baud_) {
    warn(
        fmt::format("base: the client has set {} baud, the robot speaks {}: on a cable they would not "
                    "understand each other",
                    base_->terminal().client_baud().value_or(0), twin_.machine().roomba().baud()));
  }
  told_of_baud_ = base_->wrong_baud();
}

void ServedWires::tell_of_cards(const Say& warn) {
  using Peer = CardWire::Peer;
  for (const CardWire* card : cards_) {
    if (card->peer() == told_of_cards_ || (card->peer() != Peer::kAbsent && card->peer() != Peer::kSilent)) {
      continue;
    }
    told_of_cards_ = card->peer();
    if (card->peer() == Peer::kAbsent) {
      warn(
          fmt::format("no card readers: nobody listens at {}. The other wires are served. For the cards: "
                      "apt-get install vsmartcard-vpcd pcscd, and start pcscd",
                      to_text(card->endpoint())));
    } else {
      warn(fmt::format(
          "no card reader: {} takes us up and asks nothing. Is another virtual card in that slot, "
          "another twin serve perhaps?",
          to_text(card->endpoint())));
    }
  }
}

}  // namespace sensotwin::twin
