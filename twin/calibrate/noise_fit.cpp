// SPDX-License-Identifier: MIT
#include "twin/calibrate/noise_fit.hpp"

#include <algorithm>
#include <cmath>

#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

/// Fewer leave the noise of a link more than 10 % uncertain: 1 / sqrt(2 n). Chosen.
constexpr std::size_t kBendsMin = 50;
/// Bends beyond so many sigma are clipped away: people passing, the last read before a hop. Chosen.
constexpr double kClip = 4.0;
/// A law of two parameters wants more points than that. Chosen.
constexpr std::size_t kPointsMin = 4;
constexpr std::size_t kFlipsMin = 10;
/// Where the middle of the flips' curve, and how wide it, can be told from reads at all. Chosen.
constexpr double kFlipLow_dbm = -100.0;
constexpr double kFlipHigh_dbm = -40.0;
constexpr double kFlipWidest_db = 15.0;

/// Noise of one read from the bends of three: a bend is sqrt(6) times that.
double noise_of(const TagLink& link) {
  double limit_rad = 2.0 * robot::kPi;
  double bend_sigma_rad = 0.0;
  for (int round = 0; round < 5; ++round) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const double bend_rad : link.bends_rad) {
      if (std::abs(bend_rad) <= limit_rad) {
        sum += bend_rad * bend_rad;
        ++count;
      }
    }
    bend_sigma_rad = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, count)));
    limit_rad = kClip * bend_sigma_rad;
  }
  return bend_sigma_rad / std::sqrt(6.0);
}

/// Predicted noise of a point under parameters of a law.
using Law = std::function<double(const Eigen::VectorXd&, const NoisePoint&)>;

double rssi_law(const Eigen::VectorXd& p, const NoisePoint& point) {
  return noise_by_rssi_rad(std::exp(p(0)), std::exp(p(1)), point.rssi_dbm);
}
double proportional_law(const Eigen::VectorXd& p, const NoisePoint& point) {
  return std::exp(p(0)) * *point.distance_m;
}
double offset_law(const Eigen::VectorXd& p, const NoisePoint& point) {
  return std::exp(p(0)) + std::exp(p(1)) * *point.distance_m;
}

/// Parameters are fitted as logarithms, which keeps them positive.
std::optional<Eigen::VectorXd> fitted(const Law& law, const Eigen::VectorXd& start,
                                      const std::vector<const NoisePoint*>& points) {
  if (points.size() < kPointsMin) {
    return std::nullopt;
  }
  return least_squares(start, points.size(), [&](const Eigen::VectorXd& p, Eigen::VectorXd& residuals) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      residuals(static_cast<Eigen::Index>(i)) = std::log(points[i]->sigma_rad / law(p, *points[i]));
    }
  });
}

std::optional<NoiseLawFit> fit_law(const Law& law, const Eigen::VectorXd& start,
                                   const std::vector<const NoisePoint*>& points, int resamples,
                                   const robot::RandomStream& random) {
  const auto best = fitted(law, start, points);
  if (!best) {
    return std::nullopt;
  }
  const auto estimates = bootstrap(points.size(), resamples, random, [&](std::span<const std::size_t> picks) {
    std::vector<const NoisePoint*> drawn;
    for (const std::size_t pick : picks) {
      drawn.push_back(points[pick]);
    }
    const auto logs = fitted(law, *best, drawn);
    return logs ? std::optional<Eigen::VectorXd>(logs->array().exp()) : std::nullopt;
  });
  NoiseLawFit fit{.parameters = *estimates, .predicted_rad = {}};
  double residual2 = 0.0;
  double mean_log = 0.0;
  for (const NoisePoint* point : points) {
    fit.predicted_rad.push_back(law(*best, *point));
    residual2 += std::pow(std::log(point->sigma_rad / fit.predicted_rad.back()), 2);
    mean_log += std::log(point->sigma_rad) / static_cast<double>(points.size());
  }
  double total2 = 0.0;
  for (const NoisePoint* point : points) {
    total2 += std::pow(std::log(point->sigma_rad) - mean_log, 2);
  }
  fit.spread = std::exp(std::sqrt(residual2 / static_cast<double>(points.size())));
  fit.r_squared = total2 > 0.0 ? 1.0 - residual2 / total2 : 0.0;
  return fit;
}

