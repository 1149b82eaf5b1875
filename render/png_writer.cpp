// SPDX-License-Identifier: MIT
#include "render/png_writer.hpp"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <csetjmp>

namespace sensotwin::render {
namespace {

using Buffer = std::vector<std::uint8_t>;

void append_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* buffer = static_cast<Buffer*>(png_get_io_ptr(png));
  buffer->insert(buffer->end(), data, data + size);
}

void flush_nothing(png_structp) {}

void keep_message(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// PNG's tEXt is Latin-1: plain ASCII passes, one '?' for each other character.
[[nodiscard]] std::string ascii_only(std::string_view utf8) {
  std::string out;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20u && byte < 0x7Fu) {
      out.push_back(c);
    } else if ((byte & 0xC0u) != 0x80u) {
      out.push_back('?');
    }
  }
  return out;
}

/// Everything that libpng's longjmp may fly over lives outside this function and has no destructor in it.
[[nodiscard]] bool write_png(png_structp png, png_infop info, const Image& image, bool opaque,
                             std::array<png_text, 2>& texts, int text_count, Buffer& row) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width_px()),
               static_cast<png_uint_32>(image.height_px()), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Flat colours repeat as they are: differences from neighbours, the default, make our files larger.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_text(png, info, texts.data(), text_count);
  png_write_info(png, info);
  for (int y = 0; y < image.height_px(); ++y) {
    std::size_t i = 0;
    for (int x = 0; x < image.width_px(); ++x) {
      const Rgba& c = image.at(x, y);
      row[i++] = c.r;
      row[i++] = c.g;
      row[i++] = c.b;
      if (!opaque) {
        row[i++] = c.a;
      }
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string provenance(std::string_view scene, std::uint64_t seed, std::string_view renderer) {
  return fmt::format("scene {}, seed {}, renderer {}", scene, seed, renderer);
}

Rendered<std::vector<std::uint8_t>> encode_png(const Image& image, const PngText& text) {
  if (image.width_px() == 0 || image.height_px() == 0) {
    return Unexpected{RenderError{RenderError::Kind::kBadView, "cannot write a PNG without pixels"}};
  }
  std::string message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) {
    png_destroy_write_struct(&png, nullptr);
    return Unexpected{RenderError{RenderError::Kind::kEncoding, "libpng gave no writer"}};
  }
  Buffer file;
  png_set_write_fn(png, &file, append_bytes, flush_nothing);

  std::string software = ascii_only(text.software);
  std::string comment = ascii_only(text.comment);
  std::string software_key = "Software";
  std::string comment_key = "Comment";
  std::array<png_text, 2> texts{};
  texts[0].compression = PNG_TEXT_COMPRESSION_NONE;
  texts[0].key = software_key.data();
  texts[0].text = software.data();
  texts[0].text_length = software.size();
  texts[1].compression = PNG_TEXT_COMPRESSION_NONE;
  texts[1].key = comment_key.data();
  texts[1].text = comment.data();
  texts[1].text_length = comment.size();

  Buffer row(static_cast<std::size_t>(image.width_px()) * 4u);
  const bool ok = write_png(png, info, image, image.opaque(), texts, comment.empty() ? 1 : 2, row);
  png_destroy_write_struct(&png, &info);
  if (!ok) {
    return Unexpected{RenderError{RenderError::Kind::kEncoding, "libpng: " + message}};
  }
  return file;
}

}  // namespace sensotwin::render
