// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "twin/calibrate/estimation.hpp"
#include "twin/calibrate/sllurp_log.hpp"

namespace sensotwin::twin {

/// When a reader read, from its logs with equal sets of ports in use (data study, 3.8 and 3.9).
struct ReaderTiming {
  std::vector<int> ports;
  std::size_t logs{0};
  std::size_t reads{0};
  std::optional<Estimate> reads_per_s;      ///< of a log, while it lasts
  std::map<int, double> port_share;         ///< of all reads
  std::map<int, Estimate> slot_s;           ///< from a port's read to the next port's
  std::optional<Estimate> dwell_s;          ///< from the first read of a channel to that of the next
  std::optional<Estimate> hop_dead_s;       ///< longer gap across a hop than within a channel; one port only
  std::optional<Estimate> per_tag_s;        ///< from tag to tag within a round
  std::vector<double> revisit_quantiles_s;  ///< 5, 25, 50, 75, 95 % of the time between reads of one port
  double out_of_order_share{0.0};           ///< rows older than the one above: reports accumulate
};

/// One timing for each set of ports, the largest sets first.
[[nodiscard]] std::vector<ReaderTiming> fit_timing(std::span<const TagLog> logs, int resamples,
                                                   const robot::RandomStream& random);

}  // namespace sensotwin::twin
