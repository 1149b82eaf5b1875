// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sensotwin::robot {

/// Fixed-point text of `value` with Decimals digits after the point, written at `to`. \returns the end.
/// Rounds to nearest, ties to even; never "-0.00". Some 10 ns, where std::to_chars in fixed form needs 100.
/// Not finite, or beyond 9e15 units of the last digit: writes nothing, so a column stays empty rather than
/// lie. Needs at most 20 characters.
template <int Decimals>
[[nodiscard]] inline char* put_fixed(char* to, double value) {
  constexpr auto kScale = [] {
    std::int64_t scale = 1;
    for (int i = 0; i < Decimals; ++i) {
      scale *= 10;
    }
    return scale;
  }();
  const double scaled = value * static_cast<double>(kScale);
  if (!(std::abs(scaled) < 9e15)) {
    return to;
  }
  // nearbyint in the default rounding mode; beyond 2^53 a double could not hold the last digit anyway.
  const auto units = static_cast<std::int64_t>(std::nearbyint(scaled));
  const std::int64_t magnitude = units < 0 ? -units : units;
  if (units < 0) {
    *to++ = '-';
  }
  to = std::to_chars(to, to + 20, magnitude / kScale).ptr;
  if constexpr (Decimals > 0) {
    *to++ = '.';
    std::int64_t rest = magnitude % kScale;
    for (int i = Decimals - 1; i >= 0; --i) {
      to[i] = static_cast<char>('0' + rest % 10);
      rest /= 10;
    }
    to += Decimals;
  }
  return to;
}

/// `value` as 16 upper-case hexadecimal digits, as tag UIDs are printed on their packing. Needs 16
/// characters.
[[nodiscard]] inline char* put_uid(char* to, std::uint64_t value) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (int shift = 60; shift >= 0; shift -= 4) {
    *to++ = kDigits[(value >> shift) & 0xFu];
  }
  return to;
}
[[nodiscard]] inline std::string uid_text(std::uint64_t value) {
  std::string text(16, '0');
  (void)put_uid(text.data(), value);
  return text;
}

/// `text` between quotation marks as JSON wants it: escapes, and each byte that is not UTF-8 becomes U+FFFD,
/// so that a line is valid JSON whatever a device put into it.
void append_json_string(std::string& to, std::string_view text);

/// `text` as XML wants it between tags and in attributes between double quotation marks: the five entities,
/// line feeds kept; each byte that is not UTF-8 and each character that XML 1.0 (section 2.2) forbids becomes
/// U+FFFD.
void append_xml_text(std::string& to, std::string_view text);

}  // namespace sensotwin::robot