/// Where the searches begin: the figures of the data study, 3.5.
const Eigen::Vector2d kRssiStart{std::log(0.0078), std::log(0.0155)};
const Eigen::Vector2d kOffsetStart{std::log(0.0078), std::log(0.0014)};

std::vector<NoisePoint> points_of(std::span<const TagLink> links,
                                  std::span<const std::optional<double>> distance_m) {
  std::vector<NoisePoint> points;
  for (std::size_t l = 0; l < links.size(); ++l) {
    const TagLink& link = links[l];
    const double sigma_rad = link.bends_rad.size() < kBendsMin ? 0.0 : noise_of(link);
    if (sigma_rad > 0.0) {
      points.push_back({.link = l,
                        .sigma_rad = sigma_rad,
                        .rssi_dbm = link.bends_rssi_dbm,
                        .distance_m = distance_m[link.log]});
    }
  }
  return points;
}

/// Where 0.5 / (1 + exp((RSSI - p0) / exp(p1))) is most likely: signed roots of the deviance as residuals.
std::optional<Eigen::VectorXd> fitted_flips(const std::map<double, FlipFit::Bin>& bins) {
  std::size_t flips = 0;
  for (const auto& [rssi_dbm, bin] : bins) {
    flips += bin.flips;
  }
  if (flips < kFlipsMin || bins.size() < 3) {
    return std::nullopt;
  }
  const Eigen::Vector2d start{-72.2, std::log(2.52)};  // data study, 3.7
  Eigen::VectorXd p =
      least_squares(start, bins.size(), [&](const Eigen::VectorXd& at, Eigen::VectorXd& residuals) {
        Eigen::Index i = 0;
        for (const auto& [rssi_dbm, bin] : bins) {
          const double n = static_cast<double>(bin.pairs);
          const double seen = static_cast<double>(bin.flips);
          const double rate =
              std::clamp(0.5 / (1.0 + std::exp((rssi_dbm - at(0)) / std::exp(at(1)))), 1e-12, 0.5);
          const double flipped = seen > 0.0 ? seen * std::log(seen / (n * rate)) : 0.0;
          const double kept = seen < n ? (n - seen) * std::log((n - seen) / (n * (1.0 - rate))) : 0.0;
          residuals(i++) = std::sqrt(std::max(0.0, 2.0 * (flipped + kept)));
        }
      });
  p(1) = std::exp(p(1));
  // Flips that do not depend on RSSI (wrong channels, data study, 3.7) have no such curve.
  const bool sane = p(0) > kFlipLow_dbm && p(0) < kFlipHigh_dbm && p(1) < kFlipWidest_db;
  return sane ? std::optional<Eigen::VectorXd>(p) : std::nullopt;
}

}  // namespace

double noise_by_rssi_rad(double floor_rad, double at_50dbm_rad, double rssi_dbm) {
  return std::hypot(floor_rad, at_50dbm_rad * std::pow(10.0, -(rssi_dbm + 50.0) / 20.0));
}

NoiseFit fit_noise(std::span<const TagLink> links, std::span<const std::optional<double>> distance_m,
                   int resamples, const robot::RandomStream& random) {
  NoiseFit fit{.points = points_of(links, distance_m),
               .by_rssi = {},
               .proportional = {},
               .offset = {},
               .left_out_ratio = {}};
  std::vector<const NoisePoint*> all;
  std::vector<const NoisePoint*> placed;
  for (const NoisePoint& point : fit.points) {
    all.push_back(&point);
    if (point.distance_m) {
      placed.push_back(&point);
    }
  }
  fit.by_rssi = fit_law(rssi_law, kRssiStart, all, resamples, random.fork("by RSSI"));
  fit.proportional = fit_law(proportional_law, Eigen::VectorXd::Constant(1, std::log(0.009)), placed,
                             resamples, random.fork("proportional"));
  fit.offset = fit_law(offset_law, kOffsetStart, placed, resamples, random.fork("offset"));
  for (std::size_t i = 0; fit.by_rssi && i < all.size(); ++i) {
    std::vector<const NoisePoint*> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto p = fitted(rssi_law, kRssiStart, others)) {
      fit.left_out_ratio.push_back(all[i]->sigma_rad / rssi_law(*p, *all[i]));
    }
  }
  const auto near = std::count_if(fit.left_out_ratio.begin(), fit.left_out_ratio.end(),
                                  [](double ratio) { return ratio >= 0.8 && ratio <= 1.25; });
  if (near > 0) {
    fit.left_out_share = static_cast<double>(near) / static_cast<double>(fit.left_out_ratio.size());
  }
  return fit;
}

