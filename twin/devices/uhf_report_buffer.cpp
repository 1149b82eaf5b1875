// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_report_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace sensotwin::twin {
namespace llrp = robot::llrp;
namespace {

constexpr double kPhaseSteps = 4096.0;
constexpr std::uint16_t kPcOfNinetySixBits = 0x3000;

[[nodiscard]] std::uint16_t phase_angle(double phase_rad) {
  const double turns = phase_rad / (2.0 * std::numbers::pi);
  return static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * kPhaseSteps) % 4096);
}
[[nodiscard]] std::int16_t clamped(double value) {
  return static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
}
[[nodiscard]] bool is_on(const auto& selector) {
  return selector && selector->value != 0;
}
template <class T>
void keep_larger(std::optional<T>& kept, const std::optional<T>& other) {
  if (kept && other && *kept < *other) {
    kept = other;
  }
}

[[nodiscard]] bool same_scope(const llrp::TagReport& a, const llrp::TagReport& b) {
  return a.epc_96 == b.epc_96 && a.antenna_id == b.antenna_id && a.ro_spec_id == b.ro_spec_id &&
         a.spec_index == b.spec_index && a.inventory_spec_id == b.inventory_spec_id && a.results.empty();
}

void merge(llrp::TagReport& into, const llrp::TagReport& later) {
  keep_larger(into.peak_rssi_dbm, later.peak_rssi_dbm);
  if (into.impinj_rssi && later.impinj_rssi) {
    into.impinj_rssi->value = std::max(into.impinj_rssi->value, later.impinj_rssi->value);
  }
  into.last_seen_utc_us = later.last_seen_utc_us;
  if (into.seen_count && *into.seen_count < UINT16_MAX) {
    ++*into.seen_count;
  }
  into.phase_angle = later.phase_angle;
  into.doppler = later.doppler;
}

}  // namespace

std::uint64_t UhfReportBuffer::utc_us(robot::Instant at) const {
  const double us = robot::to_s(at) * (1.0 + settings_.clock_drift_ppm * 1e-6) * 1e6;
  return settings_.utc_at_start_us + static_cast<std::uint64_t>(std::llround(us));
}

llrp::TagReport UhfReportBuffer::entry_of(const RadioReading& reading, const ReadingContext& context) const {
  const llrp::TagReportContent& on = spec_.content;
  const double step_db = settings_.rssi_step_db;
  const double rssi_dbm = std::round(reading.rssi_dbm / step_db) * step_db;
  const std::uint64_t seen_us = utc_us(reading.at);
  const auto if_on = [](bool enabled, auto value) { return enabled ? std::optional{value} : std::nullopt; };
  llrp::TagReport out;
  out.epc_96 = reading.epc;
  out.ro_spec_id = if_on(on.ro_spec_id, context.ro_spec_id);
  out.spec_index = if_on(on.spec_index, context.spec_index);
  out.inventory_spec_id = if_on(on.inventory_spec_id, context.inventory_spec_id);
  out.antenna_id = if_on(on.antenna_id, reading.antenna);
  // A real reader cuts the half: -68.5 dBm is told as -68 (protocols study, 2.6).
  out.peak_rssi_dbm = if_on(on.peak_rssi, static_cast<std::int8_t>(std::clamp(rssi_dbm, -128.0, 127.0)));
  out.channel_index = if_on(on.channel_index, reading.channel);
  out.first_seen_utc_us = if_on(on.first_seen, seen_us);
  out.last_seen_utc_us = if_on(on.last_seen, seen_us);
  out.seen_count = if_on(on.tag_seen_count, std::uint16_t{1});
  out.access_spec_id = if_on(on.access_spec_id, std::uint32_t{0});
  out.pc = if_on(!on.memory.empty() && on.memory[0].pc, kPcOfNinetySixBits);
  if (spec_.impinj) {
    const llrp::ImpinjReportContent& impinj = *spec_.impinj;
    out.phase_angle =
        if_on(is_on(impinj.phase_angle), llrp::ImpinjPhaseAngle{phase_angle(reading.phase_rad)});
    out.impinj_rssi = if_on(is_on(impinj.peak_rssi), llrp::ImpinjPeakRssi{clamped(rssi_dbm * 100.0)});
    out.doppler =
        if_on(is_on(impinj.doppler), llrp::ImpinjDopplerFrequency{clamped(reading.doppler_hz * 16.0)});
  }
  return out;
}

bool UhfReportBuffer::add(const RadioReading& reading, const ReadingContext& context) {
  llrp::TagReport entry = entry_of(reading, context);
  const auto same =
      std::ranges::find_if(entries_, [&](const auto& other) { return same_scope(other, entry); });
  if (same != entries_.end()) {
    merge(*same, entry);
  } else {
    entries_.push_back(std::move(entry));
  }
  return spec_.trigger != llrp::RoReportTrigger::kNone && spec_.tags > 0 && entries_.size() >= spec_.tags;
}

std::vector<llrp::TagReport> UhfReportBuffer::take() {
  return std::exchange(entries_, {});
}

}  // namespace sensotwin::twin
