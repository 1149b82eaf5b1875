// SPDX-License-Identifier: MIT
#include "twin/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "robot/config/problem.hpp"

namespace sensotwin::twin {
namespace {

constexpr double kLight_mps = 299'792'458.0;
/// A strong link was heard on so much of the band. Chosen.
constexpr double kBandHeard = 0.8;
/// Of phases, to keep to a step (data study, 3.3: 92 % of weak reads and more of others).
constexpr double kStepShare = 0.9;

void check_channels(const CalibrationInput& input, int channels) {
  for (const TagLog& log : input.logs) {
    for (const LogRow& row : log.rows) {
      if (row.channel > channels) {
        throw robot::LoadError({{{log.name, 0, 0},
                                 "channel_index",
                                 fmt::format("channel {} of {}", row.channel, channels),
                                 "--band or --hop-table with all channels was expected"}},
                               robot::kExitInvalid);
      }
    }
  }
}

PhaseByChannel phases_of(const TagLink& link, int channels) {
  PhaseByChannel phases(static_cast<std::size_t>(channels));
  for (const auto& [channel, mean] : link.channels) {
    phases[static_cast<std::size_t>(channel - 1)] = mean / std::max(1e-12, std::abs(mean));
  }
  return phases;
}

bool is_strong(const TagLink& link, int channels) {
  return link.rssi_dbm > kStrong_dbm && static_cast<double>(link.channels.size()) >= kBandHeard * channels;
}

double mean_coherence(const std::vector<PhaseByChannel>& links, const std::vector<double>& channels_hz,
                      double phase_sign) {
  double sum = 0.0;
  for (const PhaseByChannel& link : links) {
    sum += fit_line(link, channels_hz, phase_sign).coherence / static_cast<double>(links.size());
  }
  return sum;
}

int steps_of(const std::vector<TagLog>& logs) {
  for (int step = 64; step > 1; step /= 2) {
    std::size_t kept = 0;
    std::size_t all = 0;
    for (const TagLog& log : logs) {
      for (const LogRow& row : log.rows) {
        const auto units = std::lround(row.phase_rad / (2.0 * robot::kPi) * 4096.0);
        kept += units % step == 0 ? 1 : 0;
        ++all;
      }
    }
    if (static_cast<double>(kept) >= kStepShare * static_cast<double>(all)) {
      return 4096 / step;
    }
  }
  return 4096;
}

std::optional<RssiLawFit> fit_rssi(const Calibration& calibration, const CalibrationInput& input,
                                   const robot::RandomStream& random) {
  std::vector<std::pair<double, double>> points;  // log10 of metres, dBm
  for (const TagLink& link : calibration.links) {
    if (const auto distance_m = input.distance_m[link.log]; distance_m && *distance_m > 0.0) {
      points.emplace_back(std::log10(*distance_m), link.rssi_dbm);
    }
  }
  const auto estimates = bootstrap(points.size(), calibration.settings.resamples, random,
                                   [&](std::span<const std::size_t> picks) -> std::optional<Eigen::VectorXd> {
                                     double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
                                     for (const std::size_t pick : picks) {
                                       const auto& [at, dbm] = points[pick];
                                       n += 1.0, x += at, y += dbm, xx += at * at, xy += at * dbm;
                                     }
                                     const double spread = n * xx - x * x;
                                     if (n < 4.0 || spread < 1e-6) {
                                       return std::nullopt;
                                     }
                                     const double slope = (n * xy - x * y) / spread;
                                     return Eigen::Vector2d{(y - slope * x) / n, slope};
                                   });
  return estimates ? std::optional<RssiLawFit>({(*estimates)[0], (*estimates)[1]}) : std::nullopt;
}

/// Lines of all links heard on half the band or more, and what the strong ones say together.
void fit_lines(Calibration& calibration, const CalibrationInput& input, const robot::RandomStream& random) {
  const int channels = static_cast<int>(calibration.channels_hz.size());
  std::vector<double> strong;
  std::map<int, std::vector<double>> delays_s;
  std::map<int, std::vector<double>> cables_s;
  for (std::size_t l = 0; l < calibration.links.size(); ++l) {
    const TagLink& link = calibration.links[l];
    const int heard = static_cast<int>(link.channels.size());
    if (2 * heard < channels) {
      continue;
    }
    calibration.lines.push_back(
        {l, heard, is_strong(link, channels),
         fit_line(phases_of(link, channels), calibration.channels_hz, calibration.phase_sign)});
    if (!calibration.lines.back().strong) {
      continue;
    }
    const FrequencyLine& line = calibration.lines.back().line;
    strong.push_back(line.coherence);
    delays_s[link.antenna].push_back(line.delay_s);
    if (const auto distance_m = input.distance_m[link.log]) {
      cables_s[link.antenna].push_back(line.delay_s - 2.0 * *distance_m / kLight_mps);
    }
  }
  const int resamples = calibration.settings.resamples;
  calibration.strong_coherence = mean_estimate(strong, resamples, random.fork("coherence"));
  if (!strong.empty()) {
    calibration.linear_share =
        static_cast<double>(std::count_if(strong.begin(), strong.end(), [](double c) { return c > 0.95; })) /
        static_cast<double>(strong.size());
  }
  const auto store = [&](const std::map<int, std::vector<double>>& from, std::map<int, Estimate>& to,
                         const char* name) {
    for (const auto& [port, values_s] : from) {
      if (const auto estimate =
              mean_estimate(values_s, resamples, random.fork(name).fork(std::to_string(port)))) {
        to[port] = *estimate;
      }
    }
  };
  store(delays_s, calibration.delay_s, "delay");
  store(cables_s, calibration.cable_delay_s, "cable");
}

/// Hop table and sign: given, or recovered. \returns false when told to stop
bool find_table(Calibration& calibration, const CalibrationInput& input, const robot::RandomStream& random,
                const std::function<bool()>& go_on) {
  const int channels =
      input.channels_hz ? static_cast<int>(input.channels_hz->size()) : calibration.settings.band.channels;
  check_channels(input, channels);
  std::vector<PhaseByChannel> strong;
  for (const TagLink& link : calibration.links) {
    if (is_strong(link, channels)) {
      strong.push_back(phases_of(link, channels));
    }
  }
  calibration.phase_sign = calibration.settings.phase_sign;
  if (input.channels_hz) {
    calibration.channels_hz = *input.channels_hz;
    if (!strong.empty()) {
      calibration.rising_coherence = mean_coherence(strong, calibration.channels_hz, 1.0);
      calibration.falling_coherence = mean_coherence(strong, calibration.channels_hz, -1.0);
      calibration.phase_sign = *calibration.rising_coherence > *calibration.falling_coherence ? 1.0 : -1.0;
    }
    return true;
  }
  calibration.recovered = recover_hop_table(strong, calibration.settings.band, calibration.phase_sign,
                                            calibration.settings.starts, calibration.settings.resamples,
                                            random.fork("hop table"), go_on);
  if (calibration.recovered) {
    calibration.channels_hz = calibration.recovered->channels_hz;
  }
  return go_on();
}

}  // namespace

std::optional<Calibration> calibrate(CalibrationInput input, const CalibrationSettings& settings,
                                     const std::function<bool()>& go_on) {
  assert(input.distance_m.size() == input.logs.size());
  const robot::RandomStream random = robot::RandomStream{settings.seed}.fork("calibrate");
  Calibration calibration;
  calibration.settings = settings;
  std::vector<double> rssi_dbm;
  for (TagLog& log : input.logs) {
    calibration.stale_channels += correct_stale_channels(log);
    calibration.logs.push_back(log.name);
    calibration.reads += log.rows.size();
    for (const LogRow& row : log.rows) {
      rssi_dbm.push_back(row.rssi_dbm);
    }
  }
  calibration.weakest_dbm = quantile(std::move(rssi_dbm), 0.01);
  calibration.links = links_of(input.logs);
  if (!find_table(calibration, input, random, go_on)) {
    return std::nullopt;
  }
  if (!calibration.channels_hz.empty()) {
    fit_lines(calibration, input, random.fork("lines"));
  }
  calibration.phase_steps = steps_of(input.logs);
  calibration.noise =
      fit_noise(calibration.links, input.distance_m, settings.resamples, random.fork("noise"));
  if (!go_on()) {
    return std::nullopt;
  }
  calibration.flips = fit_flips(calibration.links, settings.resamples, random.fork("flips"));
  calibration.doppler = fit_doppler(calibration.links, settings.resamples, random.fork("doppler"));
  calibration.timings = fit_timing(input.logs, settings.resamples, random.fork("timing"));
  calibration.rssi = fit_rssi(calibration, input, random.fork("RSSI"));
  return go_on() ? std::optional{std::move(calibration)} : std::nullopt;
}

}  // namespace sensotwin::twin
