// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "render/views.hpp"

namespace sensotwin::render {

/// 8-bit sRGB with straight (not premultiplied) alpha.
struct Rgba {
  std::uint8_t r{0};
  std::uint8_t g{0};
  std::uint8_t b{0};
  std::uint8_t a{255};

  [[nodiscard]] constexpr Rgba with_alpha(std::uint8_t alpha) const { return {r, g, b, alpha}; }
  friend constexpr bool operator==(const Rgba&, const Rgba&) = default;
};

/// 0xRRGGBB, opaque.
[[nodiscard]] constexpr Rgba rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>((hex >> 8) & 0xFFu),
          static_cast<std::uint8_t>(hex & 0xFFu), 255};
}
/// `share` 0 gives a, 1 gives b.
[[nodiscard]] Rgba mix(Rgba a, Rgba b, double share);
/// Light times colour, clamped; alpha kept.
[[nodiscard]] Rgba shaded(Rgba c, double light);
/// Relative luminance of WCAG 2.1 in [0, 1]: decides between dark and light letters.
[[nodiscard]] double luminance(Rgba c);

/// Time along a path, 0 to 1: blue, pale yellow, red-orange. The anchors are ColorBrewer's RdYlBu reversed,
/// which its authors mark as safe for the colour-blind (C. Brewer, colorbrewer2.org).
[[nodiscard]] Rgba time_color(double share);
/// Quantity, 0 to 1: light to dark blue-green (ColorBrewer YlGnBu, safe for the colour-blind, prints in
/// grey).
[[nodiscard]] Rgba quantity_color(double share);

/// The one place where pictures take their colours from. Accents are Okabe and Ito's colour-blind safe set
/// (jfly.uni-koeln.de/color, 2008); greys are chosen for contrast with them.
namespace palette {
inline constexpr Rgba kPaper = rgb(0xFFFFFF);
inline constexpr Rgba kInk = rgb(0x1F2933);
inline constexpr Rgba kSoftInk = rgb(0x616E7C);
inline constexpr Rgba kHairline = rgb(0xCBD2D9);
inline constexpr Rgba kGrid = rgb(0xE9EDF1);
inline constexpr Rgba kFloor = rgb(0xF1EEE7);
inline constexpr Rgba kWall = rgb(0x2B323B);
inline constexpr Rgba kMasonry = rgb(0xB3BAC2);
inline constexpr Rgba kFurniture = rgb(0xD9B88A);
inline constexpr Rgba kFurnitureEdge = rgb(0x7A5A2E);
inline constexpr Rgba kTileUnvisited = rgb(0xFFFFFF);
inline constexpr Rgba kTileGrey = rgb(0xBCC4CD);
inline constexpr Rgba kTileBlack = rgb(0x56616E);
inline constexpr Rgba kTileBlocked = rgb(0xE8CFC0);
inline constexpr Rgba kTileUnreachable = rgb(0xE6E3F1);
inline constexpr Rgba kTileMissed = rgb(0xFBE3D6);
inline constexpr Rgba kTileWrong = rgb(0xF2D3E4);
inline constexpr Rgba kVermilion = rgb(0xD55E00);
inline constexpr Rgba kPurple = rgb(0xAA4499);
inline constexpr Rgba kOrange = rgb(0xE69F00);
inline constexpr Rgba kSky = rgb(0x56B4E9);
inline constexpr Rgba kBlue = rgb(0x0072B2);
inline constexpr Rgba kGreen = rgb(0x009E73);
inline constexpr Rgba kPink = rgb(0xCC79A7);
inline constexpr Rgba kBrown = rgb(0x8C5A2B);
inline constexpr Rgba kRobot = rgb(0x20262E);
inline constexpr Rgba kCeilingTag = rgb(0x7B3FA0);
}  // namespace palette

[[nodiscard]] Rgba tile_color(TileState state);

}  // namespace sensotwin::render
