// SPDX-License-Identifier: MIT
#include "render/phase_pictures.hpp"

#include <cmath>
#include <limits>

#include "made_up_run.hpp"
#include "picture_check.hpp"
#include "render/png_writer.hpp"

namespace sensotwin::render::testing {
namespace {

constexpr int kReadme_px = 1600;

/// Ten metres along x at 0.2 m/s, beside the ideal line.
PhaseRunView straight(double beside_m = 0.5) {
  PhaseRunView view;
  view.title = "Straight";
  view.scene = "straight";
  view.ideal_m = {{0.0, 0.0}, {10.0, 0.0}};
  view.tags = {{"A", {0.0, -2.0}, false}, {"B", {10.0, 2.0}, true}};
  for (int i = 0; i <= 1000; ++i) {
    view.driven.push_back({{0.01 * i, beside_m}, 0.05 * i});
    view.errors.push_back({0.05 * i, beside_m});
  }
  return view;
}

Rgba at(const PhasePicture& picture, const Vec2& p_W) {
  return color_at(picture.image, picture.pixel_from_W.pixel(p_W));
}

TEST(PhasePlan, ColoursTheDrivenPathByTime) {
  const auto picture = draw_phase_plan(straight(), kReadme_px);
  ASSERT_TRUE(picture);
  EXPECT_THAT(at(*picture, {0.5, 0.5}), ColorNear(time_color(0.05), 12));
  EXPECT_THAT(at(*picture, {9.5, 0.5}), ColorNear(time_color(0.95), 12));
}

TEST(PhasePlan, ColoursSegmentsInTurnWhenAskedTo) {
  PhaseRunView view = straight();
  view.segments = {{0.0, "→ A", true}, {25.0, "→ B", true}};
  view.coloring = PathColoring::kSegment;
  const auto picture = draw_phase_plan(view, kReadme_px);
  ASSERT_TRUE(picture);
  EXPECT_THAT(at(*picture, {2.5, 0.5}), ColorNear(turn_color(0), 12));
  EXPECT_THAT(at(*picture, {7.5, 0.5}), ColorNear(turn_color(1), 12));
}

TEST(PhasePlan, GreysTheApproachAndBeginsTheColoursAfterIt) {
  PhaseRunView view = straight();
  view.segments = {{0.0, "", false}, {25.0, "→ B", true}};
  const auto picture = draw_phase_plan(view, kReadme_px);
  ASSERT_TRUE(picture);
  EXPECT_THAT(at(*picture, {2.5, 0.5}), ColorNear(palette::kHairline, 8));
  EXPECT_THAT(at(*picture, {5.2, 0.5}), ColorNear(time_color(0.04), 12));
}

TEST(PhasePlan, MarksTagsAndShowsMissingOnesHollow) {
  const auto picture = draw_phase_plan(straight(), kReadme_px);
  ASSERT_TRUE(picture);
  EXPECT_THAT(at(*picture, {0.0, -2.0}), ColorNear(palette::kCeilingTag, 2));
  EXPECT_THAT(at(*picture, {10.0, 2.0}), ColorNear(palette::kPaper, 2));
}

TEST(PhasePlan, ShowsWhatStandsAboutAndWhoWalksWhereTheyCome) {
  PhaseRunView view = straight();
  FurnitureView box;
  box.outline_m = {{3.0, -1.5}, {4.0, -1.5}, {4.0, -1.0}, {3.0, -1.0}};
  FurnitureView table;
  table.kind = FurnitureKind::kLegs;
  table.circles = {{{6.0, -1.8}, 0.05}, {{7.0, -1.8}, 0.05}, {{7.0, -1.0}, 0.05}, {{6.0, -1.0}, 0.05}};
  view.furniture = {box, table};
  view.people = {{{{2.0, 1.5}, {9.0, 1.5}}, 0.22}};
  const auto picture = draw_phase_plan(view, kReadme_px);
  ASSERT_TRUE(picture);
  EXPECT_THAT(at(*picture, {3.5, -1.25}), ColorNear(palette::kFurniture, 2));
  const Rgba veiled = mix(palette::kPaper, palette::kFurniture, 110.0 / 255.0);
  EXPECT_THAT(at(*picture, {6.5, -1.3}), ColorNear(veiled, 3)) << "the robot drives between the legs";
  EXPECT_THAT(at(*picture, {7.0, -1.0}), ColorNear(palette::kFurnitureEdge, 8));
  EXPECT_THAT(at(*picture, {2.0, 1.5}), ColorNear(palette::kGreen, 2));
  EXPECT_THAT(at(*picture, {2.3, 1.7}), ColorNear(palette::kPaper, 2)) << "no larger than they are";
}

TEST(PhasePlan, DrawsTheLastEllipseTrueToScale) {
  PhaseRunView view = straight();
  Eigen::Matrix2d covariance;
  covariance << 0.09, 0.0, 0.0, 0.01;
  view.estimates = {{"A", {5.0, -1.0}, covariance, 10.0}};
  const auto picture = draw_phase_plan(view, kReadme_px);
  ASSERT_TRUE(picture);
  // Square root of the 95 % quantile of chi-squared with two degrees of freedom: 2.4477.
  EXPECT_THAT(at(*picture, {5.0 + 2.4477 * 0.3, -1.0}), ColorNear(palette::kCeilingTag, 60));
  EXPECT_THAT(at(*picture, {5.0, -1.0 + 2.4477 * 0.1}), ColorNear(palette::kCeilingTag, 60));
  const Rgba veiled = mix(palette::kPaper, palette::kCeilingTag, 38.0 / 255.0);
  EXPECT_THAT(at(*picture, {5.4, -1.02}), ColorNear(veiled, 3)) << "between middle and rim";
  EXPECT_THAT(at(*picture, {5.9, -1.13}), ColorNear(palette::kPaper, 0)) << "outside";
}

TEST(PhasePlan, HasAScaleBarAsLongAsItSays) {
  const auto picture = draw_phase_plan(made_up_hallway(), kReadme_px);
  ASSERT_TRUE(picture);
  const ScaleBar& bar = picture->scale_bar;
  const Vec2 one =
      picture->pixel_from_W.pixel(Vec2{bar.length_m, 0.0}) - picture->pixel_from_W.pixel(Vec2{0.0, 0.0});
  EXPECT_NEAR((bar.to_px - bar.from_px).norm(), one.norm(), 1e-9);
  EXPECT_THAT(color_at(picture->image, bar.from_px + Vec2{4.0, 0.0}), ColorNear(palette::kInk, 2));
}

TEST(PhasePlan, KeepsEverythingThatCountsInsideIt) {
  for (const PhaseRunView& view : {made_up_line(), made_up_star(), made_up_hallway(), made_up_hall()}) {
    const auto picture = draw_phase_plan(view, 800);
    ASSERT_TRUE(picture);
    for (const PhaseTagView& tag : view.tags) {
      const Vec2 px = picture->pixel_from_W.pixel(tag.at_m);
      EXPECT_TRUE(px.x() > picture->plan.x && px.x() < picture->plan.right() && px.y() > picture->plan.y &&
                  px.y() < picture->plan.bottom())
          << view.title << ", " << tag.name;
    }
  }
}

TEST(TrackingError, PutsTheErrorWhereItsAxesSay) {
  const auto picture = draw_tracking_error(straight(-0.05), kReadme_px);
  ASSERT_TRUE(picture);
  ASSERT_TRUE(picture->error);
  EXPECT_THAT(color_at(picture->image, picture->error->pixel({25.0, -5.0})), ColorNear(time_color(0.5), 12));
  EXPECT_THAT(color_at(picture->image, picture->error->pixel({25.0, -2.5})), ColorNear(palette::kPaper, 25));
}

TEST(TrackingError, ShadesPlusMinusTheRootMeanSquare) {
  PhaseRunView view = straight(0.10);
  view.rmse_m = 0.06;
  const auto picture = draw_tracking_error(view, kReadme_px);
  ASSERT_TRUE(picture);
  const auto color = [&](double cm) { return color_at(picture->image, picture->error->pixel({33.3, cm})); };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_NE(color(sign * 5.6), palette::kPaper);
    EXPECT_EQ(color(sign * 6.4), palette::kPaper);
  }
}

TEST(TrackingError, MarksWhereOneSegmentGivesWayToTheNext) {
  PhaseRunView view = straight(0.05);
  view.segments = {{0.0, "→ A", true}, {20.0, "→ B", true}};
  const auto with = draw_tracking_error(view, kReadme_px);
  view.segments[1].from_s = 30.0;
  const auto without = draw_tracking_error(view, kReadme_px);
  ASSERT_TRUE(with && without);
  const auto column = [](const PhasePicture& picture) {
    const double x = picture.error->pixel({20.0, 0.0}).x();
    return inked_pixels(picture.image, {x - 2.0, picture.error->plot.y + 60.0, 4.0, 300.0});
  };
  EXPECT_GT(column(*with), column(*without) + 100);
}

TEST(PhaseSheet, StandsChartBesideSquareScenesAndBelowWideOnes) {
  const auto star = draw_phase_sheet(made_up_star(), 800);
  const auto hallway = draw_phase_sheet(made_up_hallway(), 800);
  ASSERT_TRUE(star && hallway);
  EXPECT_GT(star->error->plot.x, star->plan.right());
  EXPECT_GT(hallway->error->plot.y, hallway->plan.bottom());
  for (const auto* picture : {&*star, &*hallway}) {
    EXPECT_LT(picture->error->plot.right(), picture->image.width_px());
    EXPECT_LT(picture->error->plot.bottom(), picture->image.height_px());
  }
}

TEST(PhaseSheet, StatesTheFiguresItWasGivenAndNoOthers) {
  PhaseRunView view = made_up_star();
  const auto all = draw_phase_sheet(view, 800);
  view.paper_rmse_m.reset();
  view.rmse_m.reset();
  const auto none = draw_phase_sheet(view, 800);
  ASSERT_TRUE(all && none);
  const RectPx row{all->error->plot.x - 30.0, 62.0, 300.0, 20.0};
  EXPECT_GT(inked_pixels(all->image, row), 500);
  EXPECT_EQ(inked_pixels(none->image, row), 0);
}

TEST(PhaseSheet, DrawsTheSameBytesTwice) {
  const auto bytes = [] { return *encode_png(draw_phase_sheet(made_up_hallway(), 800)->image, {}); };
  EXPECT_EQ(bytes(), bytes());
}

TEST(PhaseSheet, DrawsAnEmptyRunAndOnePoint) {
  EXPECT_TRUE(draw_phase_sheet({}, 800));
  PhaseRunView view;
  view.driven = {{{1.0, 2.0}, 3.0}};
  view.errors = {{3.0, 0.0}};
  view.segments = {{0.0, "", false}};
  EXPECT_TRUE(draw_phase_sheet(view, 800));
  EXPECT_TRUE(draw_tracking_error(view, 800));
}

TEST(PhaseSheet, RefusesWhatIsNoNumberAndNamesIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::pair<PhaseRunView, std::string>> broken(6, {made_up_star(), ""});
  broken[0].first.errors[3].error_m = nan;
  broken[0].second = "error 3";
  broken[1].first.estimates[2].covariance_m2(0, 1) = nan;
  broken[1].second = "covariance of estimate 2";
  broken[2].first.tags[1].at_m.x() = 1e9;
  broken[2].second = "tag 1";
  broken[3].first.rmse_m = -1.0;
  broken[3].second = "root mean square";
  broken[4].first.driven[9].t_s = nan;
  broken[4].second = "trajectory point 9";
  broken[5].first.segments[1].from_s = nan;
  broken[5].second = "segment 1";
  for (const auto& [view, what] : broken) {
    const auto picture = draw_phase_sheet(view, 800);
    ASSERT_FALSE(picture) << what;
    EXPECT_EQ(picture.error().kind, RenderError::Kind::kBadView);
    EXPECT_THAT(picture.error().message, ::testing::HasSubstr(what));
  }
  EXPECT_FALSE(draw_phase_sheet(made_up_star(), 10));
}

TEST(EstimatesSheet, DrawsEveryPanelAtTheScaleOfItsBar) {
  const auto picture = draw_estimates_sheet(made_up_hallway(), kReadme_px);
  ASSERT_TRUE(picture);
  const ScaleBar& bar = picture->scale_bar;
  EXPECT_NEAR((bar.to_px - bar.from_px).norm(), bar.length_m * picture->pixel_from_W.px_per_m(Vec3::Zero()),
              1e-6);
  // The last panel is the last tag's: its last estimate is a dark dot.
  const PhaseRunView view = made_up_hallway();
  const auto last = std::find_if(view.estimates.rbegin(), view.estimates.rend(),
                                 [](const TagEstimateView& e) { return e.name == "T7"; });
  ASSERT_NE(last, view.estimates.rend());
  EXPECT_THAT(at(*picture, last->at_m), ColorNear(palette::kInk, 2));
}

TEST(EstimatesSheet, RefusesNoEstimatesAndTooManyTags) {
  PhaseRunView view = made_up_hallway();
  view.estimates.clear();
  EXPECT_FALSE(draw_estimates_sheet(view));
  for (int i = 0; i < 61; ++i) {
    view.tags.push_back({"X" + std::to_string(i), {0.0, 0.0}, false});
    view.estimates.push_back({view.tags.back().name, {0.0, 0.0}, Eigen::Matrix2d::Identity(), 0.0});
  }
  EXPECT_FALSE(draw_estimates_sheet(view));
  view.estimates.pop_back();
  EXPECT_TRUE(draw_estimates_sheet(view));
}

}  // namespace
}  // namespace sensotwin::render::testing
