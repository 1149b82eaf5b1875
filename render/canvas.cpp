// SPDX-License-Identifier: MIT
#include "render/canvas.hpp"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sensotwin::render {
namespace {

// Height of DejaVu Sans capitals over the font size (1493 of 2048 units).
constexpr double kCapHeight = 0.729;

/// Bytes of a well-formed UTF-8 character at the head of `s`, 0 when malformed or a control character.
[[nodiscard]] std::size_t character_length(std::string_view s) {
  const auto lead = static_cast<unsigned char>(s[0]);
  if (lead < 0x80u) {
    return lead >= 0x20u && lead != 0x7Fu ? 1 : 0;
  }
  const std::size_t length = lead >= 0xF0u && lead < 0xF5u ? 4 : lead >= 0xE0u ? 3 : lead >= 0xC2u ? 2 : 0;
  if (length == 0 || lead >= 0xF5u || s.size() < length) {
    return 0;
  }
  std::uint32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(s[i]);
    if ((byte & 0xC0u) != 0x80u) {
      return 0;
    }
    code = (code << 6) | (byte & 0x3Fu);
  }
  const bool overlong = (length == 3 && code < 0x800u) || (length == 4 && code < 0x10000u);
  const bool surrogate = code >= 0xD800u && code < 0xE000u;
  return overlong || surrogate || code > 0x10FFFFu ? 0 : length;
}

/// cairo goes silent for good after one malformed string: none may reach it.
[[nodiscard]] std::string printable(std::string_view utf8) {
  std::string out;
  while (!utf8.empty()) {
    const std::size_t n = character_length(utf8);
    if (n == 0) {
      out.push_back('?');
      utf8.remove_prefix(1);
    } else {
      out.append(utf8.substr(0, n));
      utf8.remove_prefix(n);
    }
  }
  return out;
}

cairo_status_t append_svg(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// cairo's ARGB32 is one native-endian word, alpha first and multiplied in.
[[nodiscard]] std::uint32_t word_from(Rgba c) {
  const auto premultiplied = [&c](std::uint8_t v) {
    return (static_cast<std::uint32_t>(v) * c.a + 127u) / 255u;
  };
  return (static_cast<std::uint32_t>(c.a) << 24) | (premultiplied(c.r) << 16) | (premultiplied(c.g) << 8) |
         premultiplied(c.b);
}

[[nodiscard]] Rgba rgba_from(std::uint32_t word) {
  const std::uint32_t alpha = word >> 24;
  const auto plain = [alpha](std::uint32_t v) {
    return alpha == 0 ? std::uint8_t{0}
                      : static_cast<std::uint8_t>(std::min(255u, (v * 255u + alpha / 2u) / alpha));
  };
  return {plain((word >> 16) & 0xFFu), plain((word >> 8) & 0xFFu), plain(word & 0xFFu),
          static_cast<std::uint8_t>(alpha)};
}

/// cairo numbers surfaces through the whole process ("surface583"): counts them anew within the file, so that
/// equal drawings give equal files.
[[nodiscard]] std::string with_local_ids(const std::string& svg) {
  static constexpr std::string_view kName = "surface";
  std::map<std::string, std::size_t> numbers;
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = svg.find(kName); at != std::string::npos; at = svg.find(kName, from)) {
    const std::size_t digits = at + kName.size();
    std::size_t end = digits;
    while (end < svg.size() && svg[end] >= '0' && svg[end] <= '9') {
      ++end;
    }
    out.append(svg, from, digits - from);
    if (end > digits) {
      out += std::to_string(
          numbers.try_emplace(svg.substr(digits, end - digits), numbers.size() + 1).first->second);
    }
    from = end;
  }
  return out + svg.substr(from);
}

