// SPDX-License-Identifier: MIT
#include "twin/calibrate/reader_timing.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace sensotwin::twin {
namespace {

/// Two tags that answer within this are of one round (data study, 3.8: 0.6 to 1.1 ms). Chosen.
constexpr double kRound_s = 0.004;
/// Channel visits farther apart were not neighbours. Chosen: twice the dwell of the study.
constexpr double kVisit_s = 0.4;

/// Everything that was seen between reads of one set of ports.
struct Gaps {
  std::vector<double> rates_per_s;
  std::map<int, std::size_t> reads;
  std::map<int, std::vector<double>> slots_s;
  std::vector<double> dwells_s;
  std::vector<double> within_s;
  std::vector<double> across_s;
  std::vector<double> rounds_s;
  std::vector<double> revisits_s;
  std::size_t logs{0};
  std::size_t rows{0};
  std::size_t late{0};
};

int next_port(const std::vector<int>& ports, int port) {
  const auto at = std::upper_bound(ports.begin(), ports.end(), port);
  return at == ports.end() ? ports.front() : *at;
}

/// \param in_turn reads up to this one that followed the order of ports: a whole cycle has no missed port
void add_neighbours(const LogRow& before, const LogRow& row, const std::vector<int>& ports, int in_turn,
                    Gaps& gaps) {
  const double gap_s = row.time_s - before.time_s;
  const bool same_channel = before.channel == row.channel;
  if (before.antenna == row.antenna && before.epc != row.epc) {
    if (gap_s < kRound_s) {
      gaps.rounds_s.push_back(gap_s);
    }
    return;
  }
  if (in_turn >= static_cast<int>(ports.size()) && same_channel) {
    gaps.slots_s[before.antenna].push_back(gap_s);
  }
  if (ports.size() == 1) {
    if (same_channel) {
      gaps.within_s.push_back(gap_s);
    } else if (row.channel == before.channel + 1) {
      gaps.across_s.push_back(gap_s);
    }
  }
}

void add_log(const TagLog& log, const std::vector<int>& ports, Gaps& gaps) {
  std::vector<LogRow> rows = log.rows;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    gaps.late += rows[i].time_s < rows[i - 1].time_s ? 1 : 0;
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LogRow& a, const LogRow& b) { return a.time_s < b.time_s; });
  ++gaps.logs;
  gaps.rows += rows.size();
  const double whole_s = rows.back().time_s - rows.front().time_s;
  if (whole_s > 0.0) {
    gaps.rates_per_s.push_back(static_cast<double>(rows.size() - 1) / whole_s);
  }
  std::map<std::pair<int, int>, double> last_s;
  double visit_s = rows.front().time_s;
  bool whole_visit = false;
  int in_turn = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LogRow& row = rows[i];
    ++gaps.reads[row.antenna];
    const auto [seen, first] = last_s.try_emplace({row.antenna, row.epc}, row.time_s);
    if (!first) {
      gaps.revisits_s.push_back(row.time_s - seen->second);
      seen->second = row.time_s;
    }
    if (i == 0) {
      continue;
    }
    in_turn = row.antenna == next_port(ports, rows[i - 1].antenna) ? in_turn + 1 : 0;
    add_neighbours(rows[i - 1], row, ports, in_turn, gaps);
    if (row.channel != rows[i - 1].channel) {
      const bool next = row.channel == rows[i - 1].channel + 1;
      if (next && whole_visit && row.time_s - visit_s < kVisit_s) {
        gaps.dwells_s.push_back(row.time_s - visit_s);
      }
      visit_s = row.time_s;
      whole_visit = next;
    }
  }
}

ReaderTiming timing_of(const std::vector<int>& ports, const Gaps& gaps, int resamples,
                       const robot::RandomStream& random) {
  ReaderTiming timing{.ports = ports,
                      .logs = gaps.logs,
                      .reads = gaps.rows,
                      .reads_per_s = mean_estimate(gaps.rates_per_s, resamples, random.fork("rate")),
                      .port_share = {},
                      .slot_s = {},
                      .dwell_s = mean_estimate(gaps.dwells_s, resamples, random.fork("dwell")),
                      .hop_dead_s = {},
                      .per_tag_s = median_estimate(gaps.rounds_s, resamples, random.fork("round")),
                      .revisit_quantiles_s = {}};
  for (const auto& [port, reads] : gaps.reads) {
    timing.port_share[port] = static_cast<double>(reads) / static_cast<double>(gaps.rows);
  }
  for (const auto& [port, slots_s] : gaps.slots_s) {
    if (const auto slot = median_estimate(slots_s, resamples, random.fork("slot " + std::to_string(port)))) {
      timing.slot_s[port] = *slot;
    }
  }
  const auto across = median_estimate(gaps.across_s, resamples, random.fork("across"));
  if (across && !gaps.within_s.empty()) {
    const double within_s = quantile(gaps.within_s, 0.5);
    timing.hop_dead_s = Estimate{across->value - within_s, across->low - within_s, across->high - within_s};
  }
  for (const double q : {0.05, 0.25, 0.5, 0.75, 0.95}) {
    timing.revisit_quantiles_s.push_back(quantile(gaps.revisits_s, q));
  }
  timing.out_of_order_share = static_cast<double>(gaps.late) / static_cast<double>(gaps.rows);
  return timing;
}

}  // namespace

std::vector<ReaderTiming> fit_timing(std::span<const TagLog> logs, int resamples,
                                     const robot::RandomStream& random) {
  std::map<std::vector<int>, Gaps> by_ports;
  for (const TagLog& log : logs) {
    std::set<int> used;
    for (const LogRow& row : log.rows) {
      used.insert(row.antenna);
    }
    const std::vector<int> ports(used.begin(), used.end());
    add_log(log, ports, by_ports[ports]);
  }
  std::vector<ReaderTiming> timings;
  for (const auto& [ports, gaps] : by_ports) {
    std::string name;
    for (const int port : ports) {
      name += std::to_string(port) + ' ';
    }
    timings.push_back(timing_of(ports, gaps, resamples, random.fork(name)));
  }
  std::stable_sort(timings.begin(), timings.end(), [](const ReaderTiming& a, const ReaderTiming& b) {
    return a.ports.size() > b.ports.size();
  });
  return timings;
}

}  // namespace sensotwin::twin
