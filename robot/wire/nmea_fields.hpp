// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

/// What the sentences of nmea.hpp and nmea_distances.hpp are made of.
namespace sensotwin::robot {

/// The "x.x" of NMEA 0183: digits, at most one point, at least one digit.
[[nodiscard]] inline std::optional<double> nmea_number(std::string_view text) {
  const auto digits = std::count_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const auto points = std::count(text.begin(), text.end(), '.');
  if (digits == 0 || points > 1 || static_cast<std::size_t>(digits + points) != text.size()) {
    return std::nullopt;
  }
  double value = 0.0;
  const auto parsed =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  return parsed.ec == std::errc{} ? std::optional{value} : std::nullopt;
}

/// Fields of one sentence, address included. As many as fit into 82 characters with a comma before each are
/// kept.
struct NmeaFields {
  std::array<std::string_view, 80> at{};
  std::size_t count{0};
};

[[nodiscard]] inline NmeaFields nmea_fields(std::string_view body) {
  NmeaFields fields;
  for (;;) {
    const std::size_t comma = body.find(',');
    if (fields.count < fields.at.size()) {
      fields.at[fields.count++] = body.substr(0, comma);
    }
    if (comma == std::string_view::npos) {
      return fields;
    }
    body.remove_prefix(comma + 1);
  }
}

}  // namespace sensotwin::robot
