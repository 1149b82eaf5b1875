// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/epc.hpp"
#include "robot/wire/llrp/access.hpp"
#include "robot/wire/llrp/bit_array.hpp"
#include "robot/wire/llrp/custom.hpp"

/// What a reader tells of a tag (LLRP 1.0.1, 13.2.3; Impinj's fields: protocols study, 2.4).
namespace sensotwin::robot::llrp {

/// An EPC of other than 96 bits.
struct EpcData {
  static constexpr std::uint16_t kType = 241;
  BitArray bits{};
  bool operator==(const EpcData&) const = default;
};
struct ImpinjSerializedTid {
  static constexpr std::uint16_t kType = 1023;
  static constexpr std::uint32_t kImpinjSubtype = 55;
  std::vector<std::uint16_t> words{};
  bool operator==(const ImpinjSerializedTid&) const = default;
};

/// One entry of a report. Of epc_96 and epc, one is there.
struct TagReport {
  static constexpr std::uint16_t kType = 240;
  std::optional<Epc> epc_96{};
  std::optional<EpcData> epc{};
  std::optional<std::uint32_t> ro_spec_id{};
  std::optional<std::uint16_t> spec_index{};
  std::optional<std::uint16_t> inventory_spec_id{};
  std::optional<std::uint16_t> antenna_id{};
  std::optional<std::int8_t> peak_rssi_dbm{};
  std::optional<std::uint16_t> channel_index{};  ///< position in the hop table, 1 the first
  std::optional<std::uint64_t> first_seen_utc_us{};
  std::optional<std::uint64_t> first_seen_uptime_us{};
  std::optional<std::uint64_t> last_seen_utc_us{};
  std::optional<std::uint64_t> last_seen_uptime_us{};
  std::optional<std::uint16_t> seen_count{};
  std::optional<std::uint16_t> pc{};
  std::optional<std::uint16_t> crc{};
  std::optional<std::uint32_t> access_spec_id{};
  std::vector<C1G2OpResult> results{};
  std::optional<ImpinjSerializedTid> serialized_tid{};
  std::optional<ImpinjPhaseAngle> phase_angle{};
  std::optional<ImpinjPeakRssi> impinj_rssi{};
  std::optional<ImpinjDopplerFrequency> doppler{};
  std::vector<CustomParameter> customs{};
  bool operator==(const TagReport&) const = default;
};

}  // namespace sensotwin::robot::llrp
