// SPDX-License-Identifier: MIT
// What the mainboard tells of its inputs: the sensor packets of EmulatedRoomba.
#include <algorithm>
#include <cmath>

#include "robot/wire/sci.hpp"
#include "twin/devices/emulated_roomba.hpp"

namespace sensotwin::twin {

using robot::oi::Mode;
using robot::oi::PacketId;
using robot::oi::SensorValues;

namespace {

[[nodiscard]] std::int32_t bit(bool on, int mask) {
  return on ? mask : 0;
}

void set_from(SensorValues& values, PacketId first, std::size_t offset, std::int32_t value) {
  values[static_cast<PacketId>(static_cast<std::size_t>(first) + offset)] = value;
}

void set_touch(SensorValues& values, const world::RoombaInputs& in) {
  namespace oi = robot::oi;
  values[PacketId::kBumpsAndWheelDrops] =
      bit(in.bump_right, oi::kBumpRight) | bit(in.bump_left, oi::kBumpLeft) |
      bit(in.wheel_drop_right, oi::kWheelDropRight) | bit(in.wheel_drop_left, oi::kWheelDropLeft);
  for (std::size_t i = 0; i < in.cliff.size(); ++i) {
    set_from(values, PacketId::kCliffLeft, i, in.cliff[i] ? 1 : 0);
    set_from(values, PacketId::kCliffLeftSignal, i, std::min<int>(in.cliff_signal[i], 4095));
  }
}

void set_light(SensorValues& values, const world::RoombaInputs& in, const EmulatedRoombaConfig& config) {
  std::int32_t seen = 0;
  for (std::size_t i = 0; i < in.light_bump_signal.size(); ++i) {
    const int signal = std::min<int>(in.light_bump_signal[i], 4095);
    seen |= bit(signal >= config.light_bump_threshold, 1 << i);
    set_from(values, PacketId::kLightBumpLeft, i, signal);
  }
  values[PacketId::kLightBumper] = seen;
  const int wall = std::min<int>(in.wall_signal, 1023);
  values[PacketId::kWallSignal] = wall;
  values[PacketId::kWall] = wall >= config.wall_threshold ? 1 : 0;
  values[PacketId::kVirtualWall] = in.virtual_wall ? 1 : 0;
  values[PacketId::kInfraredOmni] = in.ir_omni;
  values[PacketId::kInfraredLeft] = in.ir_left;
  values[PacketId::kInfraredRight] = in.ir_right;
  values[PacketId::kDirt] = in.dirt;
}

void set_motors(SensorValues& values, const world::RoombaInputs& in, int overcurrent_ma) {
  namespace oi = robot::oi;
  // Left wheel, right wheel, main brush, side brush.
  constexpr std::array<int, 4> kBits{oi::kOvercurrentLeftWheel, oi::kOvercurrentRightWheel,
                                     oi::kOvercurrentMainBrush, oi::kOvercurrentSideBrush};
  std::int32_t overcurrents = 0;
  for (std::size_t i = 0; i < in.motor_ma.size(); ++i) {
    overcurrents |= bit(std::abs(in.motor_ma[i]) > overcurrent_ma, kBits[i]);
    set_from(values, PacketId::kLeftMotorCurrent, i, in.motor_ma[i]);
  }
  values[PacketId::kOvercurrents] = overcurrents;
}

void set_battery(SensorValues& values, const world::RoombaInputs& in) {
  const auto whole_mah = [](double mah) { return static_cast<std::int32_t>(std::clamp(mah, 0.0, 65535.0)); };
  values[PacketId::kVoltage] = in.battery_mv;
  values[PacketId::kCurrent] = in.battery_ma;
  values[PacketId::kTemperature] = in.battery_c;  // NOLINT(bugprone-signed-char-misuse): below zero is meant
  values[PacketId::kCharge] = whole_mah(in.battery_charge_mah);
  values[PacketId::kCapacity] = whole_mah(in.battery_capacity_mah);
  values[PacketId::kChargingSources] =
      bit(in.internal_charger, robot::oi::kInternalCharger) | bit(in.on_home_base, robot::oi::kHomeBase);
}

/// Charging stops in safe and full mode (page 7).
[[nodiscard]] robot::oi::ChargingState charging_state(const world::RoombaInputs& in, Mode mode) {
  using robot::oi::ChargingState;
  if ((!in.on_home_base && !in.internal_charger) || mode == Mode::kSafe || mode == Mode::kFull) {
    return ChargingState::kNotCharging;
  }
  return in.battery_charge_mah < in.battery_capacity_mah ? ChargingState::kFullCharging
                                                         : ChargingState::kTrickle;
}

/// "Capped at its minimum or maximum" (page 27).
[[nodiscard]] std::int32_t capped(double value) {
  return static_cast<std::int32_t>(std::clamp(value, -32767.0, 32767.0));
}

/// What stays for the next read once the whole units have been told.
[[nodiscard]] double remainder_of(double value) {
  return std::abs(value) > 32767.0 ? 0.0 : value - std::trunc(value);
}

}  // namespace

void EmulatedRoomba::update_values() {
  set_touch(values_, inputs_);
  set_light(values_, inputs_, config_);
  set_motors(values_, inputs_, config_.overcurrent_ma);
  set_battery(values_, inputs_);
  values_[PacketId::kChargingState] = static_cast<std::int32_t>(charging_state(inputs_, mode_));
  values_[PacketId::kButtons] = inputs_.buttons | pushed_buttons_;
  const bool forward = outputs_.wheel_left_mps > 0.0 && outputs_.wheel_left_mps == outputs_.wheel_right_mps;
  values_[PacketId::kStasis] = bit(forward && inputs_.forward_progress, robot::oi::kForwardProgress);
  values_[PacketId::kMode] = static_cast<std::int32_t>(mode_) + (config_.mode_one_too_high ? 1 : 0);
  values_[PacketId::kSongNumber] = song_number_;
  values_[PacketId::kSongPlaying] = song_playing() ? 1 : 0;
  values_[PacketId::kStreamPackets] = stream_.count;
  update_motion_values();
}

void EmulatedRoomba::update_motion_values() {
  values_[PacketId::kDistance] = capped(distance_mm_);
  values_[PacketId::kAngle] = capped(angle_);
  values_[PacketId::kRequestedVelocity] = requested_drive_.velocity_mm_s;
  const bool wrong_mm = config_.firmware < FirmwareVersion{3, 3, 0};
  values_[PacketId::kRequestedRadius] =
      wrong_mm ? -requested_drive_.radius_mm / 10 : int{requested_drive_.radius_mm};
  values_[PacketId::kRequestedRight] = requested_direct_.right_mm_s;
  values_[PacketId::kRequestedLeft] = requested_direct_.left_mm_s;
  values_[PacketId::kEncoderLeft] = static_cast<std::int16_t>(left_.ticks().raw);
  values_[PacketId::kEncoderRight] = static_cast<std::int16_t>(right_.ticks().raw);
}

void EmulatedRoomba::clear_motion(std::uint8_t id) {
  if (robot::oi::covers(id, PacketId::kDistance)) {
    distance_mm_ = remainder_of(distance_mm_);
  }
  if (robot::oi::covers(id, PacketId::kAngle)) {
    angle_ = config_.truncate_angle ? 0.0 : remainder_of(angle_);
  }
}

}  // namespace sensotwin::twin
