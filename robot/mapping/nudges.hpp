// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace sensotwin::robot {

/// Feels its way past something that one side of the bumper touches: each touch moves the aim a little to the
/// other side, for as long as that brings the robot on.
class Nudges {
 public:
  /// \param aim_left_m  where the robot aims, to the left of its line
  /// \param most_m      as far aside as the aim may go
  explicit Nudges(double aim_left_m = 0.0, double most_m = 0.06) : aim_left_m_(aim_left_m), most_m_(most_m) {}

  /// Touched. \param side  +1 left only, -1 right only, 0 both. \param along_m  how far along its line
  /// \returns false when there is no more use in it
  [[nodiscard]] bool away_from(int side, double along_m) {
    futile_ = along_m > furthest_m_ + kProgress_m ? 0 : futile_ + 1;
    furthest_m_ = std::max(furthest_m_, along_m);
    aim_left_m_ = std::clamp(aim_left_m_ - side * kNudge_m, -most_m_, most_m_);
    return side != 0 && futile_ <= kFutileNudges && ++count_ <= kNudges;
  }
  [[nodiscard]] double aim_left_m() const { return aim_left_m_; }
  [[nodiscard]] bool any() const { return count_ > 0; }

 private:
  /// A one-sided bump moves the aim away from that side by this much, so many times.
  static constexpr double kNudge_m = 0.015;
  static constexpr int kNudges = 8;
  static constexpr int kFutileNudges = 3;
  /// Progress between two bumps that counts as getting past something.
  static constexpr double kProgress_m = 0.01;

  double aim_left_m_;
  double most_m_;
  double furthest_m_{-1.0};
  int count_{0};
  int futile_{0};
};

}  // namespace sensotwin::robot
