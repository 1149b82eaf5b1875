// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_settings.hpp"

#include <array>
#include <cmath>

namespace sensotwin::twin {
namespace llrp = robot::llrp;
namespace {

constexpr std::uint8_t kC1G2 = 1;
constexpr std::uint16_t kGpioPorts = 4;
constexpr std::uint16_t kPowers = 81;  ///< 10.00 to 30.00 dBm in steps of 0.25
constexpr std::uint16_t kAutoSetMode = 1000;

/// The mode table of the recorded R420: ids 1000 and up are Impinj's AutoSet modes, which tell nothing.
struct ModeRow {
  std::uint32_t id;
  bool ratio_64_3;
  std::uint8_t modulation;
  std::uint8_t forward;
  std::uint8_t mask;
  std::uint32_t backscatter_bps;
  std::uint32_t pie_thousandths;
  std::uint32_t tari_ns;
};
constexpr std::array<ModeRow, 10> kModes{{{0, true, 0, 2, 2, 640000, 1500, 6250},
                                          {1, true, 1, 2, 2, 640000, 1500, 6250},
                                          {2, true, 2, 0, 3, 274000, 2000, 20000},
                                          {3, true, 3, 0, 3, 170600, 2000, 20000},
                                          {4, true, 2, 0, 2, 640000, 1500, 7140},
                                          {1000, false, 0, 0, 0, 40000, 1500, 6250},
                                          {1002, false, 0, 0, 0, 40000, 1500, 6250},
                                          {1003, false, 0, 0, 0, 40000, 1500, 6250},
                                          {1004, false, 0, 0, 0, 40000, 1500, 6250},
                                          {1005, false, 0, 0, 0, 40000, 1500, 6250}}};

[[nodiscard]] llrp::GeneralCapabilities general(const UhfReaderSettings& settings) {
  llrp::GeneralCapabilities out{.antennas = settings.antennas,
                                .has_utc_clock = true,
                                .manufacturer = settings.impinj_extensions ? llrp::kImpinj : 0,
                                .model = 2001002,
                                .firmware = "5.14.0.240",
                                .gpio = {kGpioPorts, kGpioPorts}};
  // 0, then 10 to 50 dB below the best.
  for (std::uint16_t i = 1; i <= 42; ++i) {
    out.sensitivities.push_back({i, static_cast<std::uint16_t>(i == 1 ? 0 : i + 8)});
  }
  for (std::uint16_t antenna = 1; antenna <= settings.antennas; ++antenna) {
    out.protocols.push_back({antenna, {kC1G2}});
  }
  return out;
}

[[nodiscard]] llrp::UhfBand band(const UhfReaderSettings& settings) {
  llrp::UhfBand out;
  for (std::uint16_t i = 1; i <= kPowers; ++i) {
    out.powers.push_back({i, static_cast<std::int16_t>(1000 + 25 * (i - 1))});
  }
  llrp::FrequencyHopTable hops{.id = 1};
  for (const double hz : settings.channels_hz) {
    hops.frequencies_khz.push_back(static_cast<std::uint32_t>(std::lround(hz / 1e3)));
  }
  out.frequencies.hopping = true;
  out.frequencies.hop_tables.push_back(std::move(hops));
  llrp::RfModeTable& table = out.mode_tables.emplace_back();
  for (const ModeRow& row : kModes) {
    table.modes.push_back({row.id, row.ratio_64_3, false, row.modulation, row.forward, row.mask,
                           row.backscatter_bps, row.pie_thousandths, row.tari_ns, row.tari_ns, 0});
  }
  return out;
}

}  // namespace

llrp::GetReaderCapabilitiesResponse uhf_capabilities(const UhfReaderSettings& settings) {
  return {.general = general(settings),
          .llrp = llrp::LlrpCapabilities{.buffer_fill_warning = true,
                                         .event_and_report_holding = true,
                                         .priority_levels = 1,
                                         .ro_specs = 1,
                                         .specs_per_ro_spec = 32,
                                         .inventory_specs_per_ai_spec = 1,
                                         .access_specs = 1508,
                                         .op_specs_per_access_spec = 8},
          .regulatory = llrp::RegulatoryCapabilities{840, 1, band(settings), {}},
          .c1g2 = llrp::C1G2Capabilities{.block_write = true, .select_filters = 2}};
}

llrp::GetReaderConfigResponse uhf_factory_configuration(const UhfReaderSettings& settings) {
  llrp::GetReaderConfigResponse out;
  out.identification = llrp::Identification{0, {0x00, 0x16, 0x25, 0xFF, 0xFF, 0x11, 0x25, 0xD6}};
  for (std::uint16_t antenna = 1; antenna <= settings.antennas; ++antenna) {
    out.antenna_properties.push_back({true, antenna, 0});
    llrp::C1G2InventoryCommand command;
    command.rf_control = llrp::C1G2RfControl{kAutoSetMode, 0};
    command.singulation = llrp::C1G2SingulationControl{.session = 1, .tag_population = 32};
    out.antennas.push_back({antenna, llrp::RfReceiver{1}, llrp::RfTransmitter{1, 0, kPowers}, {command}});
  }
  llrp::EventSpec& events = out.events.emplace();
  for (std::uint16_t kind = 0; kind <= static_cast<std::uint16_t>(llrp::EventKind::kAntenna); ++kind) {
    const auto event = static_cast<llrp::EventKind>(kind);
    events.states.push_back(
        {event, event == llrp::EventKind::kReaderException || event == llrp::EventKind::kAntenna});
  }
  out.ro_report = llrp::RoReportSpec{
      .trigger = llrp::RoReportTrigger::kTagsOrEndOfRoSpec,
      .tags = 1,
      .content = {.antenna_id = true, .peak_rssi = true, .first_seen = true, .memory = {{}}}};
  out.access_report = llrp::AccessReportSpec{llrp::AccessReportTrigger::kEndOfAccessSpec};
  out.state = llrp::ConfigurationState{0};
  out.keepalive = llrp::KeepaliveSpec{};
  for (std::uint16_t port = 1; port <= kGpioPorts; ++port) {
    out.inputs.push_back({port, false, llrp::GpiState::kLow});
    out.outputs.push_back({port, false});
  }
  out.events_and_reports = llrp::EventsAndReports{};
  return out;
}

}  // namespace sensotwin::twin
