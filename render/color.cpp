// SPDX-License-Identifier: MIT
#include "render/color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sensotwin::render {
namespace {

[[nodiscard]] std::uint8_t byte_from(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

[[nodiscard]] Rgba along(std::span<const Rgba> anchors, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
  return mix(anchors[i], anchors[i + 1], at - static_cast<double>(i));
}

}  // namespace

Rgba mix(Rgba a, Rgba b, double share) {
  const auto blend = [share](std::uint8_t from, std::uint8_t to) {
    return byte_from(from + (to - from) * share);
  };
  return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b), blend(a.a, b.a)};
}

Rgba shaded(Rgba c, double light) {
  return {byte_from(c.r * light), byte_from(c.g * light), byte_from(c.b * light), c.a};
}

double luminance(Rgba c) {
  const auto linear = [](std::uint8_t v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

Rgba time_color(double share) {
  static constexpr std::array kAnchors{rgb(0x4575B4), rgb(0x74ADD1), rgb(0xABD9E9), rgb(0xFEE090),
                                       rgb(0xFDAE61), rgb(0xF46D43), rgb(0xD73027)};
  return along(kAnchors, share);
}

Rgba quantity_color(double share) {
  static constexpr std::array kAnchors{rgb(0xFFFFD9), rgb(0xEDF8B1), rgb(0xC7E9B4), rgb(0x7FCDBB),
                                       rgb(0x41B6C4), rgb(0x1D91C0), rgb(0x225EA8), rgb(0x253494)};
  return along(kAnchors, share);
}

Rgba tile_color(TileState state) {
  switch (state) {
    case TileState::kUnvisited:
      return palette::kTileUnvisited;
    case TileState::kGrey:
      return palette::kTileGrey;
    case TileState::kBlack:
      return palette::kTileBlack;
    case TileState::kBlocked:
      return palette::kTileBlocked;
    case TileState::kUnreachable:
      return palette::kTileUnreachable;
    case TileState::kMissed:
      return palette::kTileMissed;
    case TileState::kWrong:
      return palette::kTileWrong;
  }
  return palette::kTileUnvisited;
}

}  // namespace sensotwin::render
