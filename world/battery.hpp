// SPDX-License-Identifier: MIT
#pragma once

#include "world/description.hpp"

namespace sensotwin::world {

/// The Roomba's 12-cell NiMH battery.
///
///   charge <- charge + I h / 3600       I < 0 while current is drawn, mA; charge in mAh within [0, capacity]
///   terminal voltage = E(charge / capacity) + R I
///
/// E is a straight-line table of a NiMH cell's discharge curve times twelve, R = 0.15 ohm. Both chosen: 1.0 V
/// a cell when flat, a plateau near 1.2 V, 1.35 V when just charged; clients expect 13 to 17 V (protocols
/// study, 1.3). Leaves out: temperature, ageing, self-discharge, the charger's own phases (it gives 1.25 A
/// until full; chosen: the home base's rated current).
class Battery {
 public:
  explicit Battery(const RoombaDescription& base)
      : charge_mah_(base.battery_charge_mah), capacity_mah_(base.battery_capacity_mah) {}

  /// \param draw_ma current of the whole machine, not negative; nothing is drawn from an empty battery
  void pass(double seconds, double draw_ma, bool charging);

  [[nodiscard]] bool empty() const { return charge_mah_ <= 0.0; }
  [[nodiscard]] double charge_mah() const { return charge_mah_; }
  [[nodiscard]] double capacity_mah() const { return capacity_mah_; }
  /// Of the last pass; negative when discharging.
  [[nodiscard]] double current_ma() const { return current_ma_; }
  [[nodiscard]] double voltage_mv() const;

 private:
  double charge_mah_;
  double capacity_mah_;
  double current_ma_{0.0};
};

}  // namespace sensotwin::world
