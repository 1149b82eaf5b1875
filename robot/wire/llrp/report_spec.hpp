// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/wire/llrp/custom.hpp"

/// When to report, and what (LLRP 1.0.1, 13.2.1 and 13.2.2; Impinj's selector: protocols study, 2.6).
namespace sensotwin::robot::llrp {

struct C1G2EpcMemorySelector {
  static constexpr std::uint16_t kType = 348;
  bool crc{false};
  bool pc{false};
  bool operator==(const C1G2EpcMemorySelector&) const = default;
};
struct TagReportContent {
  static constexpr std::uint16_t kType = 238;
  bool ro_spec_id{false};
  bool spec_index{false};
  bool inventory_spec_id{false};
  bool antenna_id{false};
  bool channel_index{false};
  bool peak_rssi{false};
  bool first_seen{false};
  bool last_seen{false};
  bool tag_seen_count{false};
  bool access_spec_id{false};
  std::vector<C1G2EpcMemorySelector> memory{};
  bool operator==(const TagReportContent&) const = default;
};
struct ImpinjReportContent {
  static constexpr std::uint16_t kType = 1023;
  static constexpr std::uint32_t kImpinjSubtype = 50;
  std::optional<ImpinjEnableSerializedTid> serialized_tid{};
  std::optional<ImpinjEnablePhaseAngle> phase_angle{};
  std::optional<ImpinjEnablePeakRssi> peak_rssi{};
  std::optional<ImpinjEnableDoppler> doppler{};
  std::vector<CustomParameter> customs{};
  bool operator==(const ImpinjReportContent&) const = default;
};
enum class RoReportTrigger : std::uint8_t {
  kNone,
  kTagsOrEndOfAiSpec,  ///< N entries, or the end of the AISpec
  kTagsOrEndOfRoSpec,
};
struct RoReportSpec {
  static constexpr std::uint16_t kType = 237;
  RoReportTrigger trigger{};
  std::uint16_t tags{0};  ///< N; 0: no limit
  TagReportContent content{};
  std::optional<ImpinjReportContent> impinj{};
  std::vector<CustomParameter> customs{};
  bool operator==(const RoReportSpec&) const = default;
};

enum class AccessReportTrigger : std::uint8_t {
  kWithRoReport,
  kEndOfAccessSpec,  ///< at once when the operations are done
};
struct AccessReportSpec {
  static constexpr std::uint16_t kType = 239;
  AccessReportTrigger trigger{};
  bool operator==(const AccessReportSpec&) const = default;
};

}  // namespace sensotwin::robot::llrp
