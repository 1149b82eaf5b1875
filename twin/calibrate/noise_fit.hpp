// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "twin/calibrate/estimation.hpp"
#include "twin/calibrate/tag_links.hpp"

namespace sensotwin::twin {

/// Read noise of one link: three successive reads of one channel visit, folded modulo pi (data study, 3.5,
/// part 1). Two reads would do for a tag screwed to the wall; on a stick, its sway is as large as the noise.
struct NoisePoint {
  std::size_t link{0};  ///< in the links it was made of
  double sigma_rad{0.0};
  double rssi_dbm{0.0};  ///< mean of these reads
  std::optional<double> distance_m;
};

/// A law, fitted by least squares of log(measured / predicted), one point per link.
struct NoiseLawFit {
  std::vector<Estimate> parameters;
  double spread{1.0};                 ///< root mean square of that, as a factor
  double r_squared{0.0};              ///< of the logarithms
  std::vector<double> predicted_rad;  ///< of each point it was fitted to
};

struct NoiseFit {
  std::vector<NoisePoint> points;
  /// sqrt(floor^2 + (at_50dbm * 10^(-(RSSI + 50) / 20))^2): floor_rad, at_50dbm_rad.
  std::optional<NoiseLawFit> by_rssi;
  std::optional<NoiseLawFit> proportional;  ///< per_m_rad; needs distances
  std::optional<NoiseLawFit> offset;        ///< floor_rad, per_m_rad; needs distances
  /// measured / predicted by RSSI of each point, predicted by a fit to all other points.
  std::vector<double> left_out_ratio;
  /// Share of those between 0.8 and 1.25.
  double left_out_share{0.0};
};

/// \param distance_m  of each log, where known
[[nodiscard]] NoiseFit fit_noise(std::span<const TagLink> links,
                                 std::span<const std::optional<double>> distance_m, int resamples,
                                 const robot::RandomStream& random);

/// The law by RSSI at one strength.
[[nodiscard]] double noise_by_rssi_rad(double floor_rad, double at_50dbm_rad, double rssi_dbm);

/// Logistic of pi flips between successive reads: 0.5 / (1 + exp((RSSI - rssi) / width)) (data study, 3.7).
struct FlipFit {
  std::size_t pairs{0};
  std::size_t flips{0};
  struct Bin {
    double rssi_dbm{0.0};
    std::size_t pairs{0};
    std::size_t flips{0};
  };
  std::vector<Bin> bins;  ///< by whole dBm, rising
  std::optional<Estimate> rssi_dbm;
  std::optional<Estimate> width_db;
};
/// Maximum likelihood over all pairs, resampled by link; no estimate for fewer than ten flips.
[[nodiscard]] FlipFit fit_flips(std::span<const TagLink> links, int resamples,
                                const robot::RandomStream& random);

/// Doppler of tags at rest: bias, and its scatter by RSSI in the form of the phase noise.
struct DopplerFit {
  Estimate bias_hz;
  Estimate floor_hz;
  Estimate at_50dbm_hz;
};
[[nodiscard]] std::optional<DopplerFit> fit_doppler(std::span<const TagLink> links, int resamples,
                                                    const robot::RandomStream& random);

}  // namespace sensotwin::twin
