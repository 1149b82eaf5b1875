// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "render/phase_views.hpp"
#include "twin/scene/scene.hpp"
#include "world/radio/radio_read.hpp"
#include "world/radio_description.hpp"

namespace sensotwin::twin {

/// Phase errors of a run's reads, as they come: what Figure 7 of Gueaieb & Miah shows of theirs. Against the
/// distance; where the noise follows RSSI, against that.
class PhaseNoise {
 public:
  explicit PhaseNoise(const world::RadioDescription& radio) : radio_(radio) {}

  void add(std::span<const world::RadioRead> reads);
  /// Reads, their deviation by antenna, and the laws they follow. No reads: an empty picture.
  [[nodiscard]] render::NoiseView view(const Scene& scene) const;

 private:
  struct Bin {
    double sum_rad2{0.0};
    long count{0};
  };
  [[nodiscard]] bool by_rssi() const { return radio_.noise_law == world::NoiseLaw::kRssi; }
  [[nodiscard]] double x_of(const world::RadioRead& read) const {
    return by_rssi() ? read.rssi_dbm : read.distance_m;
  }
  [[nodiscard]] std::vector<render::NoiseLawView> laws() const;

  world::RadioDescription radio_;
  std::vector<render::ChartPoint> dots_;
  std::size_t seen_{0};
  std::size_t every_{1};                      ///< so many reads make one dot
  std::map<std::pair<int, long>, Bin> bins_;  ///< by antenna and place on the x axis
};

}  // namespace sensotwin::twin
