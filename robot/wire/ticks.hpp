// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sensotwin::robot {

/// Raw wheel-encoder counter as it travels on the wire: 16 bits, wraps (Create 2 Open Interface, packets 43,
/// 44).
struct Ticks {
  std::uint16_t raw{0};
  bool operator==(const Ticks&) const = default;
};

/// Signed ticks from `before` to `now`, right across the wrap while fewer than 32 768 lie between (14.5 m).
[[nodiscard]] constexpr std::int16_t operator-(Ticks now, Ticks before) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(now.raw - before.raw));
}
/// The counter `ticks` later, or earlier when negative; wraps.
[[nodiscard]] constexpr Ticks operator+(Ticks before, std::int64_t ticks) {
  return {static_cast<std::uint16_t>(before.raw + static_cast<std::uint64_t>(ticks))};
}

static_assert(Ticks{2} - Ticks{65534} == 4);
static_assert(Ticks{65534} - Ticks{2} == -4);
static_assert(Ticks{65534} + 4 == Ticks{2});
static_assert(Ticks{2} + -4 == Ticks{65534});

}  // namespace sensotwin::robot
