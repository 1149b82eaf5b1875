// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/color.hpp"
#include "render/error.hpp"

namespace sensotwin::render {

/// Pixels in reading order, top row first; x to the right, y down.
class Image {
 public:
  Image() = default;
  /// \pre width_px >= 0 && height_px >= 0
  Image(int width_px, int height_px, Rgba fill = palette::kPaper);

  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_px_ && y < height_px_;
  }
  /// \pre contains(x, y)
  [[nodiscard]] const Rgba& at(int x, int y) const {
    assert(contains(x, y));
    return pixels_[index(x, y)];
  }
  [[nodiscard]] Rgba& at(int x, int y) {
    assert(contains(x, y));
    return pixels_[index(x, y)];
  }
  [[nodiscard]] const std::vector<Rgba>& pixels() const { return pixels_; }
  /// Whether no pixel lets anything through.
  [[nodiscard]] bool opaque() const;
  friend bool operator==(const Image&, const Image&) = default;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px_) + static_cast<std::size_t>(x);
  }
  int width_px_{0};
  int height_px_{0};
  std::vector<Rgba> pixels_;
};

/// Largest side of a picture. Chosen: four times a README picture each way, and below every driver's limit.
inline constexpr int kLargestSide_px = 8000;
/// Smallest width or given height. Chosen: below it no letter could be read.
inline constexpr int kSmallestSide_px = 160;

/// Why no picture of that size is drawn; nothing when all is well. Height 0 stands for "as high as needed".
[[nodiscard]] std::optional<RenderError> size_fault(int width_px, int height_px);

}  // namespace sensotwin::render
