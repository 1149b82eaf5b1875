// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_requests.hpp"

#include <algorithm>
#include <utility>

#include "twin/devices/uhf_ro_spec.hpp"

namespace sensotwin::twin {
namespace llrp = robot::llrp;
using llrp::MessageType;
using llrp::StatusCode;
namespace {

[[nodiscard]] llrp::LlrpStatus check(const std::vector<llrp::CustomParameter>& customs, bool extended) {
  const bool fine = std::ranges::all_of(
      customs, [extended](const auto& custom) { return extended && custom.vendor == llrp::kImpinj; });
  return fine ? llrp::LlrpStatus{}
              : refused(llrp::CustomParameter::kType, StatusCode::kInUnsupportedParameter);
}

/// The first of several that refuses.
[[nodiscard]] llrp::LlrpStatus first_of(std::initializer_list<llrp::LlrpStatus> statuses) {
  const auto bad = std::ranges::find_if(statuses, [](const auto& status) { return !status.ok(); });
  return bad == statuses.end() ? llrp::LlrpStatus{} : *bad;
}

[[nodiscard]] llrp::LlrpStatus impinj_only_if(bool present, bool extended) {
  return present && !extended ? refused(llrp::CustomParameter::kType, StatusCode::kInUnsupportedParameter)
                              : llrp::LlrpStatus{};
}

[[nodiscard]] llrp::LlrpStatus check(const std::vector<llrp::AntennaConfiguration>& antennas, bool extended) {
  for (const auto& antenna : antennas) {
    for (const auto& command : antenna.inventory) {
      if (auto status = first_of(
              {check(command.customs, extended), impinj_only_if(command.search_mode.has_value(), extended)});
          !status.ok()) {
        return status;
      }
    }
  }
  return {};
}

[[nodiscard]] llrp::LlrpStatus check(const std::optional<llrp::RoReportSpec>& report, bool extended) {
  return report ? first_of({check(report->customs, extended),
                            impinj_only_if(report->impinj.has_value(), extended)})
                : llrp::LlrpStatus{};
}

template <MessageType Type>
[[nodiscard]] llrp::Message status_message(const llrp::LlrpStatus& status) {
  return llrp::StatusMessage<Type>{status};
}

}  // namespace

std::optional<llrp::Message> refusal_of(MessageType request, const llrp::LlrpStatus& status) {
  switch (request) {
    case MessageType::kGetReaderCapabilities:
      return llrp::GetReaderCapabilitiesResponse{.status = status};
    case MessageType::kGetReaderConfig:
      return llrp::GetReaderConfigResponse{.status = status};
    case MessageType::kSetReaderConfig:
      return status_message<MessageType::kSetReaderConfigResponse>(status);
    case MessageType::kCloseConnection:
      return status_message<MessageType::kCloseConnectionResponse>(status);
    case MessageType::kAddRoSpec:
      return status_message<MessageType::kAddRoSpecResponse>(status);
    case MessageType::kDeleteRoSpec:
      return status_message<MessageType::kDeleteRoSpecResponse>(status);
    case MessageType::kStartRoSpec:
      return status_message<MessageType::kStartRoSpecResponse>(status);
    case MessageType::kStopRoSpec:
      return status_message<MessageType::kStopRoSpecResponse>(status);
    case MessageType::kEnableRoSpec:
      return status_message<MessageType::kEnableRoSpecResponse>(status);
    case MessageType::kDisableRoSpec:
      return status_message<MessageType::kDisableRoSpecResponse>(status);
    case MessageType::kGetRoSpecs:
      return llrp::GetRoSpecsResponse{.status = status};
    case MessageType::kAddAccessSpec:
      return status_message<MessageType::kAddAccessSpecResponse>(status);
    case MessageType::kDeleteAccessSpec:
      return status_message<MessageType::kDeleteAccessSpecResponse>(status);
    case MessageType::kEnableAccessSpec:
      return status_message<MessageType::kEnableAccessSpecResponse>(status);
    case MessageType::kDisableAccessSpec:
      return status_message<MessageType::kDisableAccessSpecResponse>(status);
    case MessageType::kGetAccessSpecs:
      return llrp::GetAccessSpecsResponse{.status = status};
    case MessageType::kKeepaliveAck:
    case MessageType::kErrorMessage:
    case MessageType::kEnableEventsAndReports:
      return std::nullopt;
    default:
      return llrp::ErrorMessage{status};
  }
}

llrp::LlrpStatus check_customs(const llrp::RoSpec& spec, bool extended) {
  if (auto status = first_of({check(spec.customs, extended), check(spec.report, extended)}); !status.ok()) {
    return status;
  }
  for (const llrp::AiSpec& ai_spec : spec.ai_specs) {
    for (const llrp::InventoryParameterSpec& inventory : ai_spec.inventory) {
      if (auto status = first_of({check(ai_spec.customs, extended), check(inventory.customs, extended),
                                  check(inventory.antennas, extended)});
          !status.ok()) {
        return status;
      }
    }
  }
  return {};
}

llrp::LlrpStatus check_customs(const llrp::SetReaderConfig& request, bool extended) {
  return first_of({check(request.customs, extended), check(request.antennas, extended),
                   check(request.ro_report, extended)});
}

llrp::LlrpStatus check_customs(const llrp::AccessSpec& spec, bool extended) {
  return first_of({check(spec.customs, extended), check(spec.command.customs, extended)});
}

llrp::GetReaderConfigResponse part_of(const llrp::GetReaderConfigResponse& all,
                                      const llrp::GetReaderConfig& request) {
  using Wanted = llrp::ConfigWanted;
  const auto wants = [&request](Wanted part) {
    return request.wanted == Wanted::kAll || request.wanted == part;
  };
  const auto only = [](const auto& list, std::uint16_t number, auto field) {
    auto out = list;
    std::erase_if(out, [&](const auto& each) { return number != 0 && each.*field != number; });
    return out;
  };
  llrp::GetReaderConfigResponse out;
  out.identification = wants(Wanted::kIdentification) ? all.identification : std::nullopt;
  if (wants(Wanted::kAntennaProperties)) {
    out.antenna_properties = only(all.antenna_properties, request.antenna, &llrp::AntennaProperties::antenna);
  }
  if (wants(Wanted::kAntennaConfiguration)) {
    out.antennas = only(all.antennas, request.antenna, &llrp::AntennaConfiguration::antenna);
  }
  out.events = wants(Wanted::kReaderEvents) ? all.events : std::nullopt;
  out.ro_report = wants(Wanted::kRoReportSpec) ? all.ro_report : std::nullopt;
  out.access_report = wants(Wanted::kAccessReportSpec) ? all.access_report : std::nullopt;
  out.state = wants(Wanted::kConfigurationState) ? all.state : std::nullopt;
  out.keepalive = wants(Wanted::kKeepalive) ? all.keepalive : std::nullopt;
  if (wants(Wanted::kGpiPorts)) {
    out.inputs = only(all.inputs, request.gpi_port, &llrp::GpiPortState::port);
  }
  if (wants(Wanted::kGpoPorts)) {
    out.outputs = only(all.outputs, request.gpo_port, &llrp::GpoWrite::port);
  }
  out.events_and_reports = wants(Wanted::kEventsAndReports) ? all.events_and_reports : std::nullopt;
  return out;
}

llrp::LlrpStatus apply(const llrp::SetReaderConfig& request, const UhfReaderSettings& settings,
                       llrp::GetReaderConfigResponse& config) {
  llrp::GetReaderConfigResponse next =
      request.reset_to_factory ? uhf_factory_configuration(settings) : config;
  for (const llrp::AntennaConfiguration& wanted : request.antennas) {
    if (wanted.antenna > settings.antennas) {
      return refused_field_in(llrp::AntennaConfiguration::kType, 1, StatusCode::kFieldOutOfRange);
    }
    for (llrp::AntennaConfiguration& antenna : next.antennas) {
      if (wanted.antenna == 0 || wanted.antenna == antenna.antenna) {
        antenna.receiver = wanted.receiver ? wanted.receiver : antenna.receiver;
        antenna.transmitter = wanted.transmitter ? wanted.transmitter : antenna.transmitter;
        antenna.inventory = wanted.inventory.empty() ? antenna.inventory : wanted.inventory;
      }
    }
  }
  for (const llrp::GpoWrite& wanted : request.outputs) {
    const auto port = std::ranges::find(next.outputs, wanted.port, &llrp::GpoWrite::port);
    if (port == next.outputs.end()) {
      return refused_field_in(llrp::GpoWrite::kType, 1, StatusCode::kFieldOutOfRange);
    }
    *port = wanted;
  }
  if (request.events) {
    for (const llrp::EventState& wanted : request.events->states) {
      next.events->states[static_cast<std::size_t>(wanted.kind)] = wanted;
    }
  }
  next.ro_report = request.ro_report ? request.ro_report : next.ro_report;
  next.access_report = request.access_report ? request.access_report : next.access_report;
  next.keepalive = request.keepalive ? request.keepalive : next.keepalive;
  next.events_and_reports = request.events_and_reports ? request.events_and_reports : next.events_and_reports;
  ++next.state->value;
  config = std::move(next);
  return {};
}

}  // namespace sensotwin::twin
