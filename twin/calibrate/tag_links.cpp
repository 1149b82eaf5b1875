// SPDX-License-Identifier: MIT
#include "twin/calibrate/tag_links.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

TagLink link_of(std::size_t log, std::vector<LogRow> rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LogRow& a, const LogRow& b) { return a.time_s < b.time_s; });
  TagLink link{.log = log,
               .antenna = rows.front().antenna,
               .epc = rows.front().epc,
               .reads = rows.size(),
               .pairs = {},
               .bends_rad = {},
               .channels = {}};
  std::map<int, std::pair<std::complex<double>, std::size_t>> sums;
  const double n = static_cast<double>(rows.size());
  double doppler_square = 0.0;
  double bends_dbm = 0.0;
  double before_rad = 0.0;
  bool follows = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LogRow& row = rows[i];
    link.rssi_dbm += row.rssi_dbm / n;
    link.doppler_mean_hz += row.doppler_hz / n;
    doppler_square += row.doppler_hz * row.doppler_hz / n;
    auto& [sum, count] = sums[row.channel];
    sum += std::polar(1.0, row.phase_rad);
    ++count;
    if (i == 0 || rows[i - 1].channel != row.channel || row.time_s - rows[i - 1].time_s > kPairMax_s) {
      follows = false;
      continue;
    }
    const double step_rad = robot::wrap_angle(row.phase_rad - rows[i - 1].phase_rad);
    link.pairs.push_back({0.5 * (rows[i - 1].rssi_dbm + row.rssi_dbm), step_rad});
    if (follows) {
      link.bends_rad.push_back(folded_rad(step_rad) - folded_rad(before_rad));
      bends_dbm += rows[i - 1].rssi_dbm;
    }
    follows = true;
    before_rad = step_rad;
  }
  link.bends_rssi_dbm = bends_dbm / static_cast<double>(std::max<std::size_t>(1, link.bends_rad.size()));
  link.doppler_sigma_hz =
      std::sqrt(std::max(0.0, doppler_square - link.doppler_mean_hz * link.doppler_mean_hz));
  for (const auto& [channel, sum] : sums) {
    link.channels[channel] = sum.first / static_cast<double>(sum.second);
  }
  return link;
}

}  // namespace

std::size_t correct_stale_channels(TagLog& log) {
  const auto earlier = [](const LogRow& a, const LogRow& b) { return a.time_s < b.time_s; };
  if (std::is_sorted(log.rows.begin(), log.rows.end(), earlier)) {
    return 0;
  }
  std::vector<LogRow*> by_time;
  int channels = 0;
  for (LogRow& row : log.rows) {
    by_time.push_back(&row);
    channels = std::max(channels, row.channel);
  }
  std::stable_sort(by_time.begin(), by_time.end(),
                   [&](const LogRow* a, const LogRow* b) { return earlier(*a, *b); });
  std::size_t changed = 0;
  int now = by_time.front()->channel;
  for (LogRow* row : by_time) {
    const int behind = (now - row->channel + channels) % channels;
    if (behind == 1 || behind == 2) {
      row->channel = now;
      ++changed;
    }
    now = row->channel;
  }
  return changed;
}

std::vector<TagLink> links_of(std::span<const TagLog> logs) {
  std::vector<TagLink> links;
  for (std::size_t l = 0; l < logs.size(); ++l) {
    std::map<std::pair<int, int>, std::vector<LogRow>> parts;
    for (const LogRow& row : logs[l].rows) {
      parts[{row.antenna, row.epc}].push_back(row);
    }
    for (auto& [key, rows] : parts) {
      links.push_back(link_of(l, std::move(rows)));
    }
  }
  return links;
}

double folded_rad(double step_rad) {
  return is_flip(step_rad) ? robot::wrap_angle(step_rad + robot::kPi) : step_rad;
}

bool is_flip(double step_rad) {
  return std::abs(step_rad) > 0.5 * robot::kPi;
}

}  // namespace sensotwin::twin
