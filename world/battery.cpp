// SPDX-License-Identifier: MIT
#include "world/battery.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace sensotwin::world {
namespace {

constexpr double kResistance_ohm = 0.15;
constexpr double kCharger_ma = 1250.0;
struct CurvePoint {
  double fraction;
  double mv;
};
constexpr std::array<CurvePoint, 5> kCurve = {
    {{0.0, 12000.0}, {0.05, 13500.0}, {0.2, 14200.0}, {0.9, 15200.0}, {1.0, 16200.0}}};

}  // namespace

void Battery::pass(double seconds, double draw_ma, bool charging) {
  current_ma_ = empty() ? 0.0 : -draw_ma;
  if (charging && charge_mah_ < capacity_mah_) {
    current_ma_ += kCharger_ma;
  } else if (charging) {
    current_ma_ = 0.0;  // a full battery rests: the charger carries the electronics
  }
  charge_mah_ = std::clamp(charge_mah_ + current_ma_ * seconds / 3600.0, 0.0, capacity_mah_);
}

double Battery::voltage_mv() const {
  const double fraction = capacity_mah_ > 0.0 ? charge_mah_ / capacity_mah_ : 0.0;
  double open_mv = kCurve.back().mv;
  for (std::size_t i = 1; i < kCurve.size(); ++i) {
    if (fraction <= kCurve[i].fraction) {
      const CurvePoint& low = kCurve[i - 1];
      const CurvePoint& high = kCurve[i];
      open_mv = low.mv + (high.mv - low.mv) * (fraction - low.fraction) / (high.fraction - low.fraction);
      break;
    }
  }
  return open_mv + kResistance_ohm * current_ma_;
}

}  // namespace sensotwin::world
