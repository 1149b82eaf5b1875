// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "robot/base/random.hpp"
#include "robot/wire/oi_commands.hpp"
#include "tests/robot/drivers/roomba_transcripts.hpp"
#include "tests/robot/ports/pseudo_terminal.hpp"

namespace sensotwin::robot::testing {

/// What a cable does to bytes, both ways.
struct CableFaults {
  double loss{0.0};
  double corruption{0.0};
};

/// A Create 2 behind a pseudo-terminal, with the parser of the real one: it waits for missing bytes for ever,
/// and drives on at its last speed when nobody says anything. Its wheels turn in the air.
class TerminalRoomba {
 public:
  explicit TerminalRoomba(const std::filesystem::path& link) : terminal(link) {}

  /// One sensor update: obeys what has come, then says a frame. Call it every 15 ms.
  void tick() {
    listen();
    counts_left_ += static_cast<int>(std::lround(left_mm_s_ * 0.015 / 0.444565));
    counts_right_ += static_cast<int>(std::lround(right_mm_s_ * 0.015 / 0.444565));
    if (streaming_ && !mute) {
      terminal.say(
          spoilt(transcripts::bytes_of({.mode = mode_,
                                        .bumps_and_wheel_drops = 0,
                                        .counts_left = static_cast<std::uint16_t>(counts_left_),
                                        .counts_right = static_cast<std::uint16_t>(counts_right_)})));
    }
  }
  /// Only obeys.
  void listen() {
    for (const std::uint8_t byte : spoilt(terminal.heard())) {
      const auto command = decoder_.push(byte);
      if (command && *command) {
        obey(**command);
      }
    }
  }
  [[nodiscard]] bool moves() const { return left_mm_s_ != 0 || right_mm_s_ != 0; }
  [[nodiscard]] bool streams() const { return streaming_; }
  [[nodiscard]] int mode() const { return mode_; }
  /// As after a power cycle.
  void reset() {
    mode_ = 0;
    streaming_ = false;
    left_mm_s_ = right_mm_s_ = 0;
    decoder_.reset();
  }

  PseudoTerminal terminal;
  CableFaults faults;
  bool mute{false};  ///< obeys, but says nothing

 private:
  void obey(const oi::Command& command) {
    if (std::holds_alternative<oi::Start>(command)) {
      mode_ = 1;
      left_mm_s_ = right_mm_s_ = 0;
    } else if (std::holds_alternative<oi::Safe>(command) && mode_ > 0) {
      mode_ = 2;
    } else if (std::holds_alternative<oi::Stop>(command)) {
      reset();
    } else if (std::holds_alternative<oi::Stream>(command) && mode_ > 0) {
      streaming_ = true;
    } else if (const auto* drive = std::get_if<oi::DriveDirect>(&command); drive != nullptr && mode_ > 1) {
      left_mm_s_ = drive->left_mm_s;
      right_mm_s_ = drive->right_mm_s;
    } else if (const auto* arc = std::get_if<oi::Drive>(&command); arc != nullptr && mode_ > 1) {
      left_mm_s_ = right_mm_s_ = arc->velocity_mm_s;
    }
  }
  [[nodiscard]] Bytes spoilt(const Bytes& bytes) {
    Bytes arrived;
    for (std::uint8_t byte : bytes) {
      if (random_.chance(faults.loss)) {
        continue;
      }
      if (random_.chance(faults.corruption)) {
        byte = static_cast<std::uint8_t>(byte ^ (1u << random_.below(8)));
      }
      arrived.push_back(byte);
    }
    return arrived;
  }

  oi::CommandDecoder decoder_;
  RandomStream random_{4};
  std::uint8_t mode_{0};
  bool streaming_{false};
  int left_mm_s_{0};
  int right_mm_s_{0};
  int counts_left_{0};
  int counts_right_{0};
};

}  // namespace sensotwin::robot::testing
