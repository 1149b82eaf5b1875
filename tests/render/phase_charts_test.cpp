// SPDX-License-Identifier: MIT
#include "render/phase_charts.hpp"

#include <limits>

#include "made_up_run.hpp"
#include "picture_check.hpp"
#include "render/label_placer.hpp"
#include "render/plane_geometry.hpp"
#include "render/png_writer.hpp"

namespace sensotwin::render::testing {
namespace {

TEST(NoisePicture, PutsDeviationsWhereTheAxesSay) {
  NoiseView view;
  view.measured = {{"antenna 1", {{4.0, 0.1, {}}, {6.0, 0.2, {}}}}};
  const auto picture = draw_noise(view);
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->panels.size(), 1u) << "no reads, no upper panel";
  const Panel& panel = picture->panels[0];
  EXPECT_THAT(color_at(picture->image, panel.pixel({4.0, 0.1})), ColorNear(palette::kBlue, 2));
  EXPECT_THAT(color_at(picture->image, panel.pixel({6.0, 0.2})), ColorNear(palette::kBlue, 2));
  EXPECT_THAT(color_at(picture->image, panel.pixel({5.0, 0.172})), ColorNear(palette::kPaper, 0));
}

TEST(NoisePicture, DrawsTheLawThroughItsPointsAndTwiceAsWideOverTheReads) {
  NoiseView view;
  view.reads = {{1.0, 0.5}, {9.0, -0.5}};
  view.laws = {{"0.024 rad/m", {{0.0, 0.0}, {10.0, 0.24}}}};
  const auto picture = draw_noise(view);
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->panels.size(), 2u);
  EXPECT_THAT(color_at(picture->image, picture->panels[1].pixel({5.0, 0.12})), ColorNear(palette::kInk, 30));
  EXPECT_THAT(color_at(picture->image, picture->panels[0].pixel({5.0, 0.24})), ColorNear(palette::kInk, 60));
  EXPECT_THAT(color_at(picture->image, picture->panels[0].pixel({5.0, -0.24})), ColorNear(palette::kInk, 60));
  EXPECT_THAT(color_at(picture->image, picture->panels[0].pixel({5.0, 0.35})), ColorNear(palette::kPaper, 0));
}

TEST(NoisePicture, ReadsNegativeAxesAsSignalStrengthHasThem) {
  NoiseView view;
  view.x_label = "RSSI (dBm)";
  view.measured = {{"antenna 1", {{-72.0, 0.4, ChartRange{0.3, 0.5}}, {-50.0, 0.03, {}}}}};
  const auto picture = draw_noise(view);
  ASSERT_TRUE(picture);
  const Panel& panel = picture->panels[0];
  EXPECT_LT(panel.x.range->low, -72.0);
  EXPECT_GT(panel.x.range->high, -50.0);
  EXPECT_THAT(color_at(picture->image, panel.pixel({-72.0, 0.48})), ColorNear(palette::kBlue, 90))
      << "its bar";
}

TEST(NoisePicture, RefusesWhatIsNoNumberAndDrawsNothingAtAll) {
  NoiseView view = made_up_noise();
  view.reads[7].y = std::numeric_limits<double>::infinity();
  const auto picture = draw_noise(view);
  ASSERT_FALSE(picture);
  EXPECT_THAT(picture.error().message, ::testing::HasSubstr("read 7"));
  EXPECT_TRUE(draw_noise({}));
  EXPECT_FALSE(draw_noise({}, 9));
}

TEST(ControllerPicture, GivesSetsOfOneRuleOneColour) {
  const auto picture = draw_controller(made_up_controller());
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->panels.size(), 3u);
  // Inside Neg and inside CCW, away from other sets: the same veil.
  const Rgba neg = color_at(picture->image, picture->panels[0].pixel({-2.0, 0.7}));
  const Rgba ccw = color_at(picture->image, picture->panels[1].pixel({1.4, 0.6}));
  const Rgba pos = color_at(picture->image, picture->panels[0].pixel({2.0, 0.7}));
  EXPECT_NE(neg, palette::kPaper);
  EXPECT_THAT(ccw, ColorNear(neg, 1));
  EXPECT_NE(pos, neg);
}

TEST(ControllerPicture, DrawsTheControlCurveThroughItsPoints) {
  const auto picture = draw_controller(made_up_controller());
  ASSERT_TRUE(picture);
  const Panel& panel = picture->panels[2];
  EXPECT_THAT(color_at(picture->image, panel.pixel({-2.0, 1.1})), ColorNear(palette::kInk, 2));
  EXPECT_THAT(color_at(picture->image, panel.pixel({2.0, -1.1})), ColorNear(palette::kInk, 2));
  EXPECT_THAT(color_at(picture->image, panel.pixel({2.0, 1.4})), ColorNear(palette::kPaper, 0));
}

TEST(ControllerPicture, DrawsTheSameBytesTwiceAndNothingAtAll) {
  const auto bytes = [] { return *encode_png(draw_controller(made_up_controller(), 800)->image, {}); };
  EXPECT_EQ(bytes(), bytes());
  EXPECT_TRUE(draw_controller({}, 800));
  FuzzyControllerView broken = made_up_controller();
  broken.inputs[1].corners[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(draw_controller(broken));
}

TEST(Ellipse, HoldsNinetyFivePercentAlongTheAxesOfTheCovariance) {
  // 4 and 1 square metres, the long axis turned by 30 degrees.
  const double yaw = robot::rad_from_deg(30.0);
  Eigen::Matrix2d turn;
  turn << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);
  const Ellipse ellipse = ellipse_of(turn * Eigen::Vector2d(4.0, 1.0).asDiagonal() * turn.transpose());
  EXPECT_NEAR(ellipse.major_m, 2.0 * 2.4477, 1e-3);
  EXPECT_NEAR(ellipse.minor_m, 2.4477, 1e-3);
  EXPECT_NEAR(std::remainder(ellipse.yaw_rad - yaw, robot::kPi), 0.0, 1e-9);
}

