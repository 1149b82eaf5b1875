// SPDX-License-Identifier: MIT
#include "robot/drivers/roomba.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "robot/wire/oi_drive.hpp"

namespace sensotwin::robot {
namespace {

using oi::PacketId;

/// No Roomba 400 answers with other values; a shifted answer mostly does.
[[nodiscard]] bool plausible_sci(const oi::SensorValues& values) {
  constexpr std::int32_t kAllBumps = 31;
  bool flags = true;
  for (auto id = static_cast<std::uint8_t>(PacketId::kWall);
       id <= static_cast<std::uint8_t>(PacketId::kVirtualWall); ++id) {
    flags = flags && values[static_cast<PacketId>(id)] <= 1;
  }
  return flags && values[PacketId::kBumpsAndWheelDrops] <= kAllBumps &&
         values[PacketId::kOvercurrents] <= 31 && values[PacketId::kButtons] <= 15 &&
         values[PacketId::kChargingState] <= 5;
}

}  // namespace

Roomba::Roomba(ByteLink& link, const RoombaConfig& config)
    : link_(link),
      config_(config),
      layout_(*oi::StreamLayout::of(kStreamedPackets)),
      decoder_(static_cast<std::uint8_t>(layout_.payload_bytes())) {
  assert(config.mode == oi::Mode::kSafe || config.mode == oi::Mode::kFull);
  assert(config.repeat_frames > 0);
}

void Roomba::step(Instant now) {
  fresh_ = false;
  if (is_sci()) {
    read_polled(now);
  } else {
    read_stream(now);
  }
  watch(now);
  if (is_sci()) {
    poll(now);
  }
}

bool Roomba::drive(const WheelSpeeds& wheels) {
  if (status_ != RoombaStatus::kReady) {
    return false;
  }
  return was_sent(wheels) || send_wheels(wheels);
}

void Roomba::stop() {
  static_cast<void>(send_wheels({}));
}

void Roomba::rearm(oi::Mode mode) {
  config_.mode = mode;
  status_ = RoombaStatus::kStarting;
  said_start_.reset();
}

void Roomba::shut_down() {
  stop();
  static_cast<void>(send(oi::Start{}));
  if (!is_sci()) {
    static_cast<void>(send(oi::Stop{}));
  }
  status_ = RoombaStatus::kShutDown;
}

bool Roomba::send(const oi::Command& command) {
  std::array<std::uint8_t, oi::kMaxCommandBytes> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const std::size_t size = *oi::encode(command, bytes);
  const bool sent = link_.write(ByteView{bytes}.first(size));
  health_.writes_refused += sent ? 0u : 1u;
  return sent;
}

bool Roomba::was_sent(const WheelSpeeds& wheels) const {
  if (wheels == sent_) {
    return true;
  }
  return is_sci() ? oi::drive_for(wheels, config_.sci_wheel_base_m) ==
                        oi::drive_for(sent_, config_.sci_wheel_base_m)
                  : oi::drive_direct_for(wheels) == told_;
}

bool Roomba::send_wheels(const WheelSpeeds& wheels) {
  const bool sent =
      is_sci() ? send(oi::drive_for(wheels, config_.sci_wheel_base_m)) : send(oi::drive_direct_for(wheels));
  if (sent) {
    sent_ = wheels;
    told_ = oi::drive_direct_for(wheels);
    frames_since_sent_ = 0;
  }
  return sent;
}

// Start comes first because from safe or full it stops the wheels; each command acts before the next byte is
// parsed, so that all may leave at once.
void Roomba::say_start(Instant now) {
  bool sent = send(oi::Start{});
  if (is_sci()) {
    sent = sent && send(oi::Control{}) && (config_.mode == oi::Mode::kSafe || send(oi::Full{}));
    polled_.reset();
    answer_held_ = 0;
  } else {
    sent = sent && send(oi::Stream{kStreamedPackets}) &&
           (config_.mode == oi::Mode::kSafe ? send(oi::Safe{}) : send(oi::Full{}));
  }
  sent_ = {};
  told_ = {};
  if (sent) {
    said_start_ = now;
    ++health_.starts;
  }
}

void Roomba::read_stream(Instant now) {
  std::uint64_t frames = 0;
  for (;;) {
    const std::span<std::uint8_t> room = decoder_.room();
    const std::size_t arrived = link_.read(room);
    decoder_.received(arrived);
    while (const auto frame = decoder_.next()) {
      const bool good = *frame && take_payload(**frame, now);
      good ? ++frames : ++health_.frames_corrupt;
    }
    if (arrived < room.size()) {
      break;
    }
  }
  health_.bytes_skipped = decoder_.bytes_skipped();
  if (frames > 0) {
    count_missed(now, frames);
    assign_open_interface(state_, values_, config_.mode_report_offset);
    take_frame(now);
  }
}

bool Roomba::take_payload(ByteView payload, Instant now) {
  oi::SensorValues values = values_;
  // A frame as long as ours names what we asked for; of other lengths are those of an earlier request.
  const bool ours = payload.size() == layout_.payload_bytes();
  if (ours ? !layout_.decode(payload, values) : !oi::decode_payload(payload, values).has_value()) {
    return false;
  }
  if (ours && !can_have_turned(values, now)) {
    return false;
  }
  values_ = values;
  return true;
}

bool Roomba::can_have_turned(const oi::SensorValues& values, Instant now) {
  const EncoderCounts told{{static_cast<std::uint16_t>(values[oi::PacketId::kEncoderLeft])},
                           {static_cast<std::uint16_t>(values[oi::PacketId::kEncoderRight])}};
  const std::int64_t slots = last_good_ ? (now - *last_good_) / kTick + 1 : 0;
  const auto near = [&](const std::optional<EncoderCounts>& before) {
    const std::int64_t most = slots * kMostCountsInATick;
    return before && std::abs(told.left - before->left) <= most &&
           std::abs(told.right - before->right) <= most;
  };
  const bool believed = !last_good_ || near(state_.encoders) || near(doubted_);
  doubted_ = believed ? std::nullopt : std::optional{told};
  return believed;
}

void Roomba::read_polled(Instant now) {
  const std::size_t arrived = link_.read(std::span{answer_}.subspan(answer_held_));
  answer_held_ += arrived;
  if (!polled_) {  // nobody asked: debris of an older request
    health_.bytes_skipped += answer_held_;
    answer_held_ = 0;
  }
  if (answer_held_ < answer_.size()) {
    return;
  }
  answer_held_ = 0;
  polled_.reset();
  oi::SensorValues values;
  static_cast<void>(sci::decode_sensors(sci::kAllSensors, answer_, values));
  if (!plausible_sci(values)) {
    ++health_.frames_corrupt;
    health_.bytes_skipped += answer_.size();
    return;
  }
  count_missed(now, 1);
  assign_sci(state_, values);
  take_frame(now);
}

void Roomba::poll(Instant now) {
  if (!said_start_ || status_ == RoombaStatus::kShutDown) {
    return;
  }
  if (polled_ && now - *polled_ < config_.poll_timeout) {
    return;
  }
  health_.bytes_skipped += answer_held_;
  answer_held_ = 0;
  if (send(oi::Sensors{sci::kAllSensors})) {
    polled_ = now;
  }
}

void Roomba::count_missed(Instant now, std::uint64_t frames) {
  health_.frames_good += frames;
  health_.frames_superseded += frames - 1;
  if (last_good_) {
    const auto slots = static_cast<std::uint64_t>((now - *last_good_ + kTick / 2) / kTick);
    health_.frames_missed += slots > frames ? slots - frames : 0;
  }
}

void Roomba::take_frame(Instant now) {
  last_good_ = now;
  state_.stamp = now;
  state_.frame_number = health_.frames_good;
  fresh_ = true;
  ++frames_since_sent_;
}

bool Roomba::in_wanted_mode() const {
  if (state_.mode) {
    return *state_.mode == config_.mode;
  }
  if (config_.mode == oi::Mode::kFull) {
    return true;
  }
  const bool wheel_drop = state_.wheel_drop_left || state_.wheel_drop_right || state_.wheel_drop_caster;
  const bool over_cliff =
      std::ranges::find(state_.cliff, true) != state_.cliff.end() && sent_ != WheelSpeeds{};
  return !wheel_drop && !over_cliff && state_.charging == oi::ChargingState::kNotCharging;
}

void Roomba::halt(RoombaStatus because) {
  stop();
  status_ = because;
}

void Roomba::watch(Instant now) {
  switch (status_) {
    case RoombaStatus::kShutDown:
      return;
    case RoombaStatus::kStarting:
      if (said_start_ && fresh_ && in_wanted_mode()) {
        status_ = RoombaStatus::kReady;
      } else if (!said_start_ || now - *said_start_ >= config_.start_timeout) {
        say_start(now);
      }
      return;
    case RoombaStatus::kReady:
      if (fresh_ && !in_wanted_mode()) {
        halt(RoombaStatus::kModeLost);
      } else if (now - *last_good_ >= config_.stream_timeout) {
        halt(RoombaStatus::kStreamLost);
        last_stop_ = now;
      } else if (fresh_ && frames_since_sent_ >= config_.repeat_frames) {
        static_cast<void>(send_wheels(sent_));
      }
      return;
    case RoombaStatus::kModeLost:
      return;
    case RoombaStatus::kStreamLost:
      if (fresh_) {
        status_ = in_wanted_mode() ? RoombaStatus::kReady : RoombaStatus::kModeLost;
      } else if (now - last_stop_ >= config_.stream_timeout) {
        stop();
        last_stop_ = now;
      }
      return;
  }
}

}  // namespace sensotwin::robot
