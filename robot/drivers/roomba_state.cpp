// SPDX-License-Identifier: MIT
#include "robot/drivers/roomba_state.hpp"

#include "robot/wire/oi_stream.hpp"
#include "robot/wire/sci.hpp"

namespace sensotwin::robot {
namespace {

using oi::PacketId;
using oi::SensorValues;

[[nodiscard]] bool has(std::int32_t bits, int bit) {
  return (bits & bit) != 0;
}

[[nodiscard]] std::int32_t at(const SensorValues& values, PacketId first, std::size_t offset) {
  return values[static_cast<PacketId>(static_cast<std::size_t>(first) + offset)];
}

/// Packets 7 to 18 and 21 to 26, which both kinds of robot send.
void assign_common(RoombaState& state, const SensorValues& values) {
  const std::int32_t bumps = values[PacketId::kBumpsAndWheelDrops];
  state.bump_right = has(bumps, oi::kBumpRight);
  state.bump_left = has(bumps, oi::kBumpLeft);
  state.wheel_drop_right = has(bumps, oi::kWheelDropRight);
  state.wheel_drop_left = has(bumps, oi::kWheelDropLeft);
  for (std::size_t i = 0; i < state.cliff.size(); ++i) {
    state.cliff[i] = at(values, PacketId::kCliffLeft, i) != 0;
  }
  state.wall = values[PacketId::kWall] != 0;
  state.virtual_wall = values[PacketId::kVirtualWall] != 0;
  const std::int32_t overcurrents = values[PacketId::kOvercurrents];
  state.overcurrent_left_wheel = has(overcurrents, oi::kOvercurrentLeftWheel);
  state.overcurrent_right_wheel = has(overcurrents, oi::kOvercurrentRightWheel);
  state.overcurrent_main_brush = has(overcurrents, oi::kOvercurrentMainBrush);
  state.overcurrent_side_brush = has(overcurrents, oi::kOvercurrentSideBrush);
  state.dirt = static_cast<std::uint8_t>(values[PacketId::kDirt]);
  state.infrared_omni = static_cast<std::uint8_t>(values[PacketId::kInfraredOmni]);
  state.buttons = static_cast<std::uint8_t>(values[PacketId::kButtons]);
  state.charging = static_cast<oi::ChargingState>(values[PacketId::kChargingState]);
  state.battery_mv = static_cast<std::uint16_t>(values[PacketId::kVoltage]);
  state.battery_ma = static_cast<std::int16_t>(values[PacketId::kCurrent]);
  state.battery_c = static_cast<std::int8_t>(values[PacketId::kTemperature]);
  state.charge_mah = static_cast<std::uint16_t>(values[PacketId::kCharge]);
  state.capacity_mah = static_cast<std::uint16_t>(values[PacketId::kCapacity]);
}

[[nodiscard]] LightBumperReading light_bumper(const SensorValues& values) {
  LightBumperReading reading;
  for (std::size_t i = 0; i < reading.signal.size(); ++i) {
    reading.seen[i] = has(values[PacketId::kLightBumper], 1 << i);
    reading.signal[i] = static_cast<std::uint16_t>(at(values, PacketId::kLightBumpLeft, i));
  }
  return reading;
}

[[nodiscard]] ExtendedState extended(const SensorValues& values) {
  ExtendedState out;
  for (std::size_t i = 0; i < out.cliff_signal.size(); ++i) {
    out.cliff_signal[i] = static_cast<std::uint16_t>(at(values, PacketId::kCliffLeftSignal, i));
    out.motor_ma[i] = static_cast<std::int16_t>(at(values, PacketId::kLeftMotorCurrent, i));
  }
  out.wall_signal = static_cast<std::uint16_t>(values[PacketId::kWallSignal]);
  out.infrared_left = static_cast<std::uint8_t>(values[PacketId::kInfraredLeft]);
  out.infrared_right = static_cast<std::uint8_t>(values[PacketId::kInfraredRight]);
  out.on_internal_charger = has(values[PacketId::kChargingSources], oi::kInternalCharger);
  out.on_home_base = has(values[PacketId::kChargingSources], oi::kHomeBase);
  out.forward_progress = has(values[PacketId::kStasis], oi::kForwardProgress);
  out.requested_left_mm_s = static_cast<std::int16_t>(values[PacketId::kRequestedLeft]);
  out.requested_right_mm_s = static_cast<std::int16_t>(values[PacketId::kRequestedRight]);
  return out;
}

constexpr std::size_t kStreamBytes = [] {
  std::size_t bytes = oi::kStreamOverhead;
  for (const std::uint8_t id : kStreamedPackets) {
    bytes += id >= 7 && id <= 58 ? 3u : 1000u;  // at most: id and two bytes
  }
  return bytes;
}();
static_assert(kStreamBytes <= oi::kMaxFrameBytes, "the stream fits into 15 ms at 115200 baud");

}  // namespace

void assign_open_interface(RoombaState& state, const SensorValues& values, int mode_offset) {
  assign_common(state, values);
  state.wheel_drop_caster = false;
  state.mode = static_cast<oi::Mode>(values[PacketId::kMode] - mode_offset);
  state.encoders = EncoderCounts{{static_cast<std::uint16_t>(values[PacketId::kEncoderLeft])},
                                 {static_cast<std::uint16_t>(values[PacketId::kEncoderRight])}};
  state.light_bumper = light_bumper(values);
  state.extended = extended(values);
  state.travel.reset();
}

void assign_sci(RoombaState& state, const SensorValues& values) {
  assign_common(state, values);
  state.wheel_drop_caster = has(values[PacketId::kBumpsAndWheelDrops], sci::kWheelDropCaster);
  state.mode.reset();
  state.encoders.reset();
  state.light_bumper.reset();
  state.extended.reset();
  state.travel = Travel{values[PacketId::kDistance] * 1e-3, sci::turn_rad(values[PacketId::kAngle])};
}

}  // namespace sensotwin::robot
