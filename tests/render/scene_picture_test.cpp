// SPDX-License-Identifier: MIT
#include "render/scene_picture.hpp"

#include <cmath>
#include <limits>

#include "made_up_house.hpp"
#include "picture_check.hpp"
#include "render/png_writer.hpp"

namespace sensotwin::render::testing {
namespace {

// Half the size of a README picture: quick, and lines are still wider than a pixel.
constexpr PictureOptions kSmall{.width_px = 800};

class TopView : public PictureTest {
 protected:
  [[nodiscard]] Picture drawn(const SceneView& view, const PictureOptions& options = kSmall) {
    auto picture = draw_top_view(gl(), view, options);
    EXPECT_TRUE(picture) << picture.error().message;
    keep(picture ? picture->image : Image{});
    return picture ? *picture : Picture{};
  }
  [[nodiscard]] static Rgba at(const Picture& picture, const Vec2& p_W) {
    return color_at(picture.image, picture.pixel_from_W.pixel(p_W));
  }
};
using ObliqueView = TopView;

TEST_F(TopView, ColoursEveryTileByItsState) {
  SceneView view;
  const std::array states{TileState::kUnvisited,   TileState::kGrey,   TileState::kBlack, TileState::kBlocked,
                          TileState::kUnreachable, TileState::kMissed, TileState::kWrong};
  for (std::size_t i = 0; i < states.size(); ++i) {
    view.tiles.push_back({{static_cast<double>(i), 0.0}, 1.0, 0.0, states[i], ""});
  }
  const Picture picture = drawn(view);
  for (std::size_t i = 0; i < states.size(); ++i) {
    // Between the marks of all states: left of the middle, a little up.
    const Vec2 probe{static_cast<double>(i) - 0.3, 0.04};
    EXPECT_THAT(at(picture, probe), ColorNear(tile_color(states[i]), 2)) << "tile " << i;
  }
}

TEST_F(TopView, ShowsWallsFurnitureAndRobotWhereTheyAre) {
  SceneView view = made_up_house(0.5);
  view.trajectory.clear();
  view.robot = RobotView{{{6.0, 1.0}, 0.0}, 0.17, 0.092};
  const Picture picture = drawn(view);
  EXPECT_THAT(at(picture, {4.0, 0.0}), ColorNear(palette::kWall, 2));
  EXPECT_THAT(at(picture, {6.5, 0.85}), ColorNear(palette::kFurniture, 2)) << "sofa, away from its name";
  EXPECT_THAT(at(picture, {6.0 + 0.03, 1.0}), ColorNear(palette::kOrange, 2)) << "arrow of the robot";
  EXPECT_THAT(at(picture, {6.0 - 0.11, 1.0}), ColorNear(palette::kRobot, 2));
  EXPECT_THAT(at(picture, {7.0, 7.0}), ColorNear(palette::kPaper, 0)) << "outside the house";
}

/// A room as a map's cells give it: every side a cell long, with free space on its left; and a block within,
/// the other way round.
SceneView traced_room() {
  SceneView view;
  const auto walked = [](std::vector<Vec2> corners) {
    constexpr int kCells = 40;
    WallView wall;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2& from = corners[i];
      const Vec2 along = corners[(i + 1) % corners.size()] - from;
      for (int k = 0; k < kCells; ++k) {
        wall.points_m.push_back(from + along * (static_cast<double>(k) / kCells));
      }
    }
    return wall;
  };
  view.walls.push_back(walked({{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
  view.walls.push_back(walked({{2.2, 1}, {2.2, 2}, {3.2, 2}, {3.2, 1}}));
  view.tiles.push_back({{2.3, 1.5}, 0.5, 0.0, TileState::kBlocked, ""});
  return view;
}

TEST_F(TopView, FillsWhatTheWallsOfAMapEncloseOverTheCarpet) {
  const Picture picture = drawn(traced_room());
  EXPECT_THAT(at(picture, {2.4, 1.6}), ColorNear(palette::kMasonry, 2));
  EXPECT_THAT(at(picture, {1.0, 1.0}), ColorNear(palette::kFloor, 2));
}

TEST_F(ObliqueView, CutsAllWallsOfAMapSoThatItsRoomsCanBeSeen) {
  SceneView view = traced_room();
  view.walls.pop_back();
  auto oblique = draw_oblique_view(gl(), view, kSmall);
  ASSERT_TRUE(oblique);
  const Picture& picture = *oblique;
  // In front of a wall of full height this spot at the back would be its face.
  EXPECT_THAT(at(picture, {2.0, 2.6}), ColorNear(palette::kFloor, 2));
  EXPECT_THAT(at(picture, {2.0, 0.2}), ColorNear(palette::kFloor, 2));
}

TEST_F(TopView, MarksTagsLightOnDarkTilesAndDarkOnLightOnes) {
  SceneView view;
  view.tiles = {{{0.0, 0.0}, 0.5, 0.0, TileState::kBlack, ""},
                {{0.5, 0.0}, 0.5, 0.0, TileState::kUnvisited, ""}};
  view.tags = {{{0.0, 0.0}, false}, {{0.5, 0.0}, false}};
  const Picture picture = drawn(view, {});
  EXPECT_THAT(at(picture, {0.0, 0.0}), ColorNear(palette::kHairline, 12));
  EXPECT_THAT(at(picture, {0.5, 0.0}), ColorNear(palette::kSoftInk, 12));
}

TEST_F(TopView, ColoursThePathByTime) {
  SceneView view;
  view.tiles.push_back({{2.0, 0.0}, 4.0, 0.0, TileState::kBlack, ""});
  for (int i = 0; i <= 400; ++i) {
    view.trajectory.push_back({{i * 0.01, 0.0}, i * 1.0});
  }
  // At full size, where the line is wider than its anti-aliased rim.
  const Picture picture = drawn(view, {});
  // A step of a hundredth of the scale is below 12 of 255.
  EXPECT_THAT(at(picture, {0.2, 0.0}), ColorNear(time_color(0.05), 12));
  EXPECT_THAT(at(picture, {2.0, 0.0}), ColorNear(time_color(0.5), 12));
  EXPECT_THAT(at(picture, {3.8, 0.0}), ColorNear(time_color(0.95), 12));
}

TEST_F(TopView, KeepsTheAspectAndFitsEverything) {
  const SceneView view = made_up_house();
  for (const auto& [width, height] : {std::pair{800, 0}, std::pair{1200, 400}, std::pair{400, 900}}) {
    const Picture picture = drawn(view, {width, height, TileStyle::kStates});
    const Projection& X = picture.pixel_from_W;
    const Vec2 unit_x = X.pixel(Vec2{1, 0}) - X.pixel(Vec2{0, 0});
    const Vec2 unit_y = X.pixel(Vec2{0, 1}) - X.pixel(Vec2{0, 0});
    EXPECT_NEAR(unit_x.x(), -unit_y.y(), 1e-9);
    for (const Vec2& corner : outline_of(view)) {
      const Vec2 px = X.pixel(corner);
      EXPECT_GE(px.x(), picture.plot.x);
      EXPECT_LE(px.x(), picture.plot.right());
      EXPECT_GE(px.y(), picture.plot.y);
      EXPECT_LE(px.y(), picture.plot.bottom());
    }
  }
}

TEST_F(TopView, HasAScaleBarAsLongAsItSays) {
  const Picture picture = drawn(made_up_house(0.0));
  const ScaleBar& bar = picture.scale_bar;
  EXPECT_DOUBLE_EQ(bar.length_m, 2.0);
  EXPECT_NEAR(
      (bar.to_px - bar.from_px).norm(),
      (picture.pixel_from_W.pixel(Vec2{bar.length_m, 0}) - picture.pixel_from_W.pixel(Vec2{0, 0})).norm(),
      1e-9);
  const int y = static_cast<int>(bar.from_px.y());
  int inked = 0;
  const int middle = static_cast<int>((bar.from_px.x() + bar.to_px.x()) / 2.0);
  for (int x = 0; x < middle; ++x) {
    inked += picture.image.at(x, y) == palette::kInk ? 1 : 0;
  }
  // Its dark half, one pixel of anti-aliasing on either side.
  EXPECT_NEAR(inked, (bar.to_px - bar.from_px).norm() / 2.0, 2.0);
}

TEST_F(TopView, WritesTitleSceneAndLegend) {
  const Picture picture = drawn(made_up_house());
  EXPECT_GT(inked_pixels(picture.image, {20, 10, 500, 30}), 1000) << "title";
  EXPECT_GT(inked_pixels(picture.image, {20, 38, 500, 20}), 300) << "scene and seed";
  EXPECT_GT(inked_pixels(picture.image, {picture.plot.right() + 20, picture.plot.y, 160, 200}), 1500)
      << "legend";
}

TEST_F(TopView, DrawsTheSameBytesTwice) {
  const auto bytes = [&] { return *encode_png(drawn(house_with_everything()).image, {}); };
  EXPECT_EQ(bytes(), bytes());
}

TEST_F(TopView, DrawsNothingAtAllAndASinglePoint) {
  SceneView view;
  EXPECT_EQ(drawn(view).image.width_px(), 800);
  view.trajectory.push_back({{3.0, 4.0}, 0.0});
  const Picture picture = drawn(view);
  EXPECT_NEAR(picture.pixel_from_W.pixel(Vec2{3.0, 4.0}).x(), picture.plot.center().x(), 1e-9);
  view.walls.push_back({{}, true});
  view.walls.push_back({{{3.0, 4.0}}, true});
  view.furniture.push_back({});
  EXPECT_EQ(drawn(view).image.width_px(), 800);
}

TEST_F(TopView, DrawsAHundredThousandPoints) {
  SceneView view;
  for (int i = 0; i < 100'000; ++i) {
    const double angle = i * 0.001;
    view.trajectory.push_back({{angle * std::cos(angle), angle * std::sin(angle)}, i * 0.015});
  }
  EXPECT_GT(inked_pixels(drawn(view).image, {0, 0, 600, 600}), 10'000);
}

TEST_F(TopView, RefusesWhatIsNoNumberAndNamesIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<std::pair<SceneView, std::string>> broken(6, {made_up_house(), ""});
  broken[0].first.walls[1].points_m[1].x() = nan;
  broken[0].second = "wall 1";
  broken[1].first.furniture[2].circles[0].radius_m = -0.1;
  broken[1].second = "furniture 2";
  broken[2].first.tiles[4].size_m = inf;
  broken[2].second = "tile 4";
  broken[3].first.trajectory[17].t_s = nan;
  broken[3].second = "trajectory point 17";
  broken[4].first.robot->X_WR.yaw_rad = nan;
  broken[4].second = "robot";
  broken[5].first.ceiling_m = 1e9;
  broken[5].second = "ceiling";
  for (const auto& [view, what] : broken) {
    for (const auto& picture : {draw_top_view(gl(), view, kSmall), draw_oblique_view(gl(), view, kSmall)}) {
      ASSERT_FALSE(picture) << what;
      EXPECT_EQ(picture.error().kind, RenderError::Kind::kBadView);
      EXPECT_THAT(picture.error().message, ::testing::HasSubstr(what));
    }
  }
}

TEST_F(TopView, RefusesSizesThatNobodyCouldRead) {
  for (const PictureOptions& options :
       {PictureOptions{10, 0}, PictureOptions{800, 20}, PictureOptions{90'000, 0}}) {
    EXPECT_FALSE(draw_top_view(gl(), made_up_house(), options));
  }
}

TEST_F(ObliqueView, ShowsFurnitureTopsAtTheirHeight) {
  auto picture = draw_oblique_view(gl(), made_up_house(0.5), kSmall);
  ASSERT_TRUE(picture);
  keep(picture->image);
  const Projection& X = picture->pixel_from_W;
  // The end of the sofa's seat, away from its name.
  EXPECT_THAT(color_at(picture->image, X.pixel(Vec3{6.7, 0.9, 0.72})), ColorNear(palette::kFurniture, 2));
  EXPECT_THAT(color_at(picture->image, X.pixel(Vec3{1.3, 6.3, 0.74})), ColorNear(palette::kFurniture, 2))
      << "corner of the table top";
}

TEST_F(ObliqueView, HidesTheFloorBehindABookcaseAndNotInFrontOfIt) {
  SceneView view = made_up_house(0.0);
  view.robot.reset();
  auto picture = draw_oblique_view(gl(), view, kSmall);
  ASSERT_TRUE(picture);
  keep(picture->image);
  const Projection& X = picture->pixel_from_W;
  const Rgba behind = color_at(picture->image, X.pixel(Vec3{4.0, 3.25, 0.0}));
  EXPECT_GT(behind.r, behind.b + 30) << "wood is redder than any tile";
  EXPECT_THAT(color_at(picture->image, X.pixel(Vec3{3.39, 1.87, 0.0})),
              ColorNear(palette::kTileUnvisited, 2));
}

TEST_F(ObliqueView, CutsTheWallsInFront) {
  SceneView view = made_up_house(0.0);
  auto picture = draw_oblique_view(gl(), view, kSmall);
  ASSERT_TRUE(picture);
  keep(picture->image);
  const Projection& X = picture->pixel_from_W;
  // A tile beside the near wall would be behind that wall, were it not cut.
  EXPECT_THAT(color_at(picture->image, X.pixel(Vec3{4.4, 0.85, 0.0})), ColorNear(palette::kTileUnvisited, 2));
  // High on the far wall there is wall, not paper.
  const Rgba wall = color_at(picture->image, X.pixel(Vec3{2.0, 7.8, 2.0}));
  EXPECT_LT(luminance(wall), 0.75);
}

TEST_F(ObliqueView, DrawsTheSameBytesTwiceAndEmptyRoomsToo) {
  const auto a = draw_oblique_view(gl(), house_with_everything(), kSmall);
  const auto b = draw_oblique_view(gl(), house_with_everything(), kSmall);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->image, b->image);
  EXPECT_TRUE(draw_oblique_view(gl(), SceneView{}, kSmall));
}

}  // namespace
}  // namespace sensotwin::render::testing
