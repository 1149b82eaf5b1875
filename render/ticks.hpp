// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sensotwin::render {

struct Tick {
  double value{0.0};
  std::string label;
};

/// Round numbers (1, 2, 2.5 or 5 times a power of ten) inside [low, high], about `wanted` of them, at least
/// two when the range is not empty. \pre finite, low <= high
[[nodiscard]] std::vector<Tick> linear_ticks(double low, double high, int wanted);
/// Powers of ten inside [low, high]; with 2 and 5 times them where fewer than three powers fall inside. \pre
/// 0 < low
[[nodiscard]] std::vector<Tick> log_ticks(double low, double high);
/// The largest of 1, 2 or 5 times a power of ten that is at most `limit`: the length of a scale bar. \pre
/// limit > 0
[[nodiscard]] double round_length_below(double limit);
/// "0.5", "20", "1500": as few digits as tell it apart. At most six significant ones.
[[nodiscard]] std::string plain_number(double value);

}  // namespace sensotwin::render
