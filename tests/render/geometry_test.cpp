// SPDX-License-Identifier: MIT
#include <cmath>

#include "picture_check.hpp"
#include "render/plane_geometry.hpp"
#include "render/ticks.hpp"

namespace sensotwin::render::testing {
namespace {

[[nodiscard]] double covered_area(const Polygon& polygon) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangulate(polygon)) {
    sum += signed_area(Polygon{polygon[a], polygon[b], polygon[c]});
  }
  return sum;
}

TEST(Triangulate, CoversAnEllExactly) {
  const Polygon ell{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_NEAR(covered_area(ell), 6.0, 1e-12);
  EXPECT_NEAR(covered_area(Polygon(ell.rbegin(), ell.rend())), 6.0, 1e-12);
}

TEST(Triangulate, CoversTheRaggedOutlineOfAnImportedMap) {
  // 2000 corners of a saw: what a grid map gives for a slanted wall.
  Polygon saw;
  for (int i = 0; i < 1000; ++i) {
    saw.push_back({i * 0.05, i % 2 * 0.05});
  }
  saw.push_back({999 * 0.05, 5.0});
  saw.push_back({0.0, 5.0});
  EXPECT_NEAR(covered_area(saw), signed_area(saw), 1e-9);
}

TEST(Triangulate, EndsOnPolygonsThatAreNone) {
  EXPECT_TRUE(triangulate(Polygon{}).empty());
  EXPECT_TRUE(triangulate(Polygon{{0, 0}, {1, 1}}).empty());
  EXPECT_EQ(triangulate(Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}}).size(), 2u);
  EXPECT_EQ(triangulate(Polygon(5, Vec2{1, 1})).size(), 3u);
}

TEST(ConvexHull, DropsWhatLiesInside) {
  const Polygon hull = convex_hull({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}});
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_NEAR(signed_area(hull), 4.0, 1e-12);
}

TEST(Thinned, KeepsTheFirstAndTheLastPoint) {
  std::vector<TimedPoint> path;
  for (int i = 0; i <= 1000; ++i) {
    path.push_back({{i * 0.001, 0.0}, i * 1.0});
  }
  const auto kept = thinned(path, 0.01);
  EXPECT_LE(kept.size(), 102u);
  EXPECT_EQ(kept.front().t_s, 0.0);
  EXPECT_EQ(kept.back().t_s, 1000.0);
}

TEST(Projection, PutsTheEyesTargetWhereItLooks) {
  const Projection X = perspective({3, -4, 5}, {1, 1, 0}, 1.0, 20.0);
  EXPECT_NEAR(X.pixel(Vec3{1, 1, 0}).norm(), 0.0, 1e-12);
  // Up in the world is up on the picture: y falls.
  EXPECT_LT(X.pixel(Vec3{1, 1, 1}).y(), 0.0);
}

TEST(Projection, TellsPixelsPerMetreAcrossTheLineOfSight) {
  const Vec3 eye{3, -4, 5};
  const Vec3 target{1, 1, 0};
  const Projection X = perspective(eye, target, 1.0, 20.0);
  // A pin-hole of focal length 1 shows a metre at distance d as 1 / d.
  EXPECT_NEAR(X.px_per_m(target), 1.0 / (target - eye).norm(), 1e-12);
  EXPECT_NEAR(Projection::top({0, 0}, {0, 0}, 80.0).px_per_m(target), 80.0, 1e-12);
}

TEST(Ticks, AreRoundNumbersInsideTheRange) {
  const auto ticks = linear_ticks(0.0, 74.3, 8);
  ASSERT_EQ(ticks.size(), 8u);
  EXPECT_EQ(ticks.back().label, "70");
  EXPECT_EQ(linear_ticks(-0.3, 0.31, 7)[3].label, "0.0");
  EXPECT_EQ(linear_ticks(0.0, 1.0, 4)[1].label, "0.25");
  // A step of 2 falls into this range once.
  EXPECT_GE(linear_ticks(-1.45, 1.9, 2).size(), 2u);
  for (int wanted = 1; wanted < 9; ++wanted) {
    EXPECT_GE(linear_ticks(0.9, 1.7, wanted).size(), 2u) << wanted;
  }
}

TEST(Ticks, OnALogarithmicAxisArePowersOfTen) {
  EXPECT_EQ(log_ticks(0.9, 11000.0).size(), 5u);
  EXPECT_EQ(log_ticks(1.0, 10.0).size(), 4u);
}

TEST(ScaleBar, HasARoundLengthBelowItsLimit) {
  EXPECT_DOUBLE_EQ(round_length_below(2.3), 2.0);
  EXPECT_DOUBLE_EQ(round_length_below(0.51), 0.5);
  EXPECT_DOUBLE_EQ(round_length_below(1.0), 1.0);
}

TEST(Canvas, SurvivesTextThatIsNoText) {
  Canvas canvas = Canvas::pixels(200, 60);
  canvas.text({10, 20}, "\xff\xfe\xc3 \xed\xa0\x80\n\t", {});
  canvas.text({10, 45}, "still writing", {});
  const auto image = canvas.take_image();
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_GT(inked_pixels(*image, {0, 34, 200, 26}), 100);
}

}  // namespace
}  // namespace sensotwin::render::testing
