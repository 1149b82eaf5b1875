// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "robot/base/bytes.hpp"

namespace sensotwin::robot {

/// Unsigned LEB128: seven bits a byte, low ones first, the top bit says that more follow.
inline void append_number(Bytes& to, std::uint64_t value) {
  while (value >= 0x80) {
    to.push_back(static_cast<std::uint8_t>(value | 0x80));
    value >>= 7;
  }
  to.push_back(static_cast<std::uint8_t>(value));
}

/// Takes such a number off the front of `bytes`; nothing when there is no whole one of 64 bits.
[[nodiscard]] inline std::optional<std::uint64_t> take_number(ByteView& bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size() && i < 10; ++i) {
    const std::uint64_t part = bytes[i] & 0x7Fu;
    if (i == 9 && part > 1) {
      return std::nullopt;
    }
    value |= part << (7 * i);
    if ((bytes[i] & 0x80u) == 0) {
      bytes = bytes.subspan(i + 1);
      return value;
    }
  }
  return std::nullopt;
}

/// FNV-1a, 32 bits.
[[nodiscard]] inline std::uint32_t check_of(ByteView bytes) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const std::uint8_t byte : bytes) {
    hash = (hash ^ byte) * 0x01000193u;
  }
  return hash;
}

}  // namespace sensotwin::robot
