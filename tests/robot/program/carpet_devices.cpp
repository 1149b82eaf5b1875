// SPDX-License-Identifier: MIT
#include "carpet_devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "tests/robot/drivers/roomba_transcripts.hpp"

namespace sensotwin::robot::testing {
namespace {

constexpr std::uint8_t kStart = 128;
constexpr std::uint8_t kSafe = 131;
constexpr std::uint8_t kFull = 132;
constexpr std::uint8_t kDriveDirect = 145;
constexpr std::uint8_t kStream = 148;
constexpr std::uint8_t kStop = 173;
/// Where the value of packet 34, charging sources available, stands in a frame of the transcripts: behind two
/// bytes of header, 53 of packets with their ids, and its own id.
constexpr std::size_t kChargingSources = 56;
constexpr std::uint8_t kHomeBase = 2;

}  // namespace

Bytes FakeSerial::heard() {
  return std::exchange(from_robot_, {});
}

bool FakeSerial::do_write(ByteView bytes) {
  from_robot_.insert(from_robot_.end(), bytes.begin(), bytes.end());
  return true;
}

std::size_t FakeSerial::do_read(std::span<std::uint8_t> into) {
  const std::size_t count = std::min(into.size(), to_robot_.size());
  std::copy_n(to_robot_.begin(), count, into.begin());
  to_robot_.erase(to_robot_.begin(), to_robot_.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

WheelSpeeds FakeBase::obey() {
  const Bytes heard = serial.heard();
  ByteView rest = heard;
  while (!rest.empty()) {
    ++said_[rest.front()];
    rest = rest.subspan(std::min(obey(rest), rest.size()));
  }
  const bool refuses_safe = mode_ == 2 && (docked || lifted);
  if (refuses_safe) {
    mode_ = 1;
    wheels_ = {};
  }
  return wheels_;
}

/// \returns how many bytes the command has
std::size_t FakeBase::obey(ByteView command) {
  const auto speed_mps = [&](std::size_t i) { return s16_from_be(command[i], command[i + 1]) / 1000.0; };
  switch (command.front()) {
    case kStart:
      mode_ = 1;
      wheels_ = {};
      return 1;
    case kSafe:
      mode_ = 2;
      return 1;
    case kFull:
      mode_ = 3;
      return 1;
    case kDriveDirect:
      if (mode_ >= 2) {
        wheels_ = {.left_mps = speed_mps(3), .right_mps = speed_mps(1)};
      }
      return 5;
    case kStream:
      streaming_ = true;
      return 2u + command[1];
    case kStop:
      mode_ = 0;
      streaming_ = false;
      return 1;
    default:
      ADD_FAILURE() << "a command that this base does not know: " << int{command.front()};
      return 1;
  }
}

void FakeBase::tell(const Sensed& sensed) {
  left_ = static_cast<std::uint16_t>(left_ + sensed.counts_left);
  right_ = static_cast<std::uint16_t>(right_ + sensed.counts_right);
  if (!streaming_ || mute) {
    return;
  }
  const int bumps = (sensed.bump_right ? 1 : 0) | (sensed.bump_left ? 2 : 0) | (lifted ? 8 : 0);
  Bytes frame = transcripts::bytes_of({.mode = mode_,
                                       .bumps_and_wheel_drops = static_cast<std::uint8_t>(bumps),
                                       .counts_left = left_,
                                       .counts_right = right_});
  if (docked) {
    frame[kChargingSources] = kHomeBase;
    frame.back() = static_cast<std::uint8_t>(frame.back() - kHomeBase);
  }
  if (spoil_every > 0 && ++frames_ % spoil_every == 0) {
    frame[frame.size() / 2] ^= 0x40;
  }
  serial.say(frame);
}

int FakeBase::times_said(std::uint8_t opcode) const {
  const auto found = said_.find(opcode);
  return found == said_.end() ? 0 : found->second;
}

CardPresence FakeReader::do_presence() {
  if (!plugged) {
    return CardPresence::kNoReader;
  }
  return in_field ? CardPresence::kPresent : CardPresence::kEmpty;
}

bool FakeReader::do_begin(ByteView command_apdu) {
  if (!plugged || !in_field || answer_) {
    return false;
  }
  asked_ = in_field;
  Bytes answer;
  const std::size_t address = command_apdu[3] * 4u;
  if (command_apdu[1] == 0xCA) {
    for (int shift = 56; shift >= 0; shift -= 8) {
      answer.push_back(static_cast<std::uint8_t>(*in_field >> shift));
    }
  } else if (command_apdu[1] == 0xB0) {
    const auto from = memory(*in_field).begin() + static_cast<std::ptrdiff_t>(address);
    answer.assign(from, from + command_apdu[4]);
  } else if (command_apdu[1] == 0xD6) {
    std::copy(command_apdu.begin() + 5, command_apdu.end(),
              memory(*in_field).begin() + static_cast<std::ptrdiff_t>(address));
  }
  answer.insert(answer.end(), {0x90, 0x00});
  answer_ = answer;
  return true;
}

std::optional<Result<Bytes, CardError>> FakeReader::do_poll() {
  if (!answer_) {
    return std::nullopt;
  }
  const Bytes answer = *std::exchange(answer_, std::nullopt);
  if (!plugged) {
    return Result<Bytes, CardError>{Unexpected{CardError::kReaderGone}};
  }
  if (in_field != asked_) {
    return Result<Bytes, CardError>{Unexpected{CardError::kRemoved}};
  }
  return Result<Bytes, CardError>{answer};
}

Bytes compass_sentence(double yaw_from_north_rad) {
  const double clockwise_deg = std::fmod(720.0 - deg_from_rad(yaw_from_north_rad), 360.0);
  std::array<char, 32> body{};
  std::snprintf(body.data(), body.size(), "HCHDM,%.1f,M", clockwise_deg);
  unsigned sum = 0;
  for (const char* c = body.data(); *c != '\0'; ++c) {
    sum ^= static_cast<unsigned char>(*c);
  }
  std::array<char, 40> sentence{};
  std::snprintf(sentence.data(), sentence.size(), "$%s*%02X\r\n", body.data(), sum);
  const std::string text = sentence.data();
  return {text.begin(), text.end()};
}

}  // namespace sensotwin::robot::testing