[[nodiscard]] cairo_surface_t* surface_from(const Image& image) {
  cairo_surface_t* surface =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width_px(), image.height_px());
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
    return surface;
  }
  cairo_surface_flush(surface);
  auto* data = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (int y = 0; y < image.height_px(); ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + stride * static_cast<std::size_t>(y));
    for (int x = 0; x < image.width_px(); ++x) {
      row[x] = word_from(image.at(x, y));
    }
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

}  // namespace

struct Canvas::Impl {
  cairo_surface_t* surface{nullptr};
  cairo_t* cr{nullptr};
  std::string svg;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (cr != nullptr) {
      cairo_destroy(cr);
    }
    if (surface != nullptr) {
      cairo_surface_destroy(surface);
    }
  }
  void start(cairo_surface_t* on) {
    surface = on;
    cr = cairo_create(surface);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cr, options);
    cairo_font_options_destroy(options);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  }
  void ink(Rgba c) const { cairo_set_source_rgba(cr, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0); }
  void font(const TextStyle& style) const {
    cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, style.size_px);
  }
  void stroke(const LineStyle& style) const {
    ink(style.color);
    cairo_set_line_width(cr, style.width_px);
    cairo_set_dash(cr, &style.dash_px, style.dash_px > 0.0 ? 1 : 0, 0.0);
    cairo_set_line_cap(cr, style.dash_px > 0.0 ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_stroke(cr);
  }
  void path(std::span<const Vec2> points) const {
    cairo_new_path(cr);
    for (const Vec2& p : points) {
      cairo_line_to(cr, p.x(), p.y());
    }
  }
};

