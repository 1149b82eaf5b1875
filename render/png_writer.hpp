// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/error.hpp"
#include "render/image.hpp"

namespace sensotwin::render {

/// tEXt chunks of a PNG (ISO/IEC 15948, 11.3.4.3). The standard says Latin-1; other characters become '?'.
struct PngText {
  std::string software{"SensoTwin"};
  std::string comment;  ///< see provenance(); left out when empty
};

/// "scene house, seed 7, renderer llvmpipe (...)": what must be known to draw the same picture again.
[[nodiscard]] std::string provenance(std::string_view scene, std::uint64_t seed, std::string_view renderer);

/// The image as a PNG file: 8 bits a channel, alpha only where the image has some, no time stamp, so that
/// equal images and texts give equal bytes. The caller writes the file. \returns kBadView for an empty image,
/// kEncoding when libpng refuses.
[[nodiscard]] Rendered<std::vector<std::uint8_t>> encode_png(const Image& image, const PngText& text);

}  // namespace sensotwin::render
