// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace sensotwin::twin {

/// Fingerprint of everything a run went through: equal runs have equal hashes, and one flipped bit anywhere
/// changes it. Fed with the raw bits of the state, tick by tick.
///
///   h <- (h xor w) * p,  h <- h xor (h >> 32)      for each 64-bit word w
///
/// FNV-1a taken by words instead of bytes (basis and prime from the FNV reference, 64 bits), with the shift
/// that brings high bits down again, which the byte-wise form does not need. Each step is a bijection of h
/// and of w, so a single changed word cannot be lost. Eight times as fast as bytes; not for security.
class StateHash {
 public:
  template <std::integral T>
  constexpr void add(T value) {
    mix(static_cast<std::uint64_t>(value));
  }
  /// By its bits: 0.0 and -0.0 differ.
  constexpr void add(double value) { mix(std::bit_cast<std::uint64_t>(value)); }
  constexpr void add(float value) { mix(std::bit_cast<std::uint32_t>(value)); }

  [[nodiscard]] constexpr std::uint64_t value() const { return hash_; }
  /// Sixteen hexadecimal digits, as in summary.json.
  [[nodiscard]] std::string text() const {
    constexpr std::array<char, 17> kDigits{"0123456789abcdef"};
    std::string digits(16, '0');
    for (std::size_t i = 0; i < 16; ++i) {
      digits[i] = kDigits[(hash_ >> (60 - 4 * i)) & 0xFu];
    }
    return digits;
  }

 private:
  constexpr void mix(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x100000001b3u;
    hash_ ^= hash_ >> 32;
  }

  std::uint64_t hash_{0xcbf29ce484222325u};
};

}  // namespace sensotwin::twin
