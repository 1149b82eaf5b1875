// SPDX-License-Identifier: MIT
#include "render/image.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sensotwin::render {

Image::Image(int width_px, int height_px, Rgba fill)
    : width_px_(width_px),
      height_px_(height_px),
      pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), fill) {
  assert(width_px >= 0 && height_px >= 0);
}

bool Image::opaque() const {
  return std::all_of(pixels_.begin(), pixels_.end(), [](const Rgba& c) { return c.a == 255; });
}

std::optional<RenderError> size_fault(int width_px, int height_px) {
  const auto good = [](int side) { return side >= kSmallestSide_px && side <= kLargestSide_px; };
  if (good(width_px) && (height_px == 0 || good(height_px))) {
    return std::nullopt;
  }
  return RenderError{RenderError::Kind::kBadView,
                     fmt::format("cannot make a picture of {} x {} pixels: each side must be {} to {}",
                                 width_px, height_px, kSmallestSide_px, kLargestSide_px)};
}

}  // namespace sensotwin::render
