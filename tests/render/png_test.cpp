// SPDX-License-Identifier: MIT
#include <png.h>

#include <cstring>
#include <map>

#include "picture_check.hpp"
#include "render/png_writer.hpp"

namespace sensotwin::render::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

[[nodiscard]] Image decoded(const Bytes& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, file.data(), file.size()) == 0) {
    return {};
  }
  png.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  Bytes raw(PNG_IMAGE_SIZE(png));
  png_image_finish_read(&png, nullptr, raw.data(), 0, nullptr);
  for (int y = 0; y < image.height_px(); ++y) {
    for (int x = 0; x < image.width_px(); ++x) {
      const std::uint8_t* p = &raw[static_cast<std::size_t>(y * image.width_px() + x) * 4u];
      image.at(x, y) = {p[0], p[1], p[2], p[3]};
    }
  }
  return image;
}

/// Chunk types, and the texts by keyword.
struct Chunks {
  std::vector<std::string> types;
  std::map<std::string, std::string> texts;
};
[[nodiscard]] Chunks chunks_of(const Bytes& file) {
  Chunks chunks;
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::size_t length = (std::size_t{file[at]} << 24) | (std::size_t{file[at + 1]} << 16) |
                               (std::size_t{file[at + 2]} << 8) | file[at + 3];
    const std::string type(file.begin() + static_cast<long>(at) + 4,
                           file.begin() + static_cast<long>(at) + 8);
    const std::string data(file.begin() + static_cast<long>(at) + 8,
                           file.begin() + static_cast<long>(at + 8 + length));
    chunks.types.push_back(type);
    if (type == "tEXt") {
      chunks.texts[data.substr(0, data.find('\0'))] = data.substr(data.find('\0') + 1);
    }
    at += 12 + length;
  }
  return chunks;
}

[[nodiscard]] Image gradient(std::uint8_t alpha) {
  Image image(37, 23);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y), 99, alpha};
    }
  }
  return image;
}

TEST(PngWriter, KeepsEveryPixelOpaqueOrNot) {
  for (const std::uint8_t alpha : {std::uint8_t{255}, std::uint8_t{128}}) {
    const auto file = encode_png(gradient(alpha), {});
    ASSERT_TRUE(file);
    EXPECT_EQ(decoded(*file), gradient(alpha));
  }
}

TEST(PngWriter, SaysWhatMadeThePictureAndNotWhen) {
  const auto file = encode_png(gradient(255), {"SensoTwin 0.1.0", provenance("house", 7, "llvmpipe")});
  ASSERT_TRUE(file);
  const Chunks chunks = chunks_of(*file);
  EXPECT_EQ(chunks.texts.at("Software"), "SensoTwin 0.1.0");
  EXPECT_EQ(chunks.texts.at("Comment"), "scene house, seed 7, renderer llvmpipe");
  EXPECT_THAT(chunks.types, ::testing::Not(::testing::Contains("tIME")));
}

TEST(PngWriter, WritesTheSameBytesTwice) {
  EXPECT_EQ(*encode_png(gradient(255), {}), *encode_png(gradient(255), {}));
}

TEST(PngWriter, ReplacesWhatLatin1CannotHold) {
  const auto file = encode_png(gradient(255), {"SensoTwin", "scene häuschen\n"});
  ASSERT_TRUE(file);
  EXPECT_EQ(chunks_of(*file).texts.at("Comment"), "scene h?uschen?");
}

TEST(PngWriter, RefusesAnImageWithoutPixels) {
  const auto file = encode_png(Image{}, {});
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, RenderError::Kind::kBadView);
}

}  // namespace
}  // namespace sensotwin::render::testing
