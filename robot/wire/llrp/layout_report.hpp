// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "robot/wire/llrp/custom.hpp"
#include "robot/wire/llrp/events.hpp"
#include "robot/wire/llrp/reader.hpp"
#include "robot/wire/llrp/reader_config.hpp"
#include "robot/wire/llrp/report.hpp"
#include "robot/wire/llrp/status.hpp"

/// Layouts of report.hpp, events.hpp, reader_config.hpp, status.hpp and custom.hpp (LLRP 1.0.1, 16.2.6 to
/// 16.2.9), both directions.
namespace sensotwin::robot::llrp {

template <class Io>
void layout(Io& io, typename Io::template Ref<CustomParameter> v) {
  io.number(v.vendor);
  io.number(v.subtype);
  io.rest(v.value);
}
template <class Io, std::uint32_t Subtype, class Number>
void layout(Io& io, ImpinjNumber<Subtype, Number>& v) {
  io.number(v.value);
}
template <class Io, std::uint32_t Subtype, class Number>
void layout(Io& io, const ImpinjNumber<Subtype, Number>& v) {
  io.number(v.value);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<ImpinjSerializedTid> v) {
  io.counted(v.words);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<EpcData> v) {
  io.bits(v.bits);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<TagReport> v) {
  io.children([&](auto& slots) {
    slots.tv(13, v.epc_96);
    slots.maybe(v.epc);
    slots.tv(9, v.ro_spec_id);
    slots.tv(14, v.spec_index);
    slots.tv(10, v.inventory_spec_id);
    slots.tv(1, v.antenna_id);
    slots.tv(6, v.peak_rssi_dbm);
    slots.tv(7, v.channel_index);
    slots.tv(2, v.first_seen_utc_us);
    slots.tv(3, v.first_seen_uptime_us);
    slots.tv(4, v.last_seen_utc_us);
    slots.tv(5, v.last_seen_uptime_us);
    slots.tv(8, v.seen_count);
    slots.tv(12, v.pc);
    slots.tv(11, v.crc);
    slots.tv(16, v.access_spec_id);
    slots.any_of(v.results);
    slots.maybe(v.serialized_tid);
    slots.maybe(v.phase_angle);
    slots.maybe(v.impinj_rssi);
    slots.maybe(v.doppler);
    slots.customs(v.customs);
  });
  if constexpr (std::is_same_v<Io, Reader>) {
    if (v.epc_96.has_value() == v.epc.has_value()) {
      io.fail_about(v.epc ? Fault::kDuplicateParameter : Fault::kMissingParameter, EpcData::kType);
    }
  }
}

template <class Io>
void layout(Io& io, typename Io::template Ref<EventState> v) {
  io.code(v.kind, EventKind::kAntenna);
  io.flags8(v.on);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<EventSpec> v) {
  io.children([&](auto& slots) { slots.list(v.states, 1); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<Uptime> v) {
  io.number(v.us);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<HoppingEvent> v) {
  io.number(v.hop_table);
  io.number(v.next_channel);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GpiEvent> v) {
  io.number(v.port);
  io.flags8(v.high);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RoSpecEvent> v) {
  io.code(v.kind, RoSpecEventKind::kPreempted);
  io.number(v.ro_spec_id);
  io.number(v.preempting_id);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<BufferWarningEvent> v) {
  io.number(v.percent);
}
template <class Io>
void layout(Io& /*io*/, typename Io::template Ref<BufferOverflowEvent> /*v*/) {}
template <class Io>
void layout(Io& io, typename Io::template Ref<ReaderExceptionEvent> v) {
  io.text(v.message);
  io.children([&](auto& slots) {
    slots.tv(9, v.ro_spec_id);
    slots.tv(14, v.spec_index);
    slots.tv(10, v.inventory_spec_id);
    slots.tv(1, v.antenna_id);
    slots.tv(16, v.access_spec_id);
    slots.tv(17, v.op_spec_id);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AiSpecEvent> v) {
  io.code(v.kind, AiSpecEventKind::kEnd);
  io.number(v.ro_spec_id);
  io.number(v.spec_index);
  io.children([&](auto& slots) { slots.tv(18, v.singulation); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AntennaEvent> v) {
  io.code(v.kind, AntennaEventKind::kConnected);
  io.number(v.antenna);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<ConnectionAttemptEvent> v) {
  io.code(v.status, ConnectionAttempt::kAnotherAttempted);
}
template <class Io>
void layout(Io& /*io*/, typename Io::template Ref<ConnectionCloseEvent> /*v*/) {}
template <class Io>
void layout(Io& io, typename Io::template Ref<ReaderEvent> v) {
  io.children([&](auto& slots) {
    slots.maybe(v.utc);
    slots.maybe(v.uptime);
    slots.maybe(v.hopping);
    slots.maybe(v.gpi);
    slots.maybe(v.ro_spec);
    slots.maybe(v.buffer_warning);
    slots.maybe(v.buffer_overflow);
    slots.maybe(v.exception);
    slots.maybe(v.ai_spec);
    slots.maybe(v.antenna);
    slots.maybe(v.connection_attempt);
    slots.maybe(v.connection_close);
    slots.customs(v.customs);
  });
  if constexpr (std::is_same_v<Io, Reader>) {
    if (v.utc.has_value() == v.uptime.has_value()) {
      io.fail_about(v.utc ? Fault::kDuplicateParameter : Fault::kMissingParameter, UtcTimestamp::kType);
    }
  }
}

template <class Io>
void layout(Io& io, typename Io::template Ref<ConfigurationState> v) {
  io.number(v.value);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<Identification> v) {
  io.number(v.kind);
  io.counted_bytes(v.id);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GpoWrite> v) {
  io.number(v.port);
  io.flags8(v.high);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<KeepaliveSpec> v) {
  io.code(v.trigger, KeepaliveTrigger::kPeriodic);
  io.number(v.period_ms);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<AntennaProperties> v) {
  io.flags8(v.connected);
  io.number(v.antenna);
  io.number(v.gain_centi_dbi);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GpiPortState> v) {
  io.number(v.port);
  io.flags8(v.enabled);
  io.code(v.state, GpiState::kUnknown);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<EventsAndReports> v) {
  io.flags8(v.hold_upon_reconnect);
}

template <class Io>
void layout(Io& io, typename Io::template Ref<FieldError> v) {
  io.number(v.field);
  io.open_code(v.code);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<ParameterError> v) {
  io.number(v.parameter);
  io.open_code(v.code);
  io.children([&](auto& slots) {
    slots.maybe(v.field_error);
    slots.list(v.inner, 0, 1);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<LlrpStatus> v) {
  io.open_code(v.code);
  io.text(v.description);
  io.children([&](auto& slots) {
    slots.maybe(v.field_error);
    slots.maybe(v.parameter_error);
  });
}

}  // namespace sensotwin::robot::llrp
