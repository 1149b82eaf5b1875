// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/wire/llrp/custom.hpp"
#include "robot/wire/llrp/inventory.hpp"

/// What a reader tells unasked (LLRP 1.0.1, 13.2.5 and 13.2.6).
namespace sensotwin::robot::llrp {

enum class EventKind : std::uint16_t {
  kHopping,
  kGpi,
  kRoSpec,
  kReportBufferFill,
  kReaderException,
  kRfSurvey,
  kAiSpec,
  kAiSpecWithDetails,
  kAntenna,
};
struct EventState {
  static constexpr std::uint16_t kType = 245;
  EventKind kind{};
  bool on{false};
  bool operator==(const EventState&) const = default;
};
struct EventSpec {
  static constexpr std::uint16_t kType = 244;
  std::vector<EventState> states{};
  bool operator==(const EventSpec&) const = default;
};

struct Uptime {
  static constexpr std::uint16_t kType = 129;
  std::uint64_t us{0};
  bool operator==(const Uptime&) const = default;
};
struct HoppingEvent {
  static constexpr std::uint16_t kType = 247;
  std::uint16_t hop_table{0};
  std::uint16_t next_channel{0};
  bool operator==(const HoppingEvent&) const = default;
};
struct GpiEvent {
  static constexpr std::uint16_t kType = 248;
  std::uint16_t port{0};
  bool high{false};
  bool operator==(const GpiEvent&) const = default;
};
enum class RoSpecEventKind : std::uint8_t { kStart, kEnd, kPreempted };
struct RoSpecEvent {
  static constexpr std::uint16_t kType = 249;
  RoSpecEventKind kind{};
  std::uint32_t ro_spec_id{0};
  std::uint32_t preempting_id{0};
  bool operator==(const RoSpecEvent&) const = default;
};
struct BufferWarningEvent {
  static constexpr std::uint16_t kType = 250;
  std::uint8_t percent{0};
  bool operator==(const BufferWarningEvent&) const = default;
};
struct BufferOverflowEvent {
  static constexpr std::uint16_t kType = 251;
  bool operator==(const BufferOverflowEvent&) const = default;
};
struct ReaderExceptionEvent {
  static constexpr std::uint16_t kType = 252;
  std::string message{};
  std::optional<std::uint32_t> ro_spec_id{};
  std::optional<std::uint16_t> spec_index{};
  std::optional<std::uint16_t> inventory_spec_id{};
  std::optional<std::uint16_t> antenna_id{};
  std::optional<std::uint32_t> access_spec_id{};
  std::optional<std::uint16_t> op_spec_id{};
  std::vector<CustomParameter> customs{};
  bool operator==(const ReaderExceptionEvent&) const = default;
};
enum class AiSpecEventKind : std::uint8_t { kEnd };
struct AiSpecEvent {
  static constexpr std::uint16_t kType = 254;
  AiSpecEventKind kind{};
  std::uint32_t ro_spec_id{0};
  std::uint16_t spec_index{0};
  std::optional<std::uint32_t> singulation{};  ///< C1G2: collision slots << 16 | empty slots
  bool operator==(const AiSpecEvent&) const = default;
};
enum class AntennaEventKind : std::uint8_t { kDisconnected, kConnected };
struct AntennaEvent {
  static constexpr std::uint16_t kType = 255;
  AntennaEventKind kind{};
  std::uint16_t antenna{0};
  bool operator==(const AntennaEvent&) const = default;
};
enum class ConnectionAttempt : std::uint16_t {
  kSuccess,
  kReaderInitiatedExists,
  kClientInitiatedExists,
  kFailed,
  kAnotherAttempted,  ///< told to the client that is connected
};
struct ConnectionAttemptEvent {
  static constexpr std::uint16_t kType = 256;
  ConnectionAttempt status{};
  bool operator==(const ConnectionAttemptEvent&) const = default;
};
struct ConnectionCloseEvent {
  static constexpr std::uint16_t kType = 257;
  bool operator==(const ConnectionCloseEvent&) const = default;
};

/// Of utc and uptime, one is there.
struct ReaderEvent {
  static constexpr std::uint16_t kType = 246;
  std::optional<UtcTimestamp> utc{};
  std::optional<Uptime> uptime{};
  std::optional<HoppingEvent> hopping{};
  std::optional<GpiEvent> gpi{};
  std::optional<RoSpecEvent> ro_spec{};
  std::optional<BufferWarningEvent> buffer_warning{};
  std::optional<BufferOverflowEvent> buffer_overflow{};
  std::optional<ReaderExceptionEvent> exception{};
  std::optional<AiSpecEvent> ai_spec{};
  std::optional<AntennaEvent> antenna{};
  std::optional<ConnectionAttemptEvent> connection_attempt{};
  std::optional<ConnectionCloseEvent> connection_close{};
  std::vector<CustomParameter> customs{};
  bool operator==(const ReaderEvent&) const = default;
};

}  // namespace sensotwin::robot::llrp
