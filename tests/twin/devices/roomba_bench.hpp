// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "robot/base/bytes.hpp"
#include "robot/base/time.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::twin {

/// What the sensors of a Roomba see that stands on a floor, as the transcripts have it.
[[nodiscard]] inline world::RoombaInputs at_rest() {
  world::RoombaInputs in;
  in.cliff_signal = {2400, 2400, 2400, 2400};
  in.battery_mv = 16000;
  in.battery_ma = -200;
  in.battery_c = 25;
  in.battery_charge_mah = 2000.0;
  in.battery_capacity_mah = 2696.0;
  return in;
}

/// \returns all that has left on the line
[[nodiscard]] inline robot::Bytes hear(EmulatedRoomba& roomba) {
  std::array<std::uint8_t, 1024> bytes{};
  const std::size_t count = roomba.drain(bytes);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Wheels of a robot on blocks: they follow their targets and integrate their angles.
class FreeWheels {
 public:
  /// \param acceleration_mps2  of the rims; by default they are at their target at once
  explicit FreeWheels(double acceleration_mps2 = 1e9)
      : step_mps_(acceleration_mps2 * robot::to_s(robot::kTick)) {}
  void roll(const world::RoombaOutputs& out, world::RoombaInputs& in) {
    left_mps_ += std::clamp(out.wheel_left_mps - left_mps_, -step_mps_, step_mps_);
    right_mps_ += std::clamp(out.wheel_right_mps - right_mps_, -step_mps_, step_mps_);
    in.wheel_angle_left_rad += left_mps_ * robot::to_s(robot::kTick) / kWheelRadius_m;
    in.wheel_angle_right_rad += right_mps_ * robot::to_s(robot::kTick) / kWheelRadius_m;
  }

 private:
  static constexpr double kWheelRadius_m = 0.036;
  double step_mps_;
  double left_mps_{0.0};
  double right_mps_{0.0};
};

/// A mainboard on the bench, fed bytes and inputs by hand.
class RoombaBoard : public ::testing::Test {
 protected:
  /// Says `bytes`, lets one tick pass. \returns what left on the line
  robot::Bytes say(const robot::Bytes& bytes = {}) {
    roomba_.receive(bytes);
    out_ = roomba_.tick(in_);
    return hear(roomba_);
  }
  void reaches(robot::oi::Mode mode) {
    say({128});
    if (mode == robot::oi::Mode::kSafe || mode == robot::oi::Mode::kFull) {
      say({mode == robot::oi::Mode::kSafe ? std::uint8_t{131} : std::uint8_t{132}});
    }
    ASSERT_EQ(roomba_.mode(), mode);
  }

  EmulatedRoomba roomba_{{.speed_step_mps = 0.0}};
  world::RoombaInputs in_ = at_rest();
  world::RoombaOutputs out_;
};

}  // namespace sensotwin::twin
