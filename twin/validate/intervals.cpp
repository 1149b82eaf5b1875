// SPDX-License-Identifier: MIT
#include "twin/validate/intervals.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <limits>

namespace sensotwin::twin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Interval clopper_pearson(int kept, int runs, double tail) {
  using Binomial = boost::math::binomial_distribution<double>;
  return {Binomial::find_lower_bound_on_p(runs, kept, tail),
          Binomial::find_upper_bound_on_p(runs, kept, tail)};
}

Interval wilson(int kept, int runs, double tail) {
  const double z =
      boost::math::quantile(boost::math::complement(boost::math::normal_distribution<double>{}, tail));
  const double n = runs;
  const double p = kept / n;
  const double middle = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 + z * z / n;
  // At 0 and n of n one end is exact; rounding must not push it outside.
  return {kept == 0 ? 0.0 : (middle - half) / scale, kept == runs ? 1.0 : (middle + half) / scale};
}

}  // namespace

Interval rate_interval(int kept, int runs, double confidence, RateMethod method) {
  assert(0 <= kept && kept <= runs && runs > 0 && 0.0 < confidence && confidence < 1.0);
  const double tail = (1.0 - confidence) / 2.0;
  return method == RateMethod::kWilson ? wilson(kept, runs, tail) : clopper_pearson(kept, runs, tail);
}

double mean_of(std::span<const double> values) {
  assert(!values.empty());
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

Interval mean_interval(std::span<const double> values, double confidence) {
  assert(0.0 < confidence && confidence < 1.0);
  if (values.size() < 2) {
    return {-kInfinity, kInfinity};
  }
  const auto n = static_cast<double>(values.size());
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  const boost::math::students_t_distribution<double> law(n - 1.0);
  const double t = boost::math::quantile(boost::math::complement(law, (1.0 - confidence) / 2.0));
  const double half = t * std::sqrt(squares / (n - 1.0) / n);
  return {mean - half, mean + half};
}

double quantile_of(std::span<const double> ascending, double p) {
  assert(!ascending.empty() && std::is_sorted(ascending.begin(), ascending.end()) && 0.0 < p && p < 1.0);
  const double rank = p * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (rank - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}

Interval quantile_interval(std::span<const double> ascending, double p, double confidence) {
  assert(!ascending.empty() && 0.0 < p && p < 1.0 && 0.0 < confidence && confidence < 1.0);
  const double tail = (1.0 - confidence) / 2.0;
  const auto n = static_cast<int>(ascending.size());
  const boost::math::binomial_distribution<double> below(n, p);  // how many values lie below the quantile
  // The highest rank l with P(fewer than l below) <= tail; the lowest rank u with P(u or more below) <= tail.
  int l = 0;
  while (l < n && boost::math::cdf(below, l) <= tail) {
    ++l;
  }
  int u = n + 1;
  while (u > 1 && boost::math::cdf(boost::math::complement(below, u - 2)) <= tail) {
    --u;
  }
  return {l == 0 ? -kInfinity : ascending[static_cast<std::size_t>(l - 1)],
          u > n ? kInfinity : ascending[static_cast<std::size_t>(u - 1)]};
}

}  // namespace sensotwin::twin
