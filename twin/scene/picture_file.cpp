// SPDX-License-Identifier: MIT
#include "twin/scene/picture_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cctype>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <optional>

namespace sensotwin::twin {
namespace {

using Decoded = robot::Result<GreyPicture, std::string>;

std::optional<std::string> size_trouble(std::uint64_t columns, std::uint64_t rows) {
  if (columns == 0 || rows == 0) {
    return fmt::format("has {} x {} pixels", columns, rows);
  }
  if (columns > kPictureSideMax || rows > kPictureSideMax) {
    return fmt::format("has {} x {} pixels, more than {} a side", columns, rows, kPictureSideMax);
  }
  return std::nullopt;
}

/// The header and, in P2, the pixels of a PGM: numbers between blanks and comments.
class PgmText {
 public:
  explicit PgmText(const std::string& bytes) : bytes_(bytes) {}

  /// The next number, if there is one below 2^31.
  std::optional<std::uint32_t> number() {
    skip_blanks();
    std::uint64_t value = 0;
    const std::size_t from = at_;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = value * 10 + static_cast<unsigned>(bytes_[at_] - '0');
      if (value > 0x7FFFFFFFu) {
        return std::nullopt;
      }
      ++at_;
    }
    return at_ == from ? std::nullopt : std::optional<std::uint32_t>(static_cast<std::uint32_t>(value));
  }
  [[nodiscard]] bool at_end() const { return at_ >= bytes_.size(); }
  /// Of the pixels of a P5: one blank follows the last number of the header.
  [[nodiscard]] std::size_t pixels_at() const { return at_ + 1; }

 private:
  void skip_blanks() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }
  const std::string& bytes_;
  std::size_t at_{2};
};

std::uint16_t grey_of(std::uint32_t value, std::uint32_t maxval) {
  return static_cast<std::uint16_t>((2u * value * GreyPicture::kWhite + maxval) / (2u * maxval));
}

Decoded decode_pgm(const std::string& bytes) {
  PgmText text(bytes);
  const auto columns = text.number();
  const auto rows = text.number();
  const auto maxval = text.number();
  if (!columns || !rows || !maxval) {
    return robot::Unexpected<std::string>{
        text.at_end() ? "is cut off in its header" : "has a PGM header without width, height and maxval"};
  }
  if (*maxval == 0 || *maxval > 65535) {
    return robot::Unexpected<std::string>{fmt::format("has maxval {}, which is not in 1 to 65535", *maxval)};
  }
  if (auto trouble = size_trouble(*columns, *rows)) {
    return robot::Unexpected<std::string>{*trouble};
  }
  const std::size_t wanted = std::size_t{*columns} * *rows;
  const std::size_t width = *maxval > 255 ? 2 : 1;
  const std::size_t from = text.pixels_at();
  const bool plain = bytes[1] == '2';
  const std::size_t have = from >= bytes.size() ? 0 : bytes.size() - from;
  // A number of a P2 takes at least a digit and a blank.
  if (plain ? have + 1 < 2 * wanted : have < wanted * width) {
    return robot::Unexpected<std::string>{fmt::format("is cut off: {} bytes of pixels where {} are needed",
                                                      have, plain ? 2 * wanted - 1 : wanted * width)};
  }
  GreyPicture picture{static_cast<int>(*columns), static_cast<int>(*rows), {}};
  picture.pixels.reserve(wanted);
  for (std::size_t i = 0; i < wanted; ++i) {
    std::uint32_t value = 0;
    if (plain) {
      const auto number = text.number();
      if (!number) {
        return robot::Unexpected<std::string>{
            fmt::format("is cut off: {} pixels where {} are needed", i, wanted)};
      }
      value = *number;
    } else {
      const auto byte = [&](std::size_t k) {
        return static_cast<unsigned char>(bytes[from + i * width + k]);
      };
      value = width == 1 ? byte(0) : static_cast<std::uint32_t>(byte(0) << 8 | byte(1));
    }
    picture.pixels.push_back(grey_of(std::min(value, *maxval), *maxval));
  }
  return picture;
}

/// What libpng reads from and reports to.
struct PngSource {
  const std::string& bytes;
  std::size_t at{0};
  bool cut_off{false};
  char message[160]{};
};

void png_take(png_structp png, png_bytep into, std::size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (count > source->bytes.size() - source->at) {
    source->cut_off = true;
    png_error(png, "end of file");
  }
  std::memcpy(into, source->bytes.data() + source->at, count);
  source->at += count;
}

void png_failed(png_structp png, png_const_charp message) {
  auto* source = static_cast<PngSource*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}

void png_warned(png_structp, png_const_charp) {}

/// Every kind of PNG becomes 8-bit RGBA.
void ask_for_rgba(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

/// Everything that libpng's longjmp may jump out of; holds no object with a destructor of its own.
/// \returns false when libpng gave up or the size is not acceptable
bool png_rows(png_structp png, png_infop info, GreyPicture& picture, std::vector<png_byte>& rgba,
              std::vector<png_bytep>& row_starts) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_read_info(png, info);
  picture.columns = static_cast<int>(png_get_image_width(png, info));
  picture.rows = static_cast<int>(png_get_image_height(png, info));
  if (picture.columns > kPictureSideMax || picture.rows > kPictureSideMax) {
    return false;
  }
  ask_for_rgba(png, info);
  const auto columns = static_cast<std::size_t>(picture.columns);
  rgba.resize(columns * static_cast<std::size_t>(picture.rows) * 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(picture.rows); ++row) {
    row_starts.push_back(rgba.data() + row * columns * 4);
  }
  png_read_image(png, row_starts.data());
  png_read_end(png, nullptr);
  return true;
}

Decoded decode_png(const std::string& bytes) {
  PngSource source{bytes};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, png_failed, png_warned);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &source, png_take);
  // Our own limit is checked first, with a message of our own.
  png_set_user_limits(png, 0x7FFFFFFF, 0x7FFFFFFF);
  GreyPicture picture;
  std::vector<png_byte> rgba;
  std::vector<png_bytep> row_starts;
  const bool whole = png_rows(png, info, picture, rgba, row_starts);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!whole) {
    if (source.message[0] == '\0') {
      const auto trouble =
          size_trouble(static_cast<std::uint64_t>(picture.columns), static_cast<std::uint64_t>(picture.rows));
      return robot::Unexpected<std::string>{trouble.value_or("cannot be read")};
    }
    return robot::Unexpected<std::string>{source.cut_off
                                              ? fmt::format("is cut off after {} bytes", bytes.size())
                                              : fmt::format("is a damaged PNG: {}", source.message)};
  }
  picture.pixels.reserve(rgba.size() / 4);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const auto sum = static_cast<std::uint16_t>(rgba[i] + rgba[i + 1] + rgba[i + 2]);
    picture.pixels.push_back(rgba[i + 3] < 128 ? GreyPicture::kClear : sum);
  }
  return picture;
}

}  // namespace

Decoded decode_picture(const std::string& file_bytes) {
  if (file_bytes.empty()) {
    return robot::Unexpected<std::string>{"is empty (0 bytes)"};
  }
  if (file_bytes.starts_with("\x89PNG")) {
    return decode_png(file_bytes);
  }
  if (file_bytes.starts_with("P5") || file_bytes.starts_with("P2")) {
    return decode_pgm(file_bytes);
  }
  return robot::Unexpected<std::string>{"is neither a PGM (P2, P5) nor a PNG"};
}

}  // namespace sensotwin::twin
