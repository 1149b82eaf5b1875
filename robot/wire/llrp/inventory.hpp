// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/wire/llrp/bit_array.hpp"
#include "robot/wire/llrp/custom.hpp"
#include "robot/wire/llrp/report_spec.hpp"

/// What to read, when and through which antennas: the ROSpec and what is in it (LLRP 1.0.1, 10.2, 12.2.6,
/// 15.2.1.2).
namespace sensotwin::robot::llrp {

enum class MemoryBank : std::uint8_t { kReserved, kEpc, kTid, kUser };

struct C1G2InventoryMask {
  static constexpr std::uint16_t kType = 332;
  MemoryBank bank{};
  std::uint16_t bit_pointer{0};
  BitArray mask{};
  bool operator==(const C1G2InventoryMask&) const = default;
};
struct C1G2StateAwareFilterAction {
  static constexpr std::uint16_t kType = 333;
  std::uint8_t target{0};
  std::uint8_t action{0};
  bool operator==(const C1G2StateAwareFilterAction&) const = default;
};
struct C1G2StateUnawareFilterAction {
  static constexpr std::uint16_t kType = 334;
  std::uint8_t action{0};
  bool operator==(const C1G2StateUnawareFilterAction&) const = default;
};
struct C1G2Filter {
  static constexpr std::uint16_t kType = 331;
  std::uint8_t truncate{0};  ///< 0 unspecified, 1 do not, 2 do
  C1G2InventoryMask mask{};
  std::optional<C1G2StateAwareFilterAction> aware{};
  std::optional<C1G2StateUnawareFilterAction> unaware{};
  bool operator==(const C1G2Filter&) const = default;
};
struct C1G2RfControl {
  static constexpr std::uint16_t kType = 335;
  std::uint16_t mode{0};  ///< id of an RfMode
  std::uint16_t tari_ns{0};
  bool operator==(const C1G2RfControl&) const = default;
};
struct C1G2StateAwareSingulation {
  static constexpr std::uint16_t kType = 337;
  bool state_b{false};
  bool not_selected{false};
  bool operator==(const C1G2StateAwareSingulation&) const = default;
};
struct C1G2SingulationControl {
  static constexpr std::uint16_t kType = 336;
  std::uint8_t session{0};  ///< 0 to 3
  std::uint16_t tag_population{0};
  std::uint32_t tag_transit_ms{0};
  std::optional<C1G2StateAwareSingulation> state_aware{};
  bool operator==(const C1G2SingulationControl&) const = default;
};
struct C1G2InventoryCommand {
  static constexpr std::uint16_t kType = 330;
  bool state_aware{false};
  std::vector<C1G2Filter> filters{};
  std::optional<C1G2RfControl> rf_control{};
  std::optional<C1G2SingulationControl> singulation{};
  std::optional<ImpinjSearchMode> search_mode{};
  std::vector<CustomParameter> customs{};
  bool operator==(const C1G2InventoryCommand&) const = default;
};

struct RfReceiver {
  static constexpr std::uint16_t kType = 223;
  std::uint16_t sensitivity_index{0};
  bool operator==(const RfReceiver&) const = default;
};
struct RfTransmitter {
  static constexpr std::uint16_t kType = 224;
  std::uint16_t hop_table{0};
  std::uint16_t channel{0};
  std::uint16_t power_index{0};
  bool operator==(const RfTransmitter&) const = default;
};
struct AntennaConfiguration {
  static constexpr std::uint16_t kType = 222;
  std::uint16_t antenna{0};  ///< 0: all
  std::optional<RfReceiver> receiver{};
  std::optional<RfTransmitter> transmitter{};
  std::vector<C1G2InventoryCommand> inventory{};
  bool operator==(const AntennaConfiguration&) const = default;
};

struct GpiTrigger {
  static constexpr std::uint16_t kType = 181;
  std::uint16_t port{0};
  bool on_high{false};
  std::uint32_t timeout_ms{0};
  bool operator==(const GpiTrigger&) const = default;
};
struct UtcTimestamp {
  static constexpr std::uint16_t kType = 128;
  std::uint64_t us{0};  ///< since 1970
  bool operator==(const UtcTimestamp&) const = default;
};
struct PeriodicTrigger {
  static constexpr std::uint16_t kType = 180;
  std::uint32_t offset_ms{0};
  std::uint32_t period_ms{0};
  std::optional<UtcTimestamp> utc{};
  bool operator==(const PeriodicTrigger&) const = default;
};
enum class RoStart : std::uint8_t { kNull, kImmediate, kPeriodic, kGpi };
struct RoSpecStartTrigger {
  static constexpr std::uint16_t kType = 179;
  RoStart kind{};
  std::optional<PeriodicTrigger> periodic{};
  std::optional<GpiTrigger> gpi{};
  bool operator==(const RoSpecStartTrigger&) const = default;
};
enum class RoStop : std::uint8_t { kNull, kDuration, kGpi };
struct RoSpecStopTrigger {
  static constexpr std::uint16_t kType = 182;
  RoStop kind{};
  std::uint32_t duration_ms{0};
  std::optional<GpiTrigger> gpi{};
  bool operator==(const RoSpecStopTrigger&) const = default;
};
struct RoBoundary {
  static constexpr std::uint16_t kType = 178;
  RoSpecStartTrigger start{};
  RoSpecStopTrigger stop{};
  bool operator==(const RoBoundary&) const = default;
};

enum class TagObservation : std::uint8_t { kCount, kNoNewTags, kAttempts };
struct TagObservationTrigger {
  static constexpr std::uint16_t kType = 185;
  TagObservation kind{};
  std::uint16_t tags{0};
  std::uint16_t attempts{0};
  std::uint16_t idle_ms{0};
  std::uint32_t timeout_ms{0};  ///< 0: none
  bool operator==(const TagObservationTrigger&) const = default;
};
enum class AiStop : std::uint8_t { kNull, kDuration, kGpi, kTagObservation };
struct AiSpecStopTrigger {
  static constexpr std::uint16_t kType = 184;
  AiStop kind{};
  std::uint32_t duration_ms{0};
  std::optional<GpiTrigger> gpi{};
  std::optional<TagObservationTrigger> tags{};
  bool operator==(const AiSpecStopTrigger&) const = default;
};
struct InventoryParameterSpec {
  static constexpr std::uint16_t kType = 186;
  std::uint16_t id{0};
  std::uint8_t protocol{1};  ///< 1: EPCglobal Class 1 Gen 2
  std::vector<AntennaConfiguration> antennas{};
  std::vector<CustomParameter> customs{};
  bool operator==(const InventoryParameterSpec&) const = default;
};
struct AiSpec {
  static constexpr std::uint16_t kType = 183;
  std::vector<std::uint16_t> antennas{};  ///< 0: all
  AiSpecStopTrigger stop{};
  std::vector<InventoryParameterSpec> inventory{};
  std::vector<CustomParameter> customs{};
  bool operator==(const AiSpec&) const = default;
};

enum class RoSpecState : std::uint8_t { kDisabled, kInactive, kActive };
struct RoSpec {
  static constexpr std::uint16_t kType = 177;
  std::uint32_t id{0};
  std::uint8_t priority{0};
  RoSpecState state{};
  RoBoundary boundary{};
  std::vector<AiSpec> ai_specs{};
  std::vector<CustomParameter> customs{};
  std::optional<RoReportSpec> report{};
  bool operator==(const RoSpec&) const = default;
};

}  // namespace sensotwin::robot::llrp
