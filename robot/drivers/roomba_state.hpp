// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/base/time.hpp"
#include "robot/wire/oi_opcodes.hpp"
#include "robot/wire/oi_packets.hpp"
#include "robot/wire/ticks.hpp"

namespace sensotwin::robot {

struct EncoderCounts {
  Ticks left{};
  Ticks right{};
  bool operator==(const EncoderCounts&) const = default;
};

/// What a Roomba 400 says of its motion in place of encoder counts: since its last answer, whether or not
/// that one arrived.
struct Travel {
  double distance_m{0.0};
  double turn_rad{0.0};  ///< counter-clockwise
  bool operator==(const Travel&) const = default;
};

/// Infrared rangers in the bumper: left, front left, centre left, centre right, front right, right.
struct LightBumperReading {
  std::array<bool, 6> seen{};
  std::array<std::uint16_t, 6> signal{};  ///< 0..4095
};

/// What the later robots tell beyond the Roomba 400.
struct ExtendedState {
  std::array<std::uint16_t, 4> cliff_signal{};  ///< 0..4095: left, front left, front right, right
  std::uint16_t wall_signal{0};                 ///< 0..1023
  std::uint8_t infrared_left{0};
  std::uint8_t infrared_right{0};
  bool on_internal_charger{false};
  bool on_home_base{false};
  std::array<std::int16_t, 4> motor_ma{};  ///< left wheel, right wheel, main brush, side brush
  bool forward_progress{false};            ///< the stasis castor turns
  std::int16_t requested_left_mm_s{0};     ///< as the robot understood Drive Direct
  std::int16_t requested_right_mm_s{0};
};

/// The robot at one sensor update. The optional parts are missing on a Roomba 400 (SCI), but `travel`, which
/// only that one has.
struct RoombaState {
  Instant stamp{};                ///< when the driver took the frame from the port
  std::uint64_t frame_number{0};  ///< good frames so far, this one included
  std::optional<oi::Mode> mode{};
  bool bump_left{false};
  bool bump_right{false};
  bool wheel_drop_left{false};
  bool wheel_drop_right{false};
  bool wheel_drop_caster{false};  ///< Roomba 400 only
  std::array<bool, 4> cliff{};    ///< left, front left, front right, right
  bool wall{false};
  bool virtual_wall{false};
  bool overcurrent_left_wheel{false};
  bool overcurrent_right_wheel{false};
  bool overcurrent_main_brush{false};
  bool overcurrent_side_brush{false};
  std::uint8_t dirt{0};
  std::uint8_t infrared_omni{0};
  std::uint8_t buttons{0};  ///< bits of packet 18, which differ between the robots
  oi::ChargingState charging{oi::ChargingState::kNotCharging};
  std::uint16_t battery_mv{0};
  std::int16_t battery_ma{0};  ///< negative when discharging
  std::int8_t battery_c{0};
  std::uint16_t charge_mah{0};
  std::uint16_t capacity_mah{0};
  std::optional<EncoderCounts> encoders{};
  std::optional<LightBumperReading> light_bumper{};
  std::optional<ExtendedState> extended{};
  std::optional<Travel> travel{};
};

/// Packets that the driver asks a robot of the Open Interface to stream: all that RoombaState holds, in the
/// order of their ids. Distance and angle are left out because a lost frame would lose what it cleared; the
/// cumulative encoder counts lose nothing.
inline constexpr std::array<std::uint8_t, 42> kStreamedPackets{
    7,  8,  9,  10, 11, 12, 13, 14, 15, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30,
    31, 34, 35, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58};

/// The state that `values` spell; stamp and frame_number are left to the caller.
/// \param mode_offset  what the robot adds to packet 35 (some Wi-Fi models: 1)
void assign_open_interface(RoombaState& state, const oi::SensorValues& values, int mode_offset);
/// The same for the 26 bytes of a Roomba 400.
void assign_sci(RoombaState& state, const oi::SensorValues& values);

}  // namespace sensotwin::robot
