// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::twin {

/// A figure and its 95 % confidence interval.
struct Estimate {
  double value{0.0};
  double low{0.0};
  double high{0.0};
};

/// What a fit says of some of the items, each as often as it is picked; nothing when they do not suffice.
using FitOfPicks = std::function<std::optional<Eigen::VectorXd>(std::span<const std::size_t> picks)>;

/// The fit of all items, with percentile bootstrap intervals (Efron, Ann. Stat. 7(1), 1979): items are drawn
/// with replacement `resamples` times. Deterministic in `random`. \returns nothing when all do not suffice
[[nodiscard]] std::optional<std::vector<Estimate>> bootstrap(std::size_t items, int resamples,
                                                             robot::RandomStream random,
                                                             const FitOfPicks& fit);

/// Minimises the sum of squares of `residuals` from `start` (Levenberg and Marquardt, Eigen's, derivatives by
/// differences).
/// \param count of residuals, at least as many as parameters
using Residuals = std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals)>;
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::VectorXd& start, std::size_t count,
                                            const Residuals& residuals);

/// The q-quantile, interpolated; 0 of nothing.
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// Median of the values with a bootstrap interval; nothing for fewer than five values.
[[nodiscard]] std::optional<Estimate> median_estimate(const std::vector<double>& values, int resamples,
                                                      const robot::RandomStream& random);
/// Mean, likewise.
[[nodiscard]] std::optional<Estimate> mean_estimate(const std::vector<double>& values, int resamples,
                                                    const robot::RandomStream& random);

}  // namespace sensotwin::twin