TEST(Ellipse, IsFlatWhereRoundingMadeAVarianceNegative) {
  Eigen::Matrix2d covariance;
  covariance << 1.0, 0.0, 0.0, -1e-18;
  EXPECT_DOUBLE_EQ(ellipse_of(covariance).minor_m, 0.0);
}

TEST(LabelPlacer, NeverLaysOneNameOnAnotherOrOnAMark) {
  // Forty marks so close that every second name must step away.
  LabelPlacer placer({0.0, 0.0, 800.0, 600.0});
  std::vector<Vec2> marks;
  for (int i = 0; i < 40; ++i) {
    marks.emplace_back(150.0 + 55.0 * (i % 8), 200.0 + 45.0 * std::floor(i / 8.0));
    placer.keep_clear({marks.back().x() - 6.0, marks.back().y() - 6.0, 12.0, 12.0});
  }
  std::vector<RectPx> boxes;
  for (const Vec2& mark : marks) {
    boxes.push_back(placer.place(mark, 9.0, {40.0, 18.0}).box);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(boxes[i].overlaps(boxes[k])) << i << " and " << k;
    }
    for (const Vec2& mark : marks) {
      EXPECT_FALSE(boxes[i].overlaps({mark.x() - 6.0, mark.y() - 6.0, 12.0, 12.0})) << i;
    }
  }
}

TEST(LabelPlacer, StepsAsideFromALineAndStaysInside) {
  LabelPlacer placer({0.0, 0.0, 200.0, 100.0});
  placer.avoid(std::array{Vec2{0.0, 50.0}, Vec2{200.0, 50.0}});
  const auto aside = placer.place({100.0, 50.0}, 8.0, {40.0, 16.0});
  EXPECT_TRUE(aside.box.bottom() < 50.0 || aside.box.y > 50.0);
  const auto corner = placer.place({196.0, 4.0}, 8.0, {40.0, 16.0});
  EXPECT_LE(corner.box.right(), 200.0);
  EXPECT_GE(corner.box.y, 0.0);
}

class CeilingView : public PictureTest {};

TEST_F(CeilingView, ShowsTheIdealPathTheAntennasAndTheRays) {
  const SceneView whole = made_up_ceiling();
  const auto drawn = draw_oblique_view(gl(), whole, {.width_px = 800});
  ASSERT_TRUE(drawn);
  keep(drawn->image);
  const auto without = [&](const auto& take_away) {
    SceneView view = whole;
    take_away(view);
    const auto other = draw_oblique_view(gl(), view, {.width_px = 800});
    // The legend loses its line as well: count the plot alone.
    int pixels = 0;
    for (int y = 0; y < drawn->image.height_px(); ++y) {
      for (int x = 0; x < static_cast<int>(drawn->plot.right()); ++x) {
        pixels += other->image.at(x, y) == drawn->image.at(x, y) ? 0 : 1;
      }
    }
    return pixels;
  };
  EXPECT_GT(without([](SceneView& view) { view.ideal_path_m.clear(); }), 300);
  EXPECT_GT(without([](SceneView& view) { view.robot->antennas.clear(); }), 100);
  EXPECT_GT(without([](SceneView& view) { view.target_tag.reset(); }), 100);
  EXPECT_GT(without([](SceneView& view) { view.estimates.clear(); }), 300);
}

TEST_F(CeilingView, HangsTagsAtTheirHeightAboveTheirProjections) {
  SceneView view = made_up_ceiling();
  view.estimates.clear();
  const auto picture = draw_oblique_view(gl(), view, {});
  ASSERT_TRUE(picture);
  keep(picture->image);
  const Vec2 p = view.ceiling_tags[4].at_m;
  EXPECT_THAT(color_at(picture->image, picture->pixel_from_W.pixel(Vec3{p.x(), p.y(), 3.0})),
              ColorNear(palette::kCeilingTag, 12));
}

TEST_F(CeilingView, LaysAFloorUnderAViewWithoutRoom) {
  SceneView view;
  view.ceiling_tags = {{{0.0, 0.0}, 3.0, "A"}, {{4.0, 3.0}, 3.0, "B"}};
  view.ideal_path_m = {{0.0, 0.0}, {4.0, 3.0}};
  const auto picture = draw_oblique_view(gl(), view, {.width_px = 800});
  ASSERT_TRUE(picture);
  keep(picture->image);
  EXPECT_THAT(color_at(picture->image, picture->pixel_from_W.pixel(Vec2{3.3, 0.4})),
              ColorNear(palette::kFloor, 2));
}

TEST_F(CeilingView, RefusesNumbersThatCannotBeDrawn) {
  SceneView view = made_up_ceiling();
  view.robot->antennas[1].at_m.x() = std::numeric_limits<double>::quiet_NaN();
  const auto picture = draw_oblique_view(gl(), view, {.width_px = 800});
  ASSERT_FALSE(picture);
  EXPECT_THAT(picture.error().message, ::testing::HasSubstr("antenna 1"));
  view = made_up_ceiling();
  view.estimates[2].ellipse.minor_m = -1.0;
  EXPECT_FALSE(draw_top_view(gl(), view, {.width_px = 800}));
}

}  // namespace
}  // namespace sensotwin::render::testing
