// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/llrp/inventory.hpp"

/// Layouts of inventory.hpp and report_spec.hpp (LLRP 1.0.1, 16.2.4, 16.2.6.6, 16.2.7.1, 16.3.1.2), both
/// directions.
namespace sensotwin::robot::llrp {

template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2InventoryMask> v) {
  io.two_bits(v.bank);
  io.number(v.bit_pointer);
  io.bits(v.mask);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2StateAwareFilterAction> v) {
  io.number(v.target);
  io.number(v.action);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2StateUnawareFilterAction> v) {
  io.number(v.action);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Filter> v) {
  io.two_bits(v.truncate);
  io.children([&](auto& slots) {
    slots.one(v.mask);
    slots.maybe(v.aware);
    slots.maybe(v.unaware);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2RfControl> v) {
  io.number(v.mode);
  io.number(v.tari_ns);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2StateAwareSingulation> v) {
  io.flags8(v.state_b, v.not_selected);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2SingulationControl> v) {
  io.two_bits(v.session);
  io.number(v.tag_population);
  io.number(v.tag_transit_ms);
  io.children([&](auto& slots) { slots.maybe(v.state_aware); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2InventoryCommand> v) {
  io.flags8(v.state_aware);
  io.children([&](auto& slots) {
    slots.list(v.filters);
    slots.maybe(v.rf_control);
    slots.maybe(v.singulation);
    slots.maybe(v.search_mode);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RfReceiver> v) {
  io.number(v.sensitivity_index);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RfTransmitter> v) {
  io.number(v.hop_table);
  io.number(v.channel);
  io.number(v.power_index);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AntennaConfiguration> v) {
  io.number(v.antenna);
  io.children([&](auto& slots) {
    slots.maybe(v.receiver);
    slots.maybe(v.transmitter);
    slots.list(v.inventory);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GpiTrigger> v) {
  io.number(v.port);
  io.flags8(v.on_high);
  io.number(v.timeout_ms);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<UtcTimestamp> v) {
  io.number(v.us);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<PeriodicTrigger> v) {
  io.number(v.offset_ms);
  io.number(v.period_ms);
  io.children([&](auto& slots) { slots.maybe(v.utc); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoSpecStartTrigger> v) {
  io.code(v.kind, RoStart::kGpi);
  io.children([&](auto& slots) {
    slots.maybe(v.periodic);
    slots.maybe(v.gpi);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoSpecStopTrigger> v) {
  io.code(v.kind, RoStop::kGpi);
  io.number(v.duration_ms);
  io.children([&](auto& slots) { slots.maybe(v.gpi); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoBoundary> v) {
  io.children([&](auto& slots) {
    slots.one(v.start);
    slots.one(v.stop);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<TagObservationTrigger> v) {
  io.code(v.kind, TagObservation::kAttempts);
  io.reserved(1);
  io.number(v.tags);
  io.number(v.attempts);
  io.number(v.idle_ms);
  io.number(v.timeout_ms);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AiSpecStopTrigger> v) {
  io.code(v.kind, AiStop::kTagObservation);
  io.number(v.duration_ms);
  io.children([&](auto& slots) {
    slots.maybe(v.gpi);
    slots.maybe(v.tags);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<InventoryParameterSpec> v) {
  io.number(v.id);
  io.number(v.protocol);
  io.children([&](auto& slots) {
    slots.list(v.antennas);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AiSpec> v) {
  io.counted(v.antennas);
  io.children([&](auto& slots) {
    slots.one(v.stop);
    slots.list(v.inventory, 1);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2EpcMemorySelector> v) {
  io.flags8(v.crc, v.pc);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<TagReportContent> v) {
  io.flags16(v.ro_spec_id, v.spec_index, v.inventory_spec_id, v.antenna_id, v.channel_index, v.peak_rssi,
             v.first_seen, v.last_seen, v.tag_seen_count, v.access_spec_id);
  io.children([&](auto& slots) { slots.list(v.memory); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<ImpinjReportContent> v) {
  io.children([&](auto& slots) {
    slots.maybe(v.serialized_tid);
    slots.maybe(v.phase_angle);
    slots.maybe(v.peak_rssi);
    slots.maybe(v.doppler);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoReportSpec> v) {
  io.code(v.trigger, RoReportTrigger::kTagsOrEndOfRoSpec);
  io.number(v.tags);
  io.children([&](auto& slots) {
    slots.one(v.content);
    slots.maybe(v.impinj);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AccessReportSpec> v) {
  io.code(v.trigger, AccessReportTrigger::kEndOfAccessSpec);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoSpec> v) {
  io.number(v.id);
  io.number(v.priority);
  io.code(v.state, RoSpecState::kActive);
  io.children([&](auto& slots) {
    slots.one(v.boundary);
    slots.list(v.ai_specs, 1);
    slots.maybe(v.report);
    slots.customs(v.customs);
  });
}

}  // namespace sensotwin::robot::llrp
