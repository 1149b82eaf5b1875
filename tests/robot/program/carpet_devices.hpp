// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "robot/base/bytes.hpp"
#include "robot/base/tag_uid.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "tests/robot/mapping/kinematic_carpet.hpp"

/// The far ends of the four cables: just enough of each device to try the program on a drawn room. What the
/// devices do in full is emulated in twin/devices; the words are those of the drivers' transcripts.
namespace sensotwin::robot::testing {

/// Two queues of bytes.
class FakeSerial : public ByteLink {
 public:
  void say(const Bytes& bytes) { to_robot_.insert(to_robot_.end(), bytes.begin(), bytes.end()); }
  /// What was heard since the last call.
  [[nodiscard]] Bytes heard();

 private:
  bool do_write(ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;

  Bytes to_robot_;
  Bytes from_robot_;
};

/// A Create 2 that understands Start, Safe, Full, Stream and Drive Direct.
class FakeBase {
 public:
  FakeSerial serial;
  /// No frames while set; it obeys all the same.
  bool mute{false};
  /// Every n-th frame has a byte spoilt.
  int spoil_every{0};
  /// Its charging contacts are touched: it refuses safe mode (Create 2 Open Interface, "Safe Mode").
  bool docked{false};
  /// Its left wheel hangs: it leaves safe mode.
  bool lifted{false};

  /// Obeys what was said. \returns the wheels' speeds
  [[nodiscard]] WheelSpeeds obey();
  /// Says one frame.
  void tell(const Sensed& sensed);

  [[nodiscard]] std::uint8_t mode() const { return mode_; }
  [[nodiscard]] const WheelSpeeds& wheels() const { return wheels_; }
  [[nodiscard]] int times_said(std::uint8_t opcode) const;

 private:
  std::size_t obey(ByteView command);

  std::uint8_t mode_{0};
  bool streaming_{false};
  WheelSpeeds wheels_;
  std::map<std::uint8_t, int> said_;
  int frames_{0};
  std::uint16_t left_{0};
  std::uint16_t right_{0};
};

/// A PC/SC reader of storage cards: Get Data, Read Binary, Update Binary. Answers at the next poll.
class FakeReader : public CardLink {
 public:
  bool plugged{true};
  std::optional<TagUid> in_field;
  /// 28 blocks of 4 bytes each (ICODE SLI), zero when new.
  std::map<TagUid, Bytes> memories;

  [[nodiscard]] Bytes& memory(TagUid uid) { return memories.try_emplace(uid, Bytes(28 * 4)).first->second; }

 private:
  CardPresence do_presence() override;
  bool do_begin(ByteView command_apdu) override;
  std::optional<Result<Bytes, CardError>> do_poll() override;

  std::optional<Bytes> answer_;
  std::optional<TagUid> asked_;
};

/// A compass board's sentence for this yaw. \param yaw_from_north_rad  counter-clockwise
[[nodiscard]] Bytes compass_sentence(double yaw_from_north_rad);

}  // namespace sensotwin::robot::testing
