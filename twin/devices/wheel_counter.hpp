// SPDX-License-Identifier: MIT
#pragma once

#include "robot/wire/ticks.hpp"

namespace sensotwin::twin {

/// The square-wave encoder of one wheel, as the mainboard reads it: it sees edges pass and not which way, and
/// counts them in the direction the wheel is commanded in; upwards when it is commanded to stand
/// (Create 2 Open Interface, 2016, page 30).
///
/// "Commanded" is the set-point of the wheel's speed controller on its way to the target, so that a wheel
/// that still runs out after a stop or before a reversal is counted the right way. What set-point and wheel
/// lag behind each other is the honest error of the device.
class WheelCounter {
 public:
  /// \param acceleration_mps2  of the set-point towards the target
  WheelCounter(double counts_per_turn, double acceleration_mps2, robot::Ticks start);

  /// One 15 ms tick.
  /// \param angle_rad   the wheel's cumulative rotation now
  /// \param target_mps  the speed it was told during the tick
  /// \returns signed counts of this tick
  int update(double angle_rad, double target_mps);
  [[nodiscard]] robot::Ticks ticks() const { return ticks_; }
  /// As after a power cycle; the wheel stays where it is.
  void reset();

 private:
  /// Ticks for which a set-point of zero still counts the way it came: the wheel runs out. Chosen: 60 ms.
  static constexpr int kRunOutTicks = 4;

  double edges_per_rad_;
  double set_point_step_mps_;
  robot::Ticks ticks_;
  double edge_{0.0};
  bool edge_known_{false};
  double set_point_mps_{0.0};
  int direction_{1};
  int standing_ticks_{0};
};

}  // namespace sensotwin::twin
