// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "robot/wire/llrp/report.hpp"
#include "robot/wire/llrp/report_spec.hpp"
#include "twin/devices/radio_reading.hpp"
#include "twin/devices/uhf_settings.hpp"

namespace sensotwin::twin {

/// Which part of which ROSpec made a reading.
struct ReadingContext {
  std::uint32_t ro_spec_id{0};
  std::uint16_t spec_index{1};
  std::uint16_t inventory_spec_id{1};
};

/// The entries of the next report. Readings of the same tag with the same values in all enabled fields that
/// name something (antenna, specs) merge: count goes on, first seen stays, last seen moves, RSSI is the
/// highest, phase and Doppler are of the last reading, and the channel is that of the FIRST (LLRP 1.0.1,
/// 13.2.3.1; Impinj's text). So with more than one reading in a report a phase may carry the channel before
/// its own, as in 15.6 % of the rows of real logs (data study, 3.9).
class UhfReportBuffer {
 public:
  explicit UhfReportBuffer(const UhfReaderSettings& settings) : settings_(settings) {}

  void set_spec(const robot::llrp::RoReportSpec& spec) { spec_ = spec; }
  /// \returns whether the entries are as many as a report shall have
  [[nodiscard]] bool add(const RadioReading& reading, const ReadingContext& context);
  /// A result of an access operation: always an entry of its own.
  void add(robot::llrp::TagReport entry) { entries_.push_back(std::move(entry)); }
  /// What an entry about one reading holds: the enabled fields, all of them.
  [[nodiscard]] robot::llrp::TagReport entry_of(const RadioReading& reading,
                                                const ReadingContext& context) const;
  [[nodiscard]] std::vector<robot::llrp::TagReport> take();
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const robot::llrp::RoReportSpec& spec() const { return spec_; }
  /// Microseconds of the reader's clock.
  [[nodiscard]] std::uint64_t utc_us(robot::Instant at) const;

 private:
  const UhfReaderSettings& settings_;
  robot::llrp::RoReportSpec spec_;
  std::vector<robot::llrp::TagReport> entries_;
};

}  // namespace sensotwin::twin
