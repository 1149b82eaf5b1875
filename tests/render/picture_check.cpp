// SPDX-License-Identifier: MIT
#include "picture_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/png_writer.hpp"

namespace sensotwin::render {

void PrintTo(const Rgba& color, std::ostream* out) {
  *out << "rgb(" << int{color.r} << ", " << int{color.g} << ", " << int{color.b} << ")";
}

namespace testing {

Rgba color_at(const Image& image, const Vec2& px) {
  const int x = static_cast<int>(std::floor(px.x()));
  const int y = static_cast<int>(std::floor(px.y()));
  return image.contains(x, y) ? image.at(x, y) : palette::kPaper;
}

int inked_pixels(const Image& image, const RectPx& rect, Rgba paper) {
  int count = 0;
  for (int y = static_cast<int>(rect.y); y < static_cast<int>(rect.bottom()); ++y) {
    for (int x = static_cast<int>(rect.x); x < static_cast<int>(rect.right()); ++x) {
      count += image.contains(x, y) && image.at(x, y) != paper ? 1 : 0;
    }
  }
  return count;
}

Difference difference(const Image& a, const Image& b, int tolerance) {
  Difference out;
  for (std::size_t i = 0; i < std::min(a.pixels().size(), b.pixels().size()); ++i) {
    const Rgba& p = a.pixels()[i];
    const Rgba& q = b.pixels()[i];
    const int d = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    out.largest = std::max(out.largest, d);
    out.pixels += d > tolerance ? 1 : 0;
  }
  return out;
}

void PictureTest::SetUp() {
  // A test program is a main(): see OffscreenContext on the threads of llvmpipe.
  ::setenv("LP_NUM_THREADS", "1", 0);
  auto context = make_context();
  if (!context) {
    GTEST_SKIP() << context.error().message;
  }
  context_ = std::move(*context);
}

void PictureTest::TearDown() {
  if (!HasFailure() || kept_.width_px() == 0) {
    return;
  }
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = SENSOTWIN_TEST_OUTPUT;
  std::filesystem::create_directories(folder);
  const auto path = folder / (std::string(test->test_suite_name()) + "." + test->name() + ".png");
  const auto png = encode_png(kept_, {"SensoTwin", test->name()});
  if (png) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(png->data()), static_cast<std::streamsize>(png->size()));
  }
  std::cerr << "picture of the failing test: " << path.string() << "\n";
}

}  // namespace testing
}  // namespace sensotwin::render
