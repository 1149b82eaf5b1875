// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

/// The edge between the Roomba's body (world/) and its mainboard (the emulator in twin/devices): what the
/// sensors hand to the electronics, and what the electronics ask of motors. No pose, no truth beyond it.
namespace sensotwin::world {

/// Sampled by the mainboard every 15 ms. Left-to-right order in the arrays, as the Open Interface lists them.
struct RoombaInputs {
  bool bump_left{false};
  bool bump_right{false};
  bool wheel_drop_left{false};
  bool wheel_drop_right{false};
  /// Left, front left, front right, right: true over a hole.
  std::array<bool, 4> cliff{};
  /// Floor reflection, 0..4095, same order.
  std::array<std::uint16_t, 4> cliff_signal{};
  /// Light bumper left, front left, centre left, centre right, front right, right: 0..4095.
  std::array<std::uint16_t, 6> light_bump_signal{};
  std::uint16_t wall_signal{0};  ///< 0..1023, right side
  bool virtual_wall{false};
  std::uint8_t ir_omni{0};
  std::uint8_t ir_left{0};
  std::uint8_t ir_right{0};
  std::uint8_t dirt{0};
  /// Cumulative rotation of each wheel, positive forward, rad. The electronics see it as a square wave only.
  double wheel_angle_left_rad{0.0};
  double wheel_angle_right_rad{0.0};
  bool forward_progress{false};  ///< the stasis castor turns
  /// Motor currents, mA: left wheel, right wheel, main brush, side brush.
  std::array<std::int16_t, 4> motor_ma{};
  std::uint16_t battery_mv{0};
  std::int16_t battery_ma{0};  ///< negative when discharging
  std::int8_t battery_c{0};
  double battery_charge_mah{0.0};
  double battery_capacity_mah{0.0};
  bool on_home_base{false};  ///< home base contacts powered
  bool internal_charger{false};
  bool power{true};  ///< false when the battery is empty: the electronics are dead
  std::uint8_t buttons{0};
};

/// Held until the next call.
struct RoombaOutputs {
  double wheel_left_mps{0.0};  ///< target of the wheel's own speed controller
  double wheel_right_mps{0.0};
  double main_brush{0.0};  ///< duty cycle, -1..1
  double side_brush{0.0};
  double vacuum{0.0};           ///< 0..1
  bool charging_allowed{true};  ///< not in safe or full mode
};

}  // namespace sensotwin::world
