// SPDX-License-Identifier: MIT
#include "world/radio/wave_field.hpp"

#include <cmath>

namespace sensotwin::world {

WaveField::WaveField(const Shape& shape, robot::RandomStream random)
    : amplitude_(shape.sigma * std::sqrt(2.0 / static_cast<double>(kWaves))) {
  const double per_m = shape.length_m > 0.0 ? 1.0 / shape.length_m : 0.0;
  for (Wave& wave : waves_) {
    wave.x_radpm = random.normal(0.0, per_m);
    wave.y_radpm = random.normal(0.0, per_m);
    wave.rad_per_hz = 2.0 * robot::kPi * random.normal(0.0, shape.delay_s);
    wave.phase_rad = random.uniform(0.0, 2.0 * robot::kPi);
  }
}

double WaveField::at(const robot::Vec2& p_W_m, double from_band_middle_hz) const {
  if (amplitude_ == 0.0) {
    return 0.0;
  }
  double sum = 0.0;
  for (const Wave& wave : waves_) {
    sum += std::cos(wave.x_radpm * p_W_m.x() + wave.y_radpm * p_W_m.y() +
                    wave.rad_per_hz * from_band_middle_hz + wave.phase_rad);
  }
  return amplitude_ * sum;
}

}  // namespace sensotwin::world
