// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/bytes.hpp"

namespace sensotwin::robot::llrp {

/// Bits, the first one at the top of the first byte; the last byte is padded at its low end (LLRP 1.0.1,
/// 16.2.7.3.1).
struct BitArray {
  std::uint16_t count{0};
  Bytes bytes{};  ///< (count + 7) / 8 of them

  [[nodiscard]] bool bit(std::size_t i) const { return ((bytes[i / 8] >> (7 - i % 8)) & 1) != 0; }
  bool operator==(const BitArray&) const = default;
};

}  // namespace sensotwin::robot::llrp
