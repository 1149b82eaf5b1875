// SPDX-License-Identifier: MIT
#include "twin/scene/picture_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sensotwin::twin {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::uint16_t> pixels_of(const std::string& bytes) {
  const auto picture = decode_picture(bytes);
  EXPECT_TRUE(picture) << picture.error();
  return picture ? picture->pixels : std::vector<std::uint16_t>{};
}

std::string trouble_of(const std::string& bytes) {
  const auto picture = decode_picture(bytes);
  return picture ? "no trouble" : picture.error();
}

/// A PNG of one row, written by libpng. `row`: as it lies in the file.
std::string png(int columns, int depth, int color_type, std::vector<std::uint8_t> row,
                bool interlaced = false) {
  std::string bytes;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  png_set_write_fn(
      writer, &bytes,
      [](png_structp png, png_bytep data, png_size_t count) {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), count);
      },
      nullptr);
  png_set_IHDR(writer, info, static_cast<png_uint_32>(columns), 1, depth, color_type,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[] = {{0, 0, 0}, {30, 60, 90}, {255, 255, 255}};
  if (color_type == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(writer, info, palette, 3);
  }
  png_write_info(writer, info);
  png_bytep rows[] = {row.data()};
  png_write_image(writer, rows);
  png_write_end(writer, nullptr);
  png_destroy_write_struct(&writer, &info);
  return bytes;
}

TEST(Pgm, ReadsRawBytes) {
  EXPECT_THAT(pixels_of(std::string("P5\n3 1\n255\n\x00\xFE\xFF", 14)), ElementsAre(0, 762, 765));
}

TEST(Pgm, ReadsPlainNumbers) {
  EXPECT_THAT(pixels_of("P2 3 1 255 0 254\n255"), ElementsAre(0, 762, 765));
}

TEST(Pgm, PassesOverCommentsWhereverTheyStand) {
  EXPECT_THAT(pixels_of("P2 # kind\n# Created by GIMP\n3 1 # size\n255\n0 # first\n254 255"),
              ElementsAre(0, 762, 765));
}

TEST(Pgm, ScalesByItsMaxval) {
  EXPECT_THAT(pixels_of("P2 3 1 15 0 5 15"), ElementsAre(0, 255, 765));
  EXPECT_THAT(pixels_of(std::string("P5 2 1 65535\n\xFF\xFF\x80\x00", 17)), ElementsAre(765, 383));
}

TEST(Pgm, CountsValuesAboveMaxvalAsWhite) {
  EXPECT_THAT(pixels_of("P2 1 1 15 99"), ElementsAre(765));
}

TEST(Pgm, ReportsAPictureThatIsCutOff) {
  EXPECT_EQ(trouble_of("P5\n100 100\n255\nabc"), "is cut off: 3 bytes of pixels where 10000 are needed");
  EXPECT_EQ(trouble_of("P5\n100 100\n255\n"), "is cut off: 0 bytes of pixels where 10000 are needed");
  EXPECT_EQ(trouble_of("P5\n100"), "is cut off in its header");
  EXPECT_EQ(trouble_of("P2\n2 2 255 1 200 100 "), "is cut off: 3 pixels where 4 are needed");
}

TEST(Pgm, ReportsSizesThatCannotBe) {
  EXPECT_EQ(trouble_of("P5\n0 4\n255\n"), "has 0 x 4 pixels");
  EXPECT_EQ(trouble_of("P5\n20000 4\n255\n"), "has 20000 x 4 pixels, more than 16384 a side");
  EXPECT_EQ(trouble_of("P5\n4 4\n0\n"), "has maxval 0, which is not in 1 to 65535");
  EXPECT_EQ(trouble_of("P5\nwide 4\n255\n"), "has a PGM header without width, height and maxval");
  EXPECT_EQ(trouble_of("P5\n99999999999999999999 4\n255\n"),
            "has a PGM header without width, height and maxval");
}

TEST(Picture, ReportsWhatItIsNot) {
  EXPECT_EQ(trouble_of(""), "is empty (0 bytes)");
  EXPECT_EQ(trouble_of("P6\n1 1\n255\nabc"), "is neither a PGM (P2, P5) nor a PNG");
  EXPECT_EQ(trouble_of("GIF89a"), "is neither a PGM (P2, P5) nor a PNG");
}

TEST(Png, ReadsEveryKindOfPixel) {
  EXPECT_THAT(pixels_of(png(3, 1, PNG_COLOR_TYPE_GRAY, {0b01000000})), ElementsAre(0, 765, 0));
  EXPECT_THAT(pixels_of(png(2, 4, PNG_COLOR_TYPE_GRAY, {0x0F})), ElementsAre(0, 765));
  EXPECT_THAT(pixels_of(png(2, 8, PNG_COLOR_TYPE_GRAY, {10, 250})), ElementsAre(30, 750));
  EXPECT_THAT(pixels_of(png(2, 16, PNG_COLOR_TYPE_GRAY, {0x80, 0x80, 0xFF, 0xFF})), ElementsAre(384, 765));
  EXPECT_THAT(pixels_of(png(3, 8, PNG_COLOR_TYPE_PALETTE, {0, 1, 2})), ElementsAre(0, 180, 765));
  EXPECT_THAT(pixels_of(png(1, 8, PNG_COLOR_TYPE_RGB, {1, 2, 255})), ElementsAre(258));
  EXPECT_THAT(pixels_of(png(2, 8, PNG_COLOR_TYPE_GRAY, {10, 250}, true)), ElementsAre(30, 750));
}

TEST(Png, MarksPixelsThatAreMoreThanHalfTransparent) {
  EXPECT_THAT(pixels_of(png(2, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {10, 0, 10, 255})),
              ElementsAre(GreyPicture::kClear, 30));
  EXPECT_THAT(pixels_of(png(2, 8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 127, 1, 2, 3, 128})),
              ElementsAre(GreyPicture::kClear, 6));
}

TEST(Png, ReportsAFileThatIsCutOff) {
  const std::string whole = png(2, 8, PNG_COLOR_TYPE_GRAY, {10, 250});
  EXPECT_EQ(trouble_of(whole.substr(0, 40)), "is cut off after 40 bytes");
  EXPECT_EQ(trouble_of(whole.substr(0, 8)), "is cut off after 8 bytes");
}

TEST(Png, ReportsDamage) {
  std::string damaged = png(2, 8, PNG_COLOR_TYPE_GRAY, {10, 250});
  damaged[20] = static_cast<char>(damaged[20] ^ 1);
  EXPECT_THAT(trouble_of(damaged), HasSubstr("is a damaged PNG: "));
}

TEST(Picture, NeverCrashesOnAFlippedByteOrACutFile) {
  const std::vector<std::string> wholes{png(3, 8, PNG_COLOR_TYPE_PALETTE, {0, 1, 2}), "P2 3 1 255 0 254 255",
                                        std::string("P5\n3 1\n255\n\x00\xFE\xFF", 14)};
  for (const std::string& whole : wholes) {
    for (std::size_t n = 0; n < whole.size(); ++n) {
      (void)trouble_of(whole.substr(0, n));
      for (int bit = 0; bit < 8; ++bit) {
        std::string flipped = whole;
        flipped[n] = static_cast<char>(flipped[n] ^ (1 << bit));
        (void)trouble_of(flipped);
      }
    }
  }
}

}  // namespace
}  // namespace sensotwin::twin
