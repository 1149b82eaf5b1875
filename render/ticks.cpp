// SPDX-License-Identifier: MIT
#include "render/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sensotwin::render {
namespace {

/// Rounding of the tick arithmetic, as a share of the step.
constexpr double kSlack = 1e-6;

[[nodiscard]] double round_step(double span, int wanted) {
  const double raw = span / std::max(1, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (raw <= factor * power * (1.0 + kSlack)) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

}  // namespace

std::string plain_number(double value) {
  return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value);
}

std::vector<Tick> linear_ticks(double low, double high, int wanted) {
  if (!(high > low)) {
    return {{low, plain_number(low)}};
  }
  const double step = round_step(high - low, wanted);
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - kSlack)), 0, 9);
  // 2.5 and 0.25 need a digit more than their power of ten.
  const double scaled = step * std::pow(10.0, decimals);
  const int digits = std::abs(scaled - std::round(scaled)) > kSlack ? decimals + 1 : decimals;
  std::vector<Tick> ticks;
  const double first = std::ceil(low / step - kSlack);
  for (double k = first; k * step <= high + kSlack * step; k += 1.0) {
    const double value = k == 0.0 ? 0.0 : k * step;
    ticks.push_back({value, fmt::format("{:.{}f}", value, digits)});
  }
  // A coarse step may fall inside a range once only, and one label tells no scale.
  constexpr int kFinest = 64;
  return ticks.size() < 2 && wanted < kFinest ? linear_ticks(low, high, 2 * wanted) : ticks;
}

std::vector<Tick> log_ticks(double low, double high) {
  std::vector<Tick> powers;
  std::vector<Tick> all;
  for (double e = std::floor(std::log10(low)); e <= std::ceil(std::log10(high)); e += 1.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, e);
      if (value < low * (1.0 - kSlack) || value > high * (1.0 + kSlack)) {
        continue;
      }
      all.push_back({value, plain_number(value)});
      if (factor == 1.0) {
        powers.push_back(all.back());
      }
    }
  }
  return powers.size() >= 3 ? powers : all;
}

double round_length_below(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  double best = power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power <= limit * (1.0 + kSlack)) {
      best = factor * power;
    }
  }
  return best;
}

}  // namespace sensotwin::render
