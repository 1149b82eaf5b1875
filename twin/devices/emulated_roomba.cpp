// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_roomba.hpp"

#include <algorithm>
#include <cmath>

#include "robot/base/time.hpp"
#include "robot/wire/oi_drive.hpp"
#include "robot/wire/oi_stream.hpp"
#include "robot/wire/sci.hpp"
#include "twin/devices/roomba_commands.hpp"

namespace sensotwin::twin {

using robot::oi::Mode;
using robot::oi::PacketId;

namespace {

constexpr double kTick_s = robot::to_s(robot::kTick);
/// "After five minutes of inactivity" (page 7).
constexpr int kSleepTicks = static_cast<int>(300.0 / kTick_s);
/// 8N1: ten bits a byte.
constexpr double kBitsPerByte = 10.0;

}  // namespace

EmulatedRoomba::EmulatedRoomba(const EmulatedRoombaConfig& config)
    : config_(config),
      table_(is_sci() ? &robot::oi::kSerialCommandInterface : &robot::oi::kOpenInterface),
      decoder_(*table_),
      baud_(is_sci() ? robot::sci::kBaud : robot::oi::kBauds.back()),
      left_(config.body.counts_per_turn, config.body.wheel_acceleration_mps2, config.encoder_start_left),
      right_(config.body.counts_per_turn, config.body.wheel_acceleration_mps2, config.encoder_start_right) {}

void EmulatedRoomba::receive(robot::ByteView bytes) {
  if (!powered_ || asleep_ || bytes.empty()) {
    return;
  }
  quiet_ticks_ = 0;
  for (const std::uint8_t byte : bytes) {
    const auto command = decoder_.push(byte);
    if (command && *command) {
      RoombaCommands{*this}.obey(**command);
    }
    if (asleep_) {
      return;
    }
  }
}

world::RoombaOutputs EmulatedRoomba::tick(const world::RoombaInputs& inputs) {
  inputs_ = inputs;
  if (!inputs.power) {
    if (powered_) {
      boot();
      powered_ = false;
    }
    return outputs_;
  }
  if (!powered_) {
    powered_ = true;
    RoombaCommands{*this}.print_welcome();
  }
  count_wheels();
  run_timers();
  react_to_hazards();
  const double bytes_per_tick = baud_ * kTick_s / kBitsPerByte;
  line_allowance_ = std::max<std::size_t>(1, static_cast<std::size_t>(bytes_per_tick));
  if (streaming_ && mode_ != Mode::kOff) {
    queue_stream_frame();
  }
  outputs_.charging_allowed = mode_ != Mode::kSafe && mode_ != Mode::kFull;
  return outputs_;
}

std::size_t EmulatedRoomba::drain(std::span<std::uint8_t> into) {
  const std::size_t count = std::min({into.size(), line_held_, line_allowance_});
  const std::size_t to_the_end = std::min(count, kLineBytes - line_begin_);
  std::copy_n(line_.begin() + static_cast<std::ptrdiff_t>(line_begin_), to_the_end, into.begin());
  std::copy_n(line_.begin(), count - to_the_end, into.begin() + static_cast<std::ptrdiff_t>(to_the_end));
  line_begin_ = (line_begin_ + count) % kLineBytes;
  line_held_ -= count;
  line_allowance_ -= count;
  return count;
}

void EmulatedRoomba::pulse_brc() {
  asleep_ = false;
  quiet_ticks_ = 0;
}

/// As if the battery had been removed and put back.
void EmulatedRoomba::boot() {
  enter(Mode::kOff);
  decoder_.reset();
  left_.reset();
  right_.reset();
  distance_mm_ = 0.0;
  angle_ = 0.0;
  songs_ = {};
  song_number_ = 0;
  song_left_s_ = 0.0;
  pushed_buttons_ = 0;
  asleep_ = false;
  quiet_ticks_ = 0;
  baud_ = is_sci() ? robot::sci::kBaud : robot::oi::kBauds.back();
  line_held_ = 0;
}

void EmulatedRoomba::enter(Mode mode) {
  const bool was_controlled = mode_ == Mode::kSafe || mode_ == Mode::kFull;
  mode_ = mode;
  if (mode == Mode::kOff) {
    stream_ = {};
    streaming_ = false;
  }
  if (mode == Mode::kSafe || mode == Mode::kFull) {
    panel_ = {};
  } else if (was_controlled) {
    stop_motors();
  }
  react_to_hazards();
}

void EmulatedRoomba::stop_motors() {
  outputs_ = {};
  requested_drive_ = {};
  requested_direct_ = {};
}

void EmulatedRoomba::fall_asleep() {
  enter(Mode::kOff);
  decoder_.reset();
  asleep_ = true;
}

void EmulatedRoomba::request_wheels(double left_mps, double right_mps) {
  const auto reachable = [this](double speed_mps) {
    const double step = config_.speed_step_mps;
    const double stepped = step > 0.0 ? std::round(speed_mps / step) * step : speed_mps;
    return std::clamp(stepped, -config_.body.speed_max_mps, config_.body.speed_max_mps);
  };
  outputs_.wheel_left_mps = reachable(left_mps);
  outputs_.wheel_right_mps = reachable(right_mps);
  react_to_hazards();
}

/// The conditions of page 7. Forward: the robot's centre moves forward, or not at all while its front swings
/// round.
bool EmulatedRoomba::must_leave_safe_mode() const {
  if (inputs_.wheel_drop_left || inputs_.wheel_drop_right || charger_present()) {
    return true;
  }
  const bool over_cliff = std::ranges::find(inputs_.cliff, true) != inputs_.cliff.end();
  const double sum_mps = outputs_.wheel_left_mps + outputs_.wheel_right_mps;
  const double difference_mps = std::abs(outputs_.wheel_right_mps - outputs_.wheel_left_mps);
  // |R| = (b / 2) |l + r| / |r - l| below one robot radius.
  const bool turns_tightly = difference_mps > 0.0 && 0.5 * config_.body.wheel_base_m * std::abs(sum_mps) <
                                                         config_.body.radius_m * difference_mps;
  return over_cliff && (sum_mps > 0.0 || turns_tightly);
}

void EmulatedRoomba::react_to_hazards() {
  if (mode_ == Mode::kSafe && must_leave_safe_mode()) {
    mode_ = Mode::kPassive;
    stop_motors();
  }
}

void EmulatedRoomba::count_wheels() {
  const double mm_per_count = robot::kPi * config_.body.wheel_diameter_m * 1e3 / config_.body.counts_per_turn;
  const double left_mm = left_.update(inputs_.wheel_angle_left_rad, outputs_.wheel_left_mps) * mm_per_count;
  const double right_mm =
      right_.update(inputs_.wheel_angle_right_rad, outputs_.wheel_right_mps) * mm_per_count;
  const double wrong_mm = !is_sci() && config_.firmware < FirmwareVersion{3, 3, 0} ? -0.1 : 1.0;
  distance_mm_ += 0.5 * (left_mm + right_mm) * config_.distance_scale * wrong_mm;
  if (is_sci()) {
    angle_ += 0.5 * (right_mm - left_mm);
    return;
  }
  const double wrong_degrees = config_.firmware <= FirmwareVersion{3, 4, 0} ? 0.324056 : 1.0;
  angle_ += robot::deg_from_rad((right_mm - left_mm) * 1e-3 / config_.body.wheel_base_m) * wrong_degrees;
}

void EmulatedRoomba::run_timers() {
  song_left_s_ = std::max(0.0, song_left_s_ - kTick_s);
  pushed_ticks_ = std::max(0, pushed_ticks_ - 1);
  if (pushed_ticks_ == 0) {
    pushed_buttons_ = 0;
  }
  const bool may_sleep = mode_ == Mode::kPassive && !charger_present();
  quiet_ticks_ = may_sleep ? quiet_ticks_ + 1 : 0;
  if (quiet_ticks_ >= kSleepTicks) {
    fall_asleep();
  }
}

void EmulatedRoomba::queue(robot::ByteView bytes) {
  const std::size_t fits = std::min(bytes.size(), kLineBytes - line_held_);
  const std::size_t end = (line_begin_ + line_held_) % kLineBytes;
  const std::size_t to_the_end = std::min(fits, kLineBytes - end);
  std::copy_n(bytes.begin(), to_the_end, line_.begin() + static_cast<std::ptrdiff_t>(end));
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(to_the_end), fits - to_the_end, line_.begin());
  line_held_ += fits;
  bytes_overrun_ += bytes.size() - fits;
}

void EmulatedRoomba::answer(std::uint8_t id) {
  update_values();
  std::array<std::uint8_t, 80> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const auto written = is_sci() ? robot::sci::encode_sensors(id, values_, bytes)
                                : robot::oi::encode_packet(id, values_, bytes);
  if (!written) {
    return;
  }
  queue(robot::ByteView{bytes}.first(*written));
  clear_motion(id);
}

void EmulatedRoomba::queue_stream_frame() {
  if (!layout_) {
    return;
  }
  update_values();
  std::array<std::uint8_t, 258> frame;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  queue(robot::ByteView{frame}.first(layout_->encode(values_, frame)));
  if (stream_has_motion_) {
    for (const std::uint8_t id : stream_.ids()) {
      clear_motion(id);
    }
  }
}

}  // namespace sensotwin::twin
