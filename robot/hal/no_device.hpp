// SPDX-License-Identifier: MIT
#pragma once

#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"

/// Where nothing is plugged in.
namespace sensotwin::robot {

/// Up, silent, deaf.
class NoByteLink : public ByteLink {
  bool do_write(ByteView) override { return true; }
  std::size_t do_read(std::span<std::uint8_t>) override { return 0; }
};

/// No reader.
class NoCardLink : public CardLink {
  CardPresence do_presence() override { return CardPresence::kNoReader; }
  bool do_begin(ByteView) override { return false; }
  std::optional<Result<Bytes, CardError>> do_poll() override { return std::nullopt; }
};

}  // namespace sensotwin::robot
