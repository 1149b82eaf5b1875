// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "picture_check.hpp"
#include "render/charts.hpp"

namespace sensotwin::render::testing {
namespace {

[[nodiscard]] LineChart one_line() {
  LineChart chart;
  chart.frame = {
      "Title", "subtitle", {"time (s)", false, ChartRange{0, 10}}, {"value (m)", false, ChartRange{0, 4}},
      800,     500};
  chart.series.push_back(
      {"line", palette::kBlue, {{0, 1}, {5, 3}, {10, 3}}, SeriesStyle::kLine, 6.0, false, ""});
  return chart;
}

TEST(LineChart, PutsDataWhereItsAxesSay) {
  const auto chart = draw(one_line());
  ASSERT_TRUE(chart) << chart.error().message;
  EXPECT_THAT(color_at(chart->image, chart->pixel({2.5, 2.0})), ColorNear(palette::kBlue, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({7.5, 3.0})), ColorNear(palette::kBlue, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({7.5, 1.5})), ColorNear(palette::kPaper, 0));
  EXPECT_NEAR(chart->pixel({0, 0}).x(), chart->plot.x, 1e-9);
  EXPECT_NEAR(chart->pixel({10, 4}).y(), chart->plot.y, 1e-9);
}

TEST(LineChart, HoldsItsValueInStepStyle) {
  LineChart view = one_line();
  view.series[0].style = SeriesStyle::kStep;
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  EXPECT_THAT(color_at(chart->image, chart->pixel({4.5, 1.0})), ColorNear(palette::kBlue, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({2.5, 2.2})), ColorNear(palette::kPaper, 0));
}

TEST(LineChart, SpreadsDecadesEvenlyOnALogarithmicAxis) {
  LineChart view = one_line();
  view.frame.x = {"n", true, {}};
  view.series[0].points = {{1, 1}, {10, 2}, {100, 3}};
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  const double first = chart->pixel({10, 0}).x() - chart->pixel({1, 0}).x();
  const double second = chart->pixel({100, 0}).x() - chart->pixel({10, 0}).x();
  EXPECT_NEAR(first, second, 1e-9);
}

TEST(LineChart, DrawsReferencesHollow) {
  LineChart view = one_line();
  view.series.clear();
  view.frame.width_px = 1600;
  view.frame.height_px = 1000;
  view.reference_points.push_back({{5, 2}, palette::kGreen, ""});
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  const Vec2 at = chart->pixel({5, 2});
  EXPECT_THAT(color_at(chart->image, at), ColorNear(palette::kPaper, 0));
  EXPECT_THAT(color_at(chart->image, at + Vec2{10.0, 0.0}), ColorNear(palette::kGreen, 40));
}

TEST(LineChart, WritesItsTitle) {
  const auto chart = draw(one_line());
  ASSERT_TRUE(chart);
  EXPECT_GT(inked_pixels(chart->image, {20, 10, 200, 30}), 150);
}

TEST(LineChart, RefusesWhatHasNoPlaceAndNamesTheSeries) {
  LineChart nan = one_line();
  nan.series[0].points[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(draw(nan).error().message, ::testing::HasSubstr("series line"));
  LineChart log = one_line();
  log.frame.y = {"y", true, {}};
  log.series[0].points[1].y = 0.0;
  EXPECT_THAT(draw(log).error().message, ::testing::HasSubstr("logarithmic"));
  LineChart flat = one_line();
  flat.frame.x.range = ChartRange{3, 3};
  EXPECT_FALSE(draw(flat));
}

TEST(LineChart, DrawsNoSeriesOnePointAndAHundredThousand) {
  LineChart view = one_line();
  view.frame.x.range.reset();
  view.frame.y.range.reset();
  view.series[0].points.clear();
  EXPECT_TRUE(draw(view));
  view.series[0].points = {{3, 3}};
  const auto single = draw(view);
  ASSERT_TRUE(single);
  EXPECT_THAT(color_at(single->image, single->pixel({3, 3})), ColorNear(palette::kBlue, 2));
  view.series[0].points.clear();
  for (int i = 0; i < 100'000; ++i) {
    view.series[0].points.push_back({i * 1.0, std::sin(i * 0.1)});
  }
  const auto dense = draw(view);
  ASSERT_TRUE(dense);
  EXPECT_THAT(color_at(dense->image, dense->pixel({50'000, 0.0})), ColorNear(palette::kBlue, 30));
}

TEST(LineChart, GivesTheSameBytesTwiceAsPixelsAndAsSvg) {
  EXPECT_EQ(draw(one_line())->image, draw(one_line())->image);
  const auto a = draw_svg(one_line());
  const auto b = draw_svg(one_line());
  ASSERT_TRUE(a && b);
  EXPECT_EQ(*a, *b);
  EXPECT_THAT(*a, ::testing::StartsWith("<?xml"));
}

TEST(HeatmapChart, ColoursEachCellByItsValue) {
  HeatmapChart view;
  view.frame = {"Cells", "", {"column", false, {}}, {"row", false, {}}, 800, 500};
  view.columns = {"a", "b", "c"};
  view.rows = {"1", "2"};
  view.values = {0, 1, 2, 3, 4, 5};
  const auto chart = draw(view);
  ASSERT_TRUE(chart) << chart.error().message;
  for (int i = 0; i < 6; ++i) {
    // A corner of the cell, away from its number.
    const ChartPoint probe{i % 3 + 0.1, i / 3 + 0.1};
    EXPECT_THAT(color_at(chart->image, chart->pixel(probe)), ColorNear(quantity_color(i / 5.0), 2)) << i;
  }
  view.values.pop_back();
  EXPECT_THAT(draw(view).error().message, ::testing::HasSubstr("cannot hold 5 values"));
}

TEST(HeatmapChart, DrawsEqualValues) {
  HeatmapChart view;
  view.frame = {"Cells", "", {"x", false, {}}, {"y", false, {}}, 800, 500};
  view.columns = {"a"};
  view.rows = {"1"};
  view.values = {4.0};
  EXPECT_TRUE(draw(view));
}

TEST(Histogram, HasBarsAsHighAsTheirCounts) {
  Histogram view;
  view.frame = {"Counts", "", {"x", false, ChartRange{0, 3}}, {"n", false, ChartRange{0, 4}}, 800, 500};
  view.values = {0.5, 1.5, 1.5, 1.5, 2.5, 2.5, 3.0};
  view.bins = 3;
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  const auto at = [&](double x, double y) { return color_at(chart->image, chart->pixel({x, y})); };
  for (const auto& [x, count] : {std::pair{0.5, 1}, std::pair{1.5, 3}, std::pair{2.5, 3}}) {
    EXPECT_THAT(at(x, count - 0.1), ColorNear(view.color, 2)) << x;
    EXPECT_THAT(at(x, count + 0.3), ColorNear(palette::kPaper, 2)) << x;
  }
  view.bins = 0;
  EXPECT_FALSE(draw(view));
}

TEST(Histogram, DrawsNoValues) {
  Histogram view;
  view.frame = {"Nothing", "", {"x", false, {}}, {"n", false, {}}, 800, 500};
  EXPECT_TRUE(draw(view));
}

}  // namespace
}  // namespace sensotwin::render::testing