FlipFit fit_flips(std::span<const TagLink> links, int resamples, const robot::RandomStream& random) {
  std::vector<std::map<double, FlipFit::Bin>> of_links(links.size());
  const auto add = [](std::map<double, FlipFit::Bin>& to, const std::map<double, FlipFit::Bin>& from) {
    for (const auto& [rssi_dbm, bin] : from) {
      to[rssi_dbm].pairs += bin.pairs;
      to[rssi_dbm].flips += bin.flips;
    }
  };
  std::map<double, FlipFit::Bin> whole;
  for (std::size_t l = 0; l < links.size(); ++l) {
    for (const ReadPair& pair : links[l].pairs) {
      FlipFit::Bin& bin = of_links[l][std::round(pair.rssi_dbm)];
      ++bin.pairs;
      bin.flips += is_flip(pair.step_rad) ? 1 : 0;
    }
    add(whole, of_links[l]);
  }
  FlipFit fit{.bins = {}, .rssi_dbm = {}, .width_db = {}};
  for (auto& [rssi_dbm, bin] : whole) {
    fit.pairs += bin.pairs;
    fit.flips += bin.flips;
    fit.bins.push_back({rssi_dbm, bin.pairs, bin.flips});
  }
  const auto estimates = bootstrap(links.size(), resamples, random, [&](std::span<const std::size_t> picks) {
    std::map<double, FlipFit::Bin> drawn;
    for (const std::size_t pick : picks) {
      add(drawn, of_links[pick]);
    }
    return fitted_flips(drawn);
  });
  if (estimates) {
    fit.rssi_dbm = (*estimates)[0];
    fit.width_db = (*estimates)[1];
  }
  return fit;
}

std::optional<DopplerFit> fit_doppler(std::span<const TagLink> links, int resamples,
                                      const robot::RandomStream& random) {
  std::vector<const TagLink*> heard;
  for (const TagLink& link : links) {
    if (link.reads >= kBendsMin && link.doppler_sigma_hz > 0.0) {
      heard.push_back(&link);
    }
  }
  const auto estimates =
      bootstrap(heard.size(), resamples, random,
                [&](std::span<const std::size_t> picks) -> std::optional<Eigen::VectorXd> {
                  if (picks.size() < kPointsMin) {
                    return std::nullopt;
                  }
                  const Eigen::Vector2d start{std::log(6.6), std::log(8.8)};  // data study, 3.10
                  const Eigen::VectorXd p =
                      least_squares(start, picks.size(), [&](const Eigen::VectorXd& at, Eigen::VectorXd& r) {
                        for (std::size_t i = 0; i < picks.size(); ++i) {
                          const TagLink& link = *heard[picks[i]];
                          r(static_cast<Eigen::Index>(i)) =
                              std::log(link.doppler_sigma_hz /
                                       noise_by_rssi_rad(std::exp(at(0)), std::exp(at(1)), link.rssi_dbm));
                        }
                      });
                  double bias_hz = 0.0;
                  for (const std::size_t pick : picks) {
                    bias_hz += heard[pick]->doppler_mean_hz / static_cast<double>(picks.size());
                  }
                  return Eigen::Vector3d{bias_hz, std::exp(p(0)), std::exp(p(1))};
                });
  if (!estimates) {
    return std::nullopt;
  }
  return DopplerFit{(*estimates)[0], (*estimates)[1], (*estimates)[2]};
}

}  // namespace sensotwin::twin
