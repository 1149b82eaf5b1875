// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace sensotwin::robot {

/// 96-bit Electronic Product Code of a UHF tag, most significant byte first (EPC Tag Data Standard; the
/// length that EPCData parameters of LLRP carry in 12 bytes).
struct Epc {
  std::array<std::uint8_t, 12> bytes{};
  auto operator<=>(const Epc&) const = default;
};

}  // namespace sensotwin::robot
