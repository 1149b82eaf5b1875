// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/base/result.hpp"

namespace sensotwin::twin {

/// A grey picture, row by row from the TOP.
struct GreyPicture {
  /// Sum of red, green and blue, each 0..255: thirds of a grey level, so that the mean of three is exact.
  static constexpr std::uint16_t kWhite = 765;
  /// More than half transparent.
  static constexpr std::uint16_t kClear = 0xFFFF;

  int columns{0};
  int rows{0};
  std::vector<std::uint16_t> pixels;
};

/// Chosen: a map of 800 m at 0.05 m a cell. A picture of that size takes 1.5 GiB while it is read.
inline constexpr int kPictureSideMax = 16384;

/// Decodes a PGM (P2, P5; comments; any maxval) or PNG (1 to 16 bits; grey, palette, RGB; alpha; interlaced).
/// 16-bit values are rounded to 8.
/// \param file_bytes  the whole file
/// \returns the picture, or what is wrong with the file in a phrase: "is empty", "is cut off: ..."
[[nodiscard]] robot::Result<GreyPicture, std::string> decode_picture(const std::string& file_bytes);

}  // namespace sensotwin::twin
