// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace sensotwin::robot {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// Big-endian 16 bits, as the Open Interface, LLRP and the C1G2 air protocol write them.
[[nodiscard]] constexpr std::uint16_t u16_from_be(std::uint8_t high, std::uint8_t low) {
  return static_cast<std::uint16_t>((high << 8) | low);
}
[[nodiscard]] constexpr std::int16_t s16_from_be(std::uint8_t high, std::uint8_t low) {
  return static_cast<std::int16_t>(u16_from_be(high, low));
}
[[nodiscard]] constexpr std::uint8_t high_byte(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}
[[nodiscard]] constexpr std::uint8_t low_byte(std::uint16_t value) {
  return static_cast<std::uint8_t>(value & 0xFFu);
}

}  // namespace sensotwin::robot
