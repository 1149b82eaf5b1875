// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/llrp/layout_access.hpp"
#include "robot/wire/llrp/layout_capabilities.hpp"
#include "robot/wire/llrp/layout_inventory.hpp"
#include "robot/wire/llrp/layout_report.hpp"
#include "robot/wire/llrp/messages.hpp"

/// Bodies of messages.hpp (LLRP 1.0.1, 16.1; parameters of GET_READER_CONFIG_RESPONSE in the order of a
/// recorded R420), both directions.
namespace sensotwin::robot::llrp {

template <class Io, MessageType Type>
void body_layout(Io& /*io*/, const EmptyMessage<Type>& /*v*/) {}
template <class Io, MessageType Type>
void body_layout(Io& io, IdMessage<Type>& v) {
  io.number(v.id);
}
template <class Io, MessageType Type>
void body_layout(Io& io, const IdMessage<Type>& v) {
  io.number(v.id);
}
template <class Io, MessageType Type>
void body_layout(Io& io, StatusMessage<Type>& v) {
  io.children([&](auto& slots) { slots.one(v.status); });
}
template <class Io, MessageType Type>
void body_layout(Io& io, const StatusMessage<Type>& v) {
  io.children([&](auto& slots) { slots.one(v.status); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetReaderCapabilities> v) {
  io.code(v.wanted, CapabilitiesWanted::kAirProtocol);
  io.children([&](auto& slots) { slots.customs(v.customs); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetReaderCapabilitiesResponse> v) {
  io.children([&](auto& slots) {
    slots.one(v.status);
    slots.maybe(v.general);
    slots.maybe(v.llrp);
    slots.maybe(v.regulatory);
    slots.maybe(v.c1g2);
    slots.customs(v.customs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetReaderConfig> v) {
  io.number(v.antenna);
  io.code(v.wanted, ConfigWanted::kEventsAndReports);
  io.number(v.gpi_port);
  io.number(v.gpo_port);
  io.children([&](auto& slots) { slots.customs(v.customs); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetReaderConfigResponse> v) {
  io.children([&](auto& slots) {
    slots.one(v.status);
    slots.maybe(v.identification);
    slots.list(v.antenna_properties);
    slots.list(v.antennas);
    slots.maybe(v.events);
    slots.maybe(v.ro_report);
    slots.maybe(v.access_report);
    slots.maybe(v.state);
    slots.maybe(v.keepalive);
    slots.list(v.inputs);
    slots.list(v.outputs);
    slots.maybe(v.events_and_reports);
    slots.customs(v.customs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<SetReaderConfig> v) {
  io.flags8(v.reset_to_factory);
  io.children([&](auto& slots) {
    slots.maybe(v.events);
    slots.list(v.antenna_properties);
    slots.list(v.antennas);
    slots.maybe(v.ro_report);
    slots.maybe(v.access_report);
    slots.maybe(v.keepalive);
    slots.list(v.outputs);
    slots.list(v.inputs);
    slots.maybe(v.events_and_reports);
    slots.customs(v.customs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<AddRoSpec> v) {
  io.children([&](auto& slots) { slots.one(v.spec); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetRoSpecsResponse> v) {
  io.children([&](auto& slots) {
    slots.one(v.status);
    slots.list(v.specs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<AddAccessSpec> v) {
  io.children([&](auto& slots) { slots.one(v.spec); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<GetAccessSpecsResponse> v) {
  io.children([&](auto& slots) {
    slots.one(v.status);
    slots.list(v.specs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<RoAccessReport> v) {
  io.children([&](auto& slots) {
    slots.list(v.tags);
    slots.customs(v.customs);
  });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<ReaderEventNotification> v) {
  io.children([&](auto& slots) { slots.one(v.event); });
}
template <class Io>
void impinj_header(Io& io, std::uint8_t subtype) {
  std::uint32_t vendor = kImpinj;
  io.number(vendor);
  io.number(subtype);
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<ImpinjEnableExtensions> /*v*/) {
  impinj_header(io, ImpinjEnableExtensions::kSubtype);
  io.reserved(4);
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<ImpinjEnableExtensionsResponse> v) {
  impinj_header(io, ImpinjEnableExtensionsResponse::kSubtype);
  io.children([&](auto& slots) { slots.one(v.status); });
}
template <class Io>
void body_layout(Io& io, typename Io::template Ref<CustomMessage> v) {
  io.number(v.vendor);
  io.number(v.subtype);
  io.rest(v.payload);
}

}  // namespace sensotwin::robot::llrp
