// SPDX-License-Identifier: MIT
#include "robot/drivers/uhf_reader_config.hpp"

#include <cmath>

namespace sensotwin::robot {
namespace {

[[nodiscard]] llrp::C1G2InventoryCommand inventory_command(const UhfReaderConfig& config, bool with_impinj) {
  llrp::C1G2InventoryCommand out;
  if (config.rf_mode) {
    out.rf_control = llrp::C1G2RfControl{*config.rf_mode, 0};
  }
  out.singulation =
      llrp::C1G2SingulationControl{.session = config.session, .tag_population = config.tag_population};
  if (config.search_mode && with_impinj) {
    out.search_mode = llrp::ImpinjSearchMode{*config.search_mode};
  }
  return out;
}

[[nodiscard]] llrp::RoReportSpec report_spec(const UhfReaderConfig& config, bool with_impinj) {
  llrp::RoReportSpec out;
  out.trigger = llrp::RoReportTrigger::kTagsOrEndOfAiSpec;
  out.tags = config.report_every;
  out.content = {.ro_spec_id = true,
                 .antenna_id = true,
                 .channel_index = true,
                 .peak_rssi = true,
                 .first_seen = true,
                 .last_seen = true,
                 .access_spec_id = true};
  if (with_impinj) {
    out.impinj = llrp::ImpinjReportContent{.phase_angle = llrp::ImpinjEnablePhaseAngle{1},
                                           .peak_rssi = llrp::ImpinjEnablePeakRssi{1}};
  }
  return out;
}

}  // namespace

llrp::RoSpec inventory_spec(const UhfReaderConfig& config, bool with_impinj) {
  llrp::InventoryParameterSpec inventory{.id = 1};
  for (const std::uint16_t antenna : config.antennas) {
    llrp::AntennaConfiguration& each = inventory.antennas.emplace_back();
    each.antenna = antenna;
    if (config.transmit_power_index) {
      each.transmitter = llrp::RfTransmitter{1, 1, *config.transmit_power_index};
    }
    each.inventory.push_back(inventory_command(config, with_impinj));
  }
  llrp::AiSpec ai_spec{.antennas = config.antennas, .inventory = {std::move(inventory)}};
  if (config.report_every > 1) {
    // Few tags may never make N entries: the end of a short AISpec sends what there is, and the immediate
    // start trigger begins it again.
    ai_spec.stop.kind = llrp::AiStop::kDuration;
    ai_spec.stop.duration_ms = static_cast<std::uint32_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(config.report_within).count());
  }
  llrp::RoSpec out{.id = kRoSpecId};
  out.boundary.start.kind = llrp::RoStart::kImmediate;
  out.ai_specs.push_back(std::move(ai_spec));
  out.report = report_spec(config, with_impinj);
  return out;
}

llrp::SetReaderConfig reader_settings(const UhfReaderConfig& config) {
  llrp::SetReaderConfig out;
  out.events =
      llrp::EventSpec{{{llrp::EventKind::kReaderException, true}, {llrp::EventKind::kAntenna, true}}};
  out.keepalive = llrp::KeepaliveSpec{llrp::KeepaliveTrigger::kPeriodic,
                                      static_cast<std::uint32_t>(std::lround(config.keepalive_s * 1e3))};
  return out;
}

llrp::AccessSpec memory_spec(const Epc& epc, const llrp::C1G2OpSpec& operation) {
  constexpr std::uint16_t kEpcBits = 96;
  constexpr std::uint16_t kEpcAtBit = 32;  // behind CRC and PC
  llrp::C1G2TargetTag target{.bank = llrp::MemoryBank::kEpc, .match = true, .bit_pointer = kEpcAtBit};
  target.mask = {kEpcBits, Bytes(epc.bytes.size(), 0xFF)};
  target.data = {kEpcBits, Bytes(epc.bytes.begin(), epc.bytes.end())};
  llrp::AccessSpec out{.id = kAccessSpecId};
  out.stop = {llrp::AccessStop::kCount, 1};
  out.command.tags.targets.push_back(std::move(target));
  out.command.operations.push_back(operation);
  out.report = llrp::AccessReportSpec{llrp::AccessReportTrigger::kEndOfAccessSpec};
  return out;
}

std::vector<double> channels_hz(const llrp::GetReaderCapabilitiesResponse& capabilities) {
  std::vector<double> out;
  if (!capabilities.regulatory || !capabilities.regulatory->uhf) {
    return out;
  }
  const llrp::FrequencyInformation& info = capabilities.regulatory->uhf->frequencies;
  const std::vector<std::uint32_t> none;
  const auto& khz = info.hopping && !info.hop_tables.empty() ? info.hop_tables.front().frequencies_khz
                    : !info.hopping && info.fixed            ? info.fixed->frequencies_khz
                                                             : none;
  for (const std::uint32_t each : khz) {
    out.push_back(each * 1e3);
  }
  return out;
}

}  // namespace sensotwin::robot
