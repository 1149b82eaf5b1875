// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/wire/llrp/custom.hpp"

/// What a reader can do: parameters of GET_READER_CAPABILITIES_RESPONSE (LLRP 1.0.1, 9.2 and 16.2.3).
namespace sensotwin::robot::llrp {

struct ReceiveSensitivity {
  static constexpr std::uint16_t kType = 139;
  std::uint16_t index{0};
  std::uint16_t below_best_db{0};
  bool operator==(const ReceiveSensitivity&) const = default;
};
struct PerAntennaSensitivity {
  static constexpr std::uint16_t kType = 149;
  std::uint16_t antenna{0};
  std::uint16_t index_min{0};
  std::uint16_t index_max{0};
  bool operator==(const PerAntennaSensitivity&) const = default;
};
struct GpioCapabilities {
  static constexpr std::uint16_t kType = 141;
  std::uint16_t inputs{0};
  std::uint16_t outputs{0};
  bool operator==(const GpioCapabilities&) const = default;
};
struct PerAntennaProtocols {
  static constexpr std::uint16_t kType = 140;
  std::uint16_t antenna{0};
  std::vector<std::uint8_t> protocols{};  ///< 1: EPCglobal Class 1 Gen 2
  bool operator==(const PerAntennaProtocols&) const = default;
};
struct GeneralCapabilities {
  static constexpr std::uint16_t kType = 137;
  std::uint16_t antennas{0};
  bool can_set_antenna_properties{false};
  bool has_utc_clock{false};
  std::uint32_t manufacturer{0};
  std::uint32_t model{0};
  std::string firmware{};
  std::vector<ReceiveSensitivity> sensitivities{};
  std::vector<PerAntennaSensitivity> per_antenna_sensitivities{};
  GpioCapabilities gpio{};
  std::vector<PerAntennaProtocols> protocols{};
  bool operator==(const GeneralCapabilities&) const = default;
};

struct LlrpCapabilities {
  static constexpr std::uint16_t kType = 142;
  bool rf_survey{false};
  bool buffer_fill_warning{false};
  bool client_request_op_spec{false};
  bool state_aware_singulation{false};
  bool event_and_report_holding{false};
  std::uint8_t priority_levels{0};
  std::uint16_t client_request_timeout{0};
  std::uint32_t ro_specs{0};
  std::uint32_t specs_per_ro_spec{0};
  std::uint32_t inventory_specs_per_ai_spec{0};
  std::uint32_t access_specs{0};
  std::uint32_t op_specs_per_access_spec{0};
  bool operator==(const LlrpCapabilities&) const = default;
};

struct TransmitPower {
  static constexpr std::uint16_t kType = 145;
  std::uint16_t index{0};
  std::int16_t centi_dbm{0};
  bool operator==(const TransmitPower&) const = default;
};
struct FrequencyHopTable {
  static constexpr std::uint16_t kType = 147;
  std::uint8_t id{0};
  std::vector<std::uint32_t> frequencies_khz{};  ///< in hopping order: ChannelIndex 1 is the first
  bool operator==(const FrequencyHopTable&) const = default;
};
struct FixedFrequencyTable {
  static constexpr std::uint16_t kType = 148;
  std::vector<std::uint32_t> frequencies_khz{};  ///< ChannelIndex 1 is the first
  bool operator==(const FixedFrequencyTable&) const = default;
};
struct FrequencyInformation {
  static constexpr std::uint16_t kType = 146;
  bool hopping{false};
  std::vector<FrequencyHopTable> hop_tables{};
  std::optional<FixedFrequencyTable> fixed{};
  bool operator==(const FrequencyInformation&) const = default;
};
struct RfMode {
  static constexpr std::uint16_t kType = 329;
  std::uint32_t id{0};
  bool divide_ratio_64_3{false};
  bool epc_hag_conformant{false};
  std::uint8_t modulation{0};  ///< 0 FM0, 1 Miller 2, 2 Miller 4, 3 Miller 8
  std::uint8_t forward_link_modulation{0};
  std::uint8_t spectral_mask{0};
  std::uint32_t backscatter_bps{0};
  std::uint32_t pie_thousandths{0};
  std::uint32_t tari_min_ns{0};
  std::uint32_t tari_max_ns{0};
  std::uint32_t tari_step_ns{0};
  bool operator==(const RfMode&) const = default;
};
struct RfModeTable {
  static constexpr std::uint16_t kType = 328;
  std::vector<RfMode> modes{};
  bool operator==(const RfModeTable&) const = default;
};
struct UhfBand {
  static constexpr std::uint16_t kType = 144;
  std::vector<TransmitPower> powers{};
  FrequencyInformation frequencies{};
  std::vector<RfModeTable> mode_tables{};
  bool operator==(const UhfBand&) const = default;
};
struct RegulatoryCapabilities {
  static constexpr std::uint16_t kType = 143;
  std::uint16_t country{0};                  ///< ISO 3166
  std::uint16_t communications_standard{0};  ///< 1: US FCC part 15
  std::optional<UhfBand> uhf{};
  std::vector<CustomParameter> customs{};
  bool operator==(const RegulatoryCapabilities&) const = default;
};

struct C1G2Capabilities {
  static constexpr std::uint16_t kType = 327;
  bool block_erase{false};
  bool block_write{false};
  std::uint16_t select_filters{0};
  bool operator==(const C1G2Capabilities&) const = default;
};

}  // namespace sensotwin::robot::llrp
