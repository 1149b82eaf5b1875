// SPDX-License-Identifier: MIT
#include "render/mapping_pictures.hpp"

#include "made_up_house.hpp"
#include "picture_check.hpp"

namespace sensotwin::render::testing {
namespace {

class ProgressSheetPicture : public PictureTest {};
class RecoveredPlan : public PictureTest {};

TEST(TagsOverTime, UsesThePapersColoursAndOursBlue) {
  const LineChart chart = tags_over_time_chart(made_up_runs());
  ASSERT_EQ(chart.series.size(), 4u);
  EXPECT_EQ(chart.series[0].color, palette::kPink);
  EXPECT_EQ(chart.series[1].color, palette::kGreen);
  EXPECT_EQ(chart.series[2].color, palette::kBrown);
  EXPECT_EQ(chart.series[3].color, palette::kBlue);
}

// SensoBot, section V: BFM "about 69 minutes", DFM "about 42 minutes", IDFM "about 26 minutes".
TEST(TagsOverTime, MarksThePapersMinutesHollow) {
  const auto chart = draw(tags_over_time_chart(made_up_runs()));
  ASSERT_TRUE(chart);
  for (const auto& [minutes, color] : {std::pair{26.0, palette::kBrown}, std::pair{42.0, palette::kGreen}}) {
    const Vec2 at = chart->pixel({minutes, 207.0});
    EXPECT_THAT(color_at(chart->image, at), ColorNear(palette::kPaper, 0));
    EXPECT_THAT(color_at(chart->image, at + Vec2{10.0, 0.0}), ColorNear(color, 40));
  }
}

TEST(TagsOverTime, DrawsNoRunsAndARunWithoutTags) {
  TagsOverTime view;
  EXPECT_TRUE(draw(tags_over_time_chart(view)));
  view.runs.push_back({"idfm", {}});
  EXPECT_TRUE(draw(tags_over_time_chart(view)));
}

TEST_F(ProgressSheetPicture, ShowsEachPlanAtItsTime) {
  ProgressSheet sheet{"Growth", "", "made-up-house", 7, {}, 900};
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    SceneView plan = made_up_house(share);
    plan.trajectory.clear();
    sheet.frames.push_back({share * 1560.0, plan});
  }
  const auto picture = draw_progress_sheet(gl(), sheet);
  ASSERT_TRUE(picture) << picture.error().message;
  keep(picture->image);
  // The sheet tells where its last plan is.
  const Vec2 last = picture->pixel_from_W.pixel(sheet.frames[5].plan.tiles[100].center_m);
  EXPECT_THAT(color_at(picture->image, last), ColorNear(palette::kTileBlack, 2));
  EXPECT_EQ(sheet.frames[5].plan.tiles[100].state, TileState::kBlack);
}

TEST_F(ProgressSheetPicture, RefusesNoFrameAndTooMany) {
  ProgressSheet sheet{"Growth", "", "made-up-house", 7, {}, 900};
  EXPECT_FALSE(draw_progress_sheet(gl(), sheet));
  sheet.frames.resize(25);
  EXPECT_FALSE(draw_progress_sheet(gl(), sheet));
}

TEST_F(RecoveredPlan, LetsTheTrueRoomShineThrough) {
  SceneView view;
  view.walls.push_back({{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, true});
  view.furniture.push_back(
      {"", FurnitureKind::kSolid, {{1.0, 0.5}, {2, 0.5}, {2, 1.5}, {1.0, 1.5}}, {}, 0.7, 0.0});
  view.tiles.push_back({{0.5, 1.0}, 1.0, 0.0, TileState::kBlack, ""});
  view.tiles.push_back({{1.5, 1.0}, 1.0, 0.0, TileState::kBlack, ""});
  const auto picture = draw_recovered_plan(gl(), view, 800);
  ASSERT_TRUE(picture);
  keep(picture->image);
  const auto at = [&](double x, double y) {
    return color_at(picture->image, picture->pixel_from_W.pixel(Vec2{x, y}));
  };
  const Rgba veil = fill_of(TileState::kBlack, TileStyle::kRecovered);
  const double share = veil.a / 255.0;
  EXPECT_THAT(at(0.5, 1.0), ColorNear(mix(palette::kFloor, veil.with_alpha(255), share), 3));
  EXPECT_THAT(at(1.5, 1.0), ColorNear(mix(palette::kFurniture, veil.with_alpha(255), share), 3));
  EXPECT_THAT(at(2.5, 1.0), ColorNear(palette::kFloor, 2));
}

}  // namespace
}  // namespace sensotwin::render::testing
