// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "world/radio/radio_read.hpp"
#include "world/radio_description.hpp"

namespace sensotwin::world {

/// Rows of tag reads on their way out of the reader (data study, 3.9).
///
/// A report leaves once `report_every` reads were made and arrives `report_latency_s` later. With
/// `accumulate_reads`, a tag that the same antenna reads again before that updates time, phase and RSSI of
/// its row but leaves the row's place in the report and its channel, as the logs of spring 2025 show: rows
/// out of order in time, and the channel of the visit before.
class ReportQueue {
 public:
  explicit ReportQueue(const RadioDescription& radio);

  /// One read more, not earlier than the one before.
  void push(const RadioRead& read);
  /// Moves the rows that have arrived by `now_s` to the end of `into`.
  void take_arrived(double now_s, std::vector<RadioRead>& into);

 private:
  struct Row {
    RadioRead read;
    double arrives_s{0.0};
  };
  std::size_t every_;
  bool accumulate_;
  double latency_s_;
  std::size_t reads_{0};         ///< since the last report
  std::vector<RadioRead> open_;  ///< rows of the next report
  std::vector<Row> sent_;
};

}  // namespace sensotwin::world
