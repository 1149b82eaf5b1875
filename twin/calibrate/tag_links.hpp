// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "twin/calibrate/sllurp_log.hpp"

namespace sensotwin::twin {

/// Two successive reads of one tag by one antenna on one channel, a moment apart.
struct ReadPair {
  double rssi_dbm{0.0};  ///< mean of both
  double step_rad{0.0};  ///< of the phase, in (-pi, pi]
};

/// One tag as one antenna heard it throughout one log: neither is taken to have moved.
struct TagLink {
  std::size_t log{0};
  int antenna{1};
  int epc{0};
  std::size_t reads{0};
  double rssi_dbm{0.0};  ///< mean
  std::vector<ReadPair> pairs;
  /// Steps of successive pairs, folded, one less the other: noise without what drifts (data study, 3.5: part
  /// 1 without part 2). Of white noise sqrt(6) times as large.
  std::vector<double> bends_rad;
  double bends_rssi_dbm{0.0};                    ///< mean over them
  std::map<int, std::complex<double>> channels;  ///< mean of exp(i phase) by ChannelIndex
  double doppler_mean_hz{0.0};
  double doppler_sigma_hz{0.0};
};

/// Reads farther apart than this make no pair: what lies between is drift, no read noise. Chosen: three slots
/// of a reader with one antenna (data study, 3.8: 14 ms).
inline constexpr double kPairMax_s = 0.05;

/// Gives rows of accumulating reports that carry the channel of the visit before (data study, 3.9) the
/// channel that rows of earlier time show already. Logs whose rows stand in order of time are left alone.
/// \returns how many rows were changed
[[nodiscard]] std::size_t correct_stale_channels(TagLog& log);

/// All links of the logs, in the order of logs, antennas, tags.
[[nodiscard]] std::vector<TagLink> links_of(std::span<const TagLog> logs);

/// Step folded to (-pi/2, pi/2]: what is left of it when flips by pi are taken away.
[[nodiscard]] double folded_rad(double step_rad);
/// Whether the step is a flip by pi rather than noise: beyond pi / 2.
[[nodiscard]] bool is_flip(double step_rad);

}  // namespace sensotwin::twin
