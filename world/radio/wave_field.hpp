// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"

namespace sensotwin::world {

/// A smooth random function of place and frequency, normal with mean 0 in any one of them:
///
///   e(p, f) = sigma sqrt(2 / n) sum_j cos(k_j . p + 2 pi f tau_j + phi_j)
///
/// | symbol       | meaning                                                    | unit  |
/// |--------------|------------------------------------------------------------|-------|
/// | p            | place of the antenna in W                                  | m     |
/// | f            | frequency, from the middle of the band                     | Hz    |
/// | k_j          | normal, 1 / length in each axis                            | rad/m |
/// | tau_j, phi_j | delay, normal with sd delay; phase, uniform                | s     |
///
/// Its correlation over a way d is exp(-(d / length)^2 / 2), over a step of frequency df
/// exp(-(2 pi df delay)^2 / 2): a sum of echoes, seen from far away. Left out: that true echoes of one room
/// are the same for two antennas at one place. Bounded by 4 sigma since there are eight waves.
class WaveField {
 public:
  struct Shape {
    double sigma{0.0};
    double length_m{0.0};  ///< 0: the same at each place
    double delay_s{0.0};   ///< 0: the same at each frequency
  };
  /// Zero everywhere.
  WaveField() = default;
  /// Draws the waves from `random`.
  WaveField(const Shape& shape, robot::RandomStream random);

  [[nodiscard]] double at(const robot::Vec2& p_W_m, double from_band_middle_hz) const;

 private:
  /// Chosen: eight give a kurtosis of 2.8 where the normal law has 3, in some 0.1 microseconds.
  static constexpr std::size_t kWaves = 8;
  struct Wave {
    double x_radpm{0.0};
    double y_radpm{0.0};
    double rad_per_hz{0.0};
    double phase_rad{0.0};
  };
  double amplitude_{0.0};
  std::array<Wave, kWaves> waves_{};
};

}  // namespace sensotwin::world
