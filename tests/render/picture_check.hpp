// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/canvas.hpp"
#include "render/offscreen_context.hpp"
#include "render/scene_picture.hpp"

namespace sensotwin::render {

void PrintTo(const Rgba& color, std::ostream* out);  // NOLINT(readability-identifier-naming): GTest's name

namespace testing {

/// Each channel within `tolerance`. Drivers round differently by one step, so 2 tells colours apart and not
/// drivers.
MATCHER_P2(ColorNear, expected, tolerance, "a colour near " + ::testing::PrintToString(expected)) {
  const auto near = [&](int a, int b) { return a - b <= tolerance && b - a <= tolerance; };
  return near(arg.r, expected.r) && near(arg.g, expected.g) && near(arg.b, expected.b);
}

/// The colour of the pixel in which a point of the picture lies; paper outside.
[[nodiscard]] Rgba color_at(const Image& image, const Vec2& px);
/// Pixels in the rectangle that are not `paper`.
[[nodiscard]] int inked_pixels(const Image& image, const RectPx& rect, Rgba paper = palette::kPaper);
/// The most that any channel of any pixel differs, and how many pixels differ by more than `tolerance`.
struct Difference {
  int largest{0};
  int pixels{0};
};
[[nodiscard]] Difference difference(const Image& a, const Image& b, int tolerance);

/// Tests that draw. A picture registered with keep() is saved when the test fails.
class PictureTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  [[nodiscard]] OffscreenContext& gl() { return *context_; }
  void keep(const Image& image) { kept_ = image; }

 private:
  std::unique_ptr<OffscreenContext> context_;
  Image kept_;
};

}  // namespace testing
}  // namespace sensotwin::render
