// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/journal/journal_writer.hpp"

namespace sensotwin::robot {

/// A ByteLink that writes down what goes through it. `inner` and `journal` must outlive it.
class RecordingByteLink : public ByteLink {
 public:
  RecordingByteLink(ByteLink& inner, JournalWriter& journal, Wire wire)
      : inner_(inner), journal_(journal), wire_(wire) {}

 private:
  bool do_write(ByteView bytes) override;
  std::size_t do_read(std::span<std::uint8_t> into) override;
  [[nodiscard]] bool do_is_up() const override;

  ByteLink& inner_;
  JournalWriter& journal_;
  Wire wire_;
  mutable std::optional<bool> was_up_;
};

/// The same for a CardLink.
class RecordingCardLink : public CardLink {
 public:
  RecordingCardLink(CardLink& inner, JournalWriter& journal, Wire wire)
      : inner_(inner), journal_(journal), wire_(wire) {}

 private:
  CardPresence do_presence() override;
  bool do_begin(ByteView command_apdu) override;
  std::optional<Result<Bytes, CardError>> do_poll() override;

  CardLink& inner_;
  JournalWriter& journal_;
  Wire wire_;
  std::optional<CardPresence> was_;
};

}  // namespace sensotwin::robot
