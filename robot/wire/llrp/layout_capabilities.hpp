// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/llrp/capabilities.hpp"

/// Layouts of capabilities.hpp, in the order of the wire (LLRP 1.0.1, 16.2.3 and 16.3.1.1). Each function
/// serves both directions: Io is a Reader or a Writer.
namespace sensotwin::robot::llrp {

template <class Io>
void layout(Io& io, typename Io::template Ref<ReceiveSensitivity> v) {
  io.number(v.index);
  io.number(v.below_best_db);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<PerAntennaSensitivity> v) {
  io.number(v.antenna);
  io.number(v.index_min);
  io.number(v.index_max);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GpioCapabilities> v) {
  io.number(v.inputs);
  io.number(v.outputs);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<PerAntennaProtocols> v) {
  io.number(v.antenna);
  io.counted(v.protocols);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<GeneralCapabilities> v) {
  io.number(v.antennas);
  io.flags16(v.can_set_antenna_properties, v.has_utc_clock);
  io.number(v.manufacturer);
  io.number(v.model);
  io.text(v.firmware);
  io.children([&](auto& slots) {
    slots.list(v.sensitivities, 1);
    slots.list(v.per_antenna_sensitivities);
    slots.one(v.gpio);
    slots.list(v.protocols, 1);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<LlrpCapabilities> v) {
  io.flags8(v.rf_survey, v.buffer_fill_warning, v.client_request_op_spec, v.state_aware_singulation,
            v.event_and_report_holding);
  io.number(v.priority_levels);
  io.number(v.client_request_timeout);
  io.number(v.ro_specs);
  io.number(v.specs_per_ro_spec);
  io.number(v.inventory_specs_per_ai_spec);
  io.number(v.access_specs);
  io.number(v.op_specs_per_access_spec);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<TransmitPower> v) {
  io.number(v.index);
  io.number(v.centi_dbm);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<FrequencyHopTable> v) {
  io.number(v.id);
  io.reserved(1);
  io.counted(v.frequencies_khz);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<FixedFrequencyTable> v) {
  io.counted(v.frequencies_khz);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<FrequencyInformation> v) {
  io.flags8(v.hopping);
  io.children([&](auto& slots) {
    slots.list(v.hop_tables);
    slots.maybe(v.fixed);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RfMode> v) {
  io.number(v.id);
  io.flags8(v.divide_ratio_64_3, v.epc_hag_conformant);
  io.number(v.modulation);
  io.number(v.forward_link_modulation);
  io.number(v.spectral_mask);
  io.number(v.backscatter_bps);
  io.number(v.pie_thousandths);
  io.number(v.tari_min_ns);
  io.number(v.tari_max_ns);
  io.number(v.tari_step_ns);
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RfModeTable> v) {
  io.children([&](auto& slots) { slots.list(v.modes, 1); });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<UhfBand> v) {
  io.children([&](auto& slots) {
    slots.list(v.powers, 1);
    slots.one(v.frequencies);
    slots.list(v.mode_tables, 1);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<RegulatoryCapabilities> v) {
  io.number(v.country);
  io.number(v.communications_standard);
  io.children([&](auto& slots) {
    slots.maybe(v.uhf);
    slots.customs(v.customs);
  });
}
template <class Io>
void layout(Io& io, typename Io::template Ref<C1G2Capabilities> v) {
  io.flags8(v.block_erase, v.block_write);
  io.number(v.select_filters);
}

}  // namespace sensotwin::robot::llrp
