// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/error.hpp"
#include "render/image.hpp"

namespace sensotwin::render {

/// x right, y down, pixels.
struct RectPx {
  double x{0.0};
  double y{0.0};
  double width{0.0};
  double height{0.0};
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] Vec2 center() const { return {x + width / 2.0, y + height / 2.0}; }
  [[nodiscard]] bool overlaps(const RectPx& other) const {
    return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
  }
};

enum class Align : std::uint8_t { kLeft, kCenter, kRight };

/// DejaVu Sans (Debian fonts-dejavu-core). Hinting is off, so that letters do not depend on a user's font
/// settings.
struct TextStyle {
  double size_px{22.0};
  Rgba color{palette::kInk};
  bool bold{false};
  Align align{Align::kLeft};
  double turn_rad{0.0};   ///< counter-clockwise, about the anchor
  Rgba halo{0, 0, 0, 0};  ///< a soft rim around the letters; none when clear
};

struct LineStyle {
  double width_px{2.0};
  Rgba color{palette::kInk};
  double dash_px{0.0};  ///< dash and gap; 0 draws it whole
};

/// Flat drawing with text, by cairo, onto pixels or into an SVG.
class Canvas {
 public:
  /// \pre 0 < width_px, height_px <= kLargestSide_px
  [[nodiscard]] static Canvas pixels(int width_px, int height_px, Rgba paper = palette::kPaper);
  /// Goes on where an image stops.
  [[nodiscard]] static Canvas over(const Image& image);
  [[nodiscard]] static Canvas svg(int width_px, int height_px, Rgba paper = palette::kPaper);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  void fill(std::span<const Vec2> polygon, Rgba color);
  void fill(const RectPx& rect, Rgba color);
  void outline(const RectPx& rect, const LineStyle& style);
  void line(std::span<const Vec2> points, const LineStyle& style);
  void line(const Vec2& from, const Vec2& to, const LineStyle& style);
  void disc(const Vec2& center, double radius_px, Rgba color);
  void ring(const Vec2& center, double radius_px, const LineStyle& style);
  void image(const Image& image, const Vec2& top_left);
  /// Nothing is drawn outside until unclip().
  void clip(const RectPx& rect);
  void unclip();

  /// Anchor: left, middle or right of the text by `align`; vertically the middle of its capitals. Malformed
  /// UTF-8 and control characters show as '?'.
  void text(const Vec2& anchor, std::string_view utf8, const TextStyle& style);
  /// Advance width.
  [[nodiscard]] double width_of(std::string_view utf8, const TextStyle& style) const;
  /// The style, made smaller (down to `least` of its size) until the text is at most `width_px` wide.
  [[nodiscard]] TextStyle fitted(std::string_view utf8, TextStyle style, double width_px,
                                 double least = 0.6) const;
  /// The text, cut with an ellipsis when it is wider than `width_px`.
  [[nodiscard]] std::string cut(std::string_view utf8, const TextStyle& style, double width_px) const;

  /// What has been drawn. \pre made by pixels() or over()
  [[nodiscard]] Rendered<Image> take_image();
  /// The SVG file; ends the drawing. \pre made by svg()
  [[nodiscard]] Rendered<std::string> take_svg();

 private:
  struct Impl;
  explicit Canvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sensotwin::render
