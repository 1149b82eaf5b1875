// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "robot/wire/llrp/access.hpp"
#include "robot/wire/llrp/capabilities.hpp"
#include "robot/wire/llrp/events.hpp"
#include "robot/wire/llrp/inventory.hpp"
#include "robot/wire/llrp/message_type.hpp"
#include "robot/wire/llrp/reader_config.hpp"
#include "robot/wire/llrp/report.hpp"
#include "robot/wire/llrp/status.hpp"

/// The messages of LLRP 1.0.1 (16.1) and Impinj's one. The header's id is not part of them.
namespace sensotwin::robot::llrp {

/// A message without a body.
template <MessageType Type>
struct EmptyMessage {
  static constexpr MessageType kMessage = Type;
  bool operator==(const EmptyMessage&) const = default;
};
/// A message that is the id of a ROSpec or AccessSpec; 0 means all of them where that is allowed.
template <MessageType Type>
struct IdMessage {
  static constexpr MessageType kMessage = Type;
  std::uint32_t id{0};
  bool operator==(const IdMessage&) const = default;
};
/// A message that is a status.
template <MessageType Type>
struct StatusMessage {
  static constexpr MessageType kMessage = Type;
  LlrpStatus status{};
  bool operator==(const StatusMessage&) const = default;
};

enum class CapabilitiesWanted : std::uint8_t { kAll, kGeneral, kLlrp, kRegulatory, kAirProtocol };
struct GetReaderCapabilities {
  static constexpr MessageType kMessage = MessageType::kGetReaderCapabilities;
  CapabilitiesWanted wanted{};
  std::vector<CustomParameter> customs{};
  bool operator==(const GetReaderCapabilities&) const = default;
};
struct GetReaderCapabilitiesResponse {
  static constexpr MessageType kMessage = MessageType::kGetReaderCapabilitiesResponse;
  LlrpStatus status{};
  std::optional<GeneralCapabilities> general{};
  std::optional<LlrpCapabilities> llrp{};
  std::optional<RegulatoryCapabilities> regulatory{};
  std::optional<C1G2Capabilities> c1g2{};
  std::vector<CustomParameter> customs{};
  bool operator==(const GetReaderCapabilitiesResponse&) const = default;
};

/// In the order of LLRP's enumeration (12.1.1).
enum class ConfigWanted : std::uint8_t {
  kAll,
  kIdentification,
  kAntennaProperties,
  kAntennaConfiguration,
  kRoReportSpec,
  kReaderEvents,
  kAccessReportSpec,
  kConfigurationState,
  kKeepalive,
  kGpiPorts,
  kGpoPorts,
  kEventsAndReports,
};
struct GetReaderConfig {
  static constexpr MessageType kMessage = MessageType::kGetReaderConfig;
  std::uint16_t antenna{0};  ///< 0: all
  ConfigWanted wanted{};
  std::uint16_t gpi_port{0};
  std::uint16_t gpo_port{0};
  std::vector<CustomParameter> customs{};
  bool operator==(const GetReaderConfig&) const = default;
};
struct GetReaderConfigResponse {
  static constexpr MessageType kMessage = MessageType::kGetReaderConfigResponse;
  LlrpStatus status{};
  std::optional<Identification> identification{};
  std::vector<AntennaProperties> antenna_properties{};
  std::vector<AntennaConfiguration> antennas{};
  std::optional<EventSpec> events{};
  std::optional<RoReportSpec> ro_report{};
  std::optional<AccessReportSpec> access_report{};
  std::optional<ConfigurationState> state{};
  std::optional<KeepaliveSpec> keepalive{};
  std::vector<GpiPortState> inputs{};
  std::vector<GpoWrite> outputs{};
  std::optional<EventsAndReports> events_and_reports{};
  std::vector<CustomParameter> customs{};
  bool operator==(const GetReaderConfigResponse&) const = default;
};
struct SetReaderConfig {
  static constexpr MessageType kMessage = MessageType::kSetReaderConfig;
  bool reset_to_factory{false};
  std::optional<EventSpec> events{};
  std::vector<AntennaProperties> antenna_properties{};
  std::vector<AntennaConfiguration> antennas{};
  std::optional<RoReportSpec> ro_report{};
  std::optional<AccessReportSpec> access_report{};
  std::optional<KeepaliveSpec> keepalive{};
  std::vector<GpoWrite> outputs{};
  std::vector<GpiPortState> inputs{};
  std::optional<EventsAndReports> events_and_reports{};
  std::vector<CustomParameter> customs{};
  bool operator==(const SetReaderConfig&) const = default;
};

struct AddRoSpec {
  static constexpr MessageType kMessage = MessageType::kAddRoSpec;
  RoSpec spec{};
  bool operator==(const AddRoSpec&) const = default;
};
struct GetRoSpecsResponse {
  static constexpr MessageType kMessage = MessageType::kGetRoSpecsResponse;
  LlrpStatus status{};
  std::vector<RoSpec> specs{};
  bool operator==(const GetRoSpecsResponse&) const = default;
};
struct AddAccessSpec {
  static constexpr MessageType kMessage = MessageType::kAddAccessSpec;
  AccessSpec spec{};
  bool operator==(const AddAccessSpec&) const = default;
};
struct GetAccessSpecsResponse {
  static constexpr MessageType kMessage = MessageType::kGetAccessSpecsResponse;
  LlrpStatus status{};
  std::vector<AccessSpec> specs{};
  bool operator==(const GetAccessSpecsResponse&) const = default;
};

struct RoAccessReport {
  static constexpr MessageType kMessage = MessageType::kRoAccessReport;
  std::vector<TagReport> tags{};
  std::vector<CustomParameter> customs{};
  bool operator==(const RoAccessReport&) const = default;
};
struct ReaderEventNotification {
  static constexpr MessageType kMessage = MessageType::kReaderEventNotification;
  ReaderEvent event{};
  bool operator==(const ReaderEventNotification&) const = default;
};

/// Asks an Impinj reader to understand and use Impinj's parameters on this connection (protocols study, 2.6).
struct ImpinjEnableExtensions {
  static constexpr MessageType kMessage = MessageType::kCustomMessage;
  static constexpr std::uint8_t kSubtype = 21;
  bool operator==(const ImpinjEnableExtensions&) const = default;
};
struct ImpinjEnableExtensionsResponse {
  static constexpr MessageType kMessage = MessageType::kCustomMessage;
  static constexpr std::uint8_t kSubtype = 22;
  LlrpStatus status{};
  bool operator==(const ImpinjEnableExtensionsResponse&) const = default;
};
/// Any other custom message, kept as it came.
struct CustomMessage {
  static constexpr MessageType kMessage = MessageType::kCustomMessage;
  std::uint32_t vendor{0};
  std::uint8_t subtype{0};
  Bytes payload{};
  bool operator==(const CustomMessage&) const = default;
};

using AddRoSpecResponse = StatusMessage<MessageType::kAddRoSpecResponse>;
using DeleteRoSpec = IdMessage<MessageType::kDeleteRoSpec>;
using DeleteRoSpecResponse = StatusMessage<MessageType::kDeleteRoSpecResponse>;
using StartRoSpec = IdMessage<MessageType::kStartRoSpec>;
using StartRoSpecResponse = StatusMessage<MessageType::kStartRoSpecResponse>;
using StopRoSpec = IdMessage<MessageType::kStopRoSpec>;
using StopRoSpecResponse = StatusMessage<MessageType::kStopRoSpecResponse>;
using EnableRoSpec = IdMessage<MessageType::kEnableRoSpec>;
using EnableRoSpecResponse = StatusMessage<MessageType::kEnableRoSpecResponse>;
using DisableRoSpec = IdMessage<MessageType::kDisableRoSpec>;
using DisableRoSpecResponse = StatusMessage<MessageType::kDisableRoSpecResponse>;
using GetRoSpecs = EmptyMessage<MessageType::kGetRoSpecs>;
using AddAccessSpecResponse = StatusMessage<MessageType::kAddAccessSpecResponse>;
using DeleteAccessSpec = IdMessage<MessageType::kDeleteAccessSpec>;
using DeleteAccessSpecResponse = StatusMessage<MessageType::kDeleteAccessSpecResponse>;
using EnableAccessSpec = IdMessage<MessageType::kEnableAccessSpec>;
using EnableAccessSpecResponse = StatusMessage<MessageType::kEnableAccessSpecResponse>;
using DisableAccessSpec = IdMessage<MessageType::kDisableAccessSpec>;
using DisableAccessSpecResponse = StatusMessage<MessageType::kDisableAccessSpecResponse>;
using GetAccessSpecs = EmptyMessage<MessageType::kGetAccessSpecs>;
using SetReaderConfigResponse = StatusMessage<MessageType::kSetReaderConfigResponse>;
using CloseConnection = EmptyMessage<MessageType::kCloseConnection>;
using CloseConnectionResponse = StatusMessage<MessageType::kCloseConnectionResponse>;
using GetReport = EmptyMessage<MessageType::kGetReport>;
using Keepalive = EmptyMessage<MessageType::kKeepalive>;
using KeepaliveAck = EmptyMessage<MessageType::kKeepaliveAck>;
using EnableEventsAndReports = EmptyMessage<MessageType::kEnableEventsAndReports>;
using ErrorMessage = StatusMessage<MessageType::kErrorMessage>;

/// Reports first: they are what comes often.
using Message =
    std::variant<RoAccessReport, Keepalive, KeepaliveAck, ReaderEventNotification, GetReaderCapabilities,
                 GetReaderCapabilitiesResponse, GetReaderConfig, GetReaderConfigResponse, SetReaderConfig,
                 SetReaderConfigResponse, AddRoSpec, AddRoSpecResponse, DeleteRoSpec, DeleteRoSpecResponse,
                 StartRoSpec, StartRoSpecResponse, StopRoSpec, StopRoSpecResponse, EnableRoSpec,
                 EnableRoSpecResponse, DisableRoSpec, DisableRoSpecResponse, GetRoSpecs, GetRoSpecsResponse,
                 AddAccessSpec, AddAccessSpecResponse, DeleteAccessSpec, DeleteAccessSpecResponse,
                 EnableAccessSpec, EnableAccessSpecResponse, DisableAccessSpec, DisableAccessSpecResponse,
                 GetAccessSpecs, GetAccessSpecsResponse, CloseConnection, CloseConnectionResponse, GetReport,
                 EnableEventsAndReports, ErrorMessage, ImpinjEnableExtensions, ImpinjEnableExtensionsResponse,
                 CustomMessage>;

[[nodiscard]] MessageType type_of(const Message& message);

}  // namespace sensotwin::robot::llrp
