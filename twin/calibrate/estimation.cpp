// SPDX-License-Identifier: MIT
#include "twin/calibrate/estimation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace sensotwin::twin {
namespace {

/// Residuals as Eigen's solver wants to see them.
struct Functor {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  static constexpr int InputsAtCompileTime = Eigen::Dynamic;
  static constexpr int ValuesAtCompileTime = Eigen::Dynamic;

  const Residuals* of;
  int parameters;
  int count;

  [[nodiscard]] int inputs() const { return parameters; }
  [[nodiscard]] int values() const { return count; }
  int operator()(const Eigen::VectorXd& at, Eigen::VectorXd& residuals) const {
    (*of)(at, residuals);
    return 0;
  }
};

/// Fewer values say nothing of a median. Chosen.
constexpr std::size_t kValuesMin = 5;
/// More values do not sharpen the interval, but resampling them costs. Chosen.
constexpr std::size_t kValuesMax = 2000;

template <class Statistic>
std::optional<Estimate> estimate_of(const std::vector<double>& values, int resamples,
                                    const robot::RandomStream& random, const Statistic& statistic) {
  if (values.size() < kValuesMin) {
    return std::nullopt;
  }
  const std::size_t stride = (values.size() + kValuesMax - 1) / kValuesMax;
  const std::size_t taken = values.size() / stride;
  const auto intervals = bootstrap(taken, resamples, random, [&](std::span<const std::size_t> picks) {
    std::vector<double> drawn;
    for (const std::size_t pick : picks) {
      drawn.push_back(values[pick * stride]);
    }
    return std::optional<Eigen::VectorXd>(Eigen::VectorXd::Constant(1, statistic(drawn)));
  });
  Estimate estimate = intervals->front();
  estimate.value = statistic(values);
  return estimate;
}

}  // namespace

std::optional<std::vector<Estimate>> bootstrap(std::size_t items, int resamples, robot::RandomStream random,
                                               const FitOfPicks& fit) {
  std::vector<std::size_t> picks(items);
  std::iota(picks.begin(), picks.end(), std::size_t{0});
  const auto whole = items > 0 ? fit(picks) : std::nullopt;
  if (!whole) {
    return std::nullopt;
  }
  std::vector<std::vector<double>> drawn(static_cast<std::size_t>(whole->size()));
  for (int r = 0; r < resamples; ++r) {
    for (std::size_t& pick : picks) {
      pick = random.below(static_cast<std::uint32_t>(items));
    }
    if (const auto some = fit(picks)) {
      for (std::size_t p = 0; p < drawn.size(); ++p) {
        drawn[p].push_back((*some)(static_cast<Eigen::Index>(p)));
      }
    }
  }
  std::vector<Estimate> estimates;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    const double value = (*whole)(static_cast<Eigen::Index>(p));
    const bool any = !drawn[p].empty();
    estimates.push_back(
        {value, any ? quantile(drawn[p], 0.025) : value, any ? quantile(drawn[p], 0.975) : value});
  }
  return estimates;
}

Eigen::VectorXd least_squares(const Eigen::VectorXd& start, std::size_t count, const Residuals& residuals) {
  const Functor functor{&residuals, static_cast<int>(start.size()), static_cast<int>(count)};
  Eigen::NumericalDiff<Functor, Eigen::Central> differentiated(functor, 1e-10);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Functor, Eigen::Central>> solver(differentiated);
  Eigen::VectorXd at = start;
  solver.minimize(at);
  return at;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

std::optional<Estimate> median_estimate(const std::vector<double>& values, int resamples,
                                        const robot::RandomStream& random) {
  return estimate_of(values, resamples, random,
                     [](const std::vector<double>& v) { return quantile(v, 0.5); });
}

std::optional<Estimate> mean_estimate(const std::vector<double>& values, int resamples,
                                      const robot::RandomStream& random) {
  return estimate_of(values, resamples, random, [](const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
  });
}

}  // namespace sensotwin::twin
