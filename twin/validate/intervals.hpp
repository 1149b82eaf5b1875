// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

/// Confidence intervals, two-sided: each end is missed with at most half of 1 - confidence. Nothing is drawn
/// at random. `confidence` lies between 0 and 1, both excluded, everywhere.
namespace sensotwin::twin {

/// An end that the sample cannot bound is infinite.
struct Interval {
  double low{0.0};
  double high{0.0};
};

enum class RateMethod : std::uint8_t {
  kClopperPearson,  ///< never covers less than it says (Biometrika 26(4), 1934); wide
  kWilson,          ///< covers what it says on average (J. Am. Stat. Assoc. 22(158), 1927); narrower
};

/// Of a probability that showed `kept` times in `runs`. By Boost.Math for Clopper and Pearson; for Wilson
///
///   (p + z^2/2n -+ z sqrt(p(1-p)/n + z^2/4n^2)) / (1 + z^2/n),   p = kept / n
///
/// \pre 0 <= kept <= runs, 0 < runs
[[nodiscard]] Interval rate_interval(int kept, int runs, double confidence, RateMethod method);

/// \pre not empty
[[nodiscard]] double mean_of(std::span<const double> values);
/// Student's t: mean -+ t(n-1) s / sqrt(n). Exact for normal values; means of some dozens of others are
/// nearly normal. One value bounds nothing. \pre not empty
[[nodiscard]] Interval mean_interval(std::span<const double> values, double confidence);

/// Linear between order statistics (type 7 of Hyndman and Fan, Am. Stat. 50(4), 1996).
/// \pre not empty, ascending; 0 < p < 1
[[nodiscard]] double quantile_of(std::span<const double> ascending, double p);
/// Between two order statistics whose ranks the binomial law of (n, p) gives: whatever the law of the values,
/// it covers at least what it says (David and Nagaraja, Order Statistics, 3rd ed., section 7.1). Few values
/// bound an outer quantile on its inner side only: 95 % needs 72 of them for an upper end at 95 % confidence.
/// \pre not empty, ascending; 0 < p < 1
[[nodiscard]] Interval quantile_interval(std::span<const double> ascending, double p, double confidence);

}  // namespace sensotwin::twin
