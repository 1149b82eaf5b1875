// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "world/radio/profiles.hpp"
#include "world/radio/radio.hpp"

namespace sensotwin::world {

/// A tag 3 m up at the origin, its own phase known, and antennas 16 cm apart on a robot below.
inline RadioWorld one_tag(std::size_t antennas = 2) {
  RadioWorld world;
  world.tags.push_back({.name = "a", .phase_offset_rad = 0.0});
  for (std::size_t i = 0; i < antennas; ++i) {
    world.antennas.push_back({.at_m = {0.0, 0.08 - 0.16 * static_cast<double>(i), 0.1}});
  }
  world.radio.noise_per_m_rad = 0.0;
  return world;
}

/// One antenna after another, with the slots given.
inline void multiplex(RadioWorld& world, std::vector<double> slots_s) {
  world.radio.simultaneous = false;
  world.radio.slots_s = std::move(slots_s);
}

inline std::vector<RadioRead> reads_at_rest(Radio& radio, const robot::Pose2& X_WR, double end_s) {
  const auto arrived = radio.step({.begin_s = 0.0, .end_s = end_s, .X_WR_begin = X_WR, .X_WR_end = X_WR});
  return {arrived.begin(), arrived.end()};
}
inline std::vector<RadioRead> reads_at_rest(const RadioWorld& world, double end_s,
                                            const robot::Pose2& X_WR = {}, std::uint64_t seed = 1) {
  Radio radio(world, robot::RandomStream{seed});
  return reads_at_rest(radio, X_WR, end_s);
}

/// Angle between two phases, in (-pi, pi].
inline double between_rad(double a_rad, double b_rad) {
  return robot::wrap_angle(a_rad - b_rad);
}

/// Mean and standard deviation about it, of angles close together.
struct Spread {
  double mean_rad{0.0};
  double sigma_rad{0.0};
};
inline Spread spread_of(const std::vector<RadioRead>& reads) {
  std::complex<double> sum;
  for (const RadioRead& read : reads) {
    sum += std::polar(1.0, read.phase_rad);
  }
  Spread spread{.mean_rad = std::arg(sum)};
  for (const RadioRead& read : reads) {
    spread.sigma_rad += std::pow(between_rad(read.phase_rad, spread.mean_rad), 2);
  }
  spread.sigma_rad = std::sqrt(spread.sigma_rad / static_cast<double>(reads.size()));
  return spread;
}

inline constexpr double kLight_mps = 299'792'458.0;

}  // namespace sensotwin::world