Canvas::Canvas(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

Canvas Canvas::pixels(int width_px, int height_px, Rgba paper) {
  return over(Image(width_px, height_px, paper));
}

Canvas Canvas::over(const Image& image) {
  auto impl = std::make_unique<Impl>();
  impl->start(surface_from(image));
  return Canvas(std::move(impl));
}

Canvas Canvas::svg(int width_px, int height_px, Rgba paper) {
  auto impl = std::make_unique<Impl>();
  impl->start(cairo_svg_surface_create_for_stream(append_svg, &impl->svg, width_px, height_px));
  Canvas canvas(std::move(impl));
  canvas.fill(RectPx{0.0, 0.0, static_cast<double>(width_px), static_cast<double>(height_px)}, paper);
  return canvas;
}

void Canvas::fill(std::span<const Vec2> polygon, Rgba color) {
  impl_->path(polygon);
  impl_->ink(color);
  cairo_fill(impl_->cr);
}

void Canvas::fill(const RectPx& rect, Rgba color) {
  cairo_rectangle(impl_->cr, rect.x, rect.y, rect.width, rect.height);
  impl_->ink(color);
  cairo_fill(impl_->cr);
}

void Canvas::outline(const RectPx& rect, const LineStyle& style) {
  cairo_rectangle(impl_->cr, rect.x, rect.y, rect.width, rect.height);
  impl_->stroke(style);
}

void Canvas::line(std::span<const Vec2> points, const LineStyle& style) {
  impl_->path(points);
  impl_->stroke(style);
}

void Canvas::line(const Vec2& from, const Vec2& to, const LineStyle& style) {
  const Vec2 both[] = {from, to};
  line(both, style);
}

void Canvas::disc(const Vec2& center, double radius_px, Rgba color) {
  cairo_new_path(impl_->cr);
  cairo_arc(impl_->cr, center.x(), center.y(), radius_px, 0.0, 2.0 * robot::kPi);
  impl_->ink(color);
  cairo_fill(impl_->cr);
}

void Canvas::ring(const Vec2& center, double radius_px, const LineStyle& style) {
  cairo_new_path(impl_->cr);
  cairo_arc(impl_->cr, center.x(), center.y(), radius_px, 0.0, 2.0 * robot::kPi);
  cairo_close_path(impl_->cr);
  impl_->stroke(style);
}

void Canvas::image(const Image& image, const Vec2& top_left) {
  cairo_surface_t* surface = surface_from(image);
  cairo_set_source_surface(impl_->cr, surface, top_left.x(), top_left.y());
  cairo_paint(impl_->cr);
  cairo_surface_destroy(surface);
}

void Canvas::clip(const RectPx& rect) {
  cairo_save(impl_->cr);
  cairo_rectangle(impl_->cr, rect.x, rect.y, rect.width, rect.height);
  cairo_clip(impl_->cr);
}

void Canvas::unclip() {
  cairo_restore(impl_->cr);
}

void Canvas::text(const Vec2& anchor, std::string_view utf8, const TextStyle& style) {
  const std::string shown = printable(utf8);
  const double width = width_of(utf8, style);
  const double left = style.align == Align::kLeft     ? 0.0
                      : style.align == Align::kCenter ? -width / 2.0
                                                      : -width;
  cairo_t* cr = impl_->cr;
  cairo_save(cr);
  cairo_translate(cr, anchor.x(), anchor.y());
  cairo_rotate(cr, -style.turn_rad);
  impl_->font(style);
  cairo_move_to(cr, left, kCapHeight * style.size_px / 2.0);
  if (style.halo.a > 0) {
    cairo_text_path(cr, shown.c_str());
    // Width chosen by eye: a quarter of the letter size clears the lines behind without closing gaps.
    impl_->stroke({style.size_px * 0.25, style.halo, 0.0});
    cairo_move_to(cr, left, kCapHeight * style.size_px / 2.0);
  }
  impl_->ink(style.color);
  cairo_show_text(cr, shown.c_str());
  cairo_new_path(cr);
  cairo_restore(cr);
}

double Canvas::width_of(std::string_view utf8, const TextStyle& style) const {
  impl_->font(style);
  cairo_text_extents_t extents;
  cairo_text_extents(impl_->cr, printable(utf8).c_str(), &extents);
  return extents.x_advance;
}

TextStyle Canvas::fitted(std::string_view utf8, TextStyle style, double width_px, double least) const {
  const double width = width_of(utf8, style);
  if (width > width_px && width > 0.0) {
    style.size_px *= std::max(least, width_px / width);
  }
  return style;
}

std::string Canvas::cut(std::string_view utf8, const TextStyle& style, double width_px) const {
  std::string shown = printable(utf8);
  if (width_of(shown, style) <= width_px) {
    return shown;
  }
  while (!shown.empty() && width_of(shown + "…", style) > width_px) {
    do {
      const bool continuation = (static_cast<unsigned char>(shown.back()) & 0xC0u) == 0x80u;
      shown.pop_back();
      if (!continuation) {
        break;
      }
    } while (!shown.empty());
  }
  return shown + "…";
}

Rendered<Image> Canvas::take_image() {
  cairo_surface_flush(impl_->surface);
  if (const cairo_status_t status = cairo_status(impl_->cr); status != CAIRO_STATUS_SUCCESS) {
    return Unexpected{
        RenderError{RenderError::Kind::kEncoding, std::string("cairo: ") + cairo_status_to_string(status)}};
  }
  const auto* data = cairo_image_surface_get_data(impl_->surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(impl_->surface));
  Image image(cairo_image_surface_get_width(impl_->surface), cairo_image_surface_get_height(impl_->surface));
  for (int y = 0; y < image.height_px(); ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + stride * static_cast<std::size_t>(y));
    for (int x = 0; x < image.width_px(); ++x) {
      image.at(x, y) = rgba_from(row[x]);
    }
  }
  return image;
}

Rendered<std::string> Canvas::take_svg() {
  cairo_surface_finish(impl_->surface);
  if (const cairo_status_t status = cairo_surface_status(impl_->surface); status != CAIRO_STATUS_SUCCESS) {
    return Unexpected{
        RenderError{RenderError::Kind::kEncoding, std::string("cairo: ") + cairo_status_to_string(status)}};
  }
  return with_local_ids(impl_->svg);
}

}  // namespace sensotwin::render
