// SPDX-License-Identifier: MIT
#include "render/distribution_chart.hpp"

#include <limits>

#include "picture_check.hpp"

namespace sensotwin::render::testing {
namespace {

/// 100 values over 2 .. 4, the upper half of them beyond a maximum of 3.
[[nodiscard]] DistributionChart spread() {
  DistributionChart chart;
  chart.frame.title = "minutes over 100 seeds";
  chart.frame.subtitle = "scene made_up";
  chart.frame.x.label = "minutes";
  chart.frame.y.label = "seeds";
  chart.frame.height_px = 800;
  for (int i = 0; i < 100; ++i) {
    chart.values.push_back(2.0 + 2.0 * i / 99.0);
  }
  return chart;
}

TEST(DistributionChart, DrawsValuesBeyondALimitInAnotherColour) {
  DistributionChart view = spread();
  view.limits.push_back({.value = 3.0, .label = ""});
  const auto chart = draw(view);
  ASSERT_TRUE(chart) << chart.error().message;
  EXPECT_THAT(color_at(chart->image, chart->pixel({2.07, 3.0})), ColorNear(palette::kSky, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({3.87, 3.0})), ColorNear(palette::kVermilion, 2));
}

TEST(DistributionChart, KeepsTheColourForALimitOfAStatistic) {
  DistributionChart view = spread();
  view.limits.push_back({.value = 3.0, .of_each = false, .label = ""});
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  EXPECT_THAT(color_at(chart->image, chart->pixel({3.87, 3.0})), ColorNear(palette::kSky, 2));
}

TEST(DistributionChart, GrowsByItsRowsAndPutsTheirIntervalsOnTheAxisOfTheValues) {
  const auto bare = draw(spread());
  DistributionChart view = spread();
  view.rows.push_back(
      {.text = "median", .color = palette::kGreen, .interval = ChartRange{2.5, 3.5}, .estimate = 3.0});
  const auto chart = draw(view);
  ASSERT_TRUE(bare && chart);
  EXPECT_GT(chart->image.height_px(), bare->image.height_px());
  // Somewhere above the plot, at 2.75 of the axis, runs the bar of the interval; at 3.75 it does not.
  const auto green_above = [&](double value) {
    int found = 0;
    for (double y = 110.0; y < chart->plot.y; y += 1.0) {
      const Rgba color = color_at(chart->image, {chart->pixel({value, 0.0}).x(), y});
      found += color == palette::kGreen ? 1 : 0;
    }
    return found;
  };
  EXPECT_GE(green_above(2.75), 3);
  EXPECT_EQ(green_above(3.75), 0);
}

TEST(DistributionChart, CentresBarsOnWholeNumbers) {
  DistributionChart view = spread();
  view.values = {16, 16, 16, 16, 14};
  view.limits.push_back({.value = 16.0, .upper = false, .label = ""});
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  EXPECT_THAT(color_at(chart->image, chart->pixel({15.6, 1.0})), ColorNear(palette::kSky, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({16.4, 1.0})), ColorNear(palette::kSky, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({14.0, 0.5})), ColorNear(palette::kVermilion, 2));
  EXPECT_THAT(color_at(chart->image, chart->pixel({15.0, 0.5})), ColorNear(palette::kPaper, 0));
}

TEST(DistributionChart, DoesNotLetAFarLimitFlattenTheValues) {
  DistributionChart view = spread();
  view.limits.push_back({.value = 500.0, .label = "at most 500"});
  const auto chart = draw(view);
  ASSERT_TRUE(chart);
  EXPECT_LT(chart->x.range->high, 5.0);
}

TEST(DistributionChart, DrawsIntervalsThatAreOpenAtAnEndAndValuesThatAreAllAlike) {
  DistributionChart view = spread();
  view.values.assign(5, 0.3);
  const double infinity = std::numeric_limits<double>::infinity();
  view.rows.push_back({.text = "quantile", .interval = ChartRange{-infinity, infinity}, .estimate = 0.3});
  EXPECT_TRUE(draw(view));
}

TEST(DistributionChart, RefusesWhatHasNoPlace) {
  DistributionChart none = spread();
  none.values.clear();
  EXPECT_FALSE(draw(none));
  DistributionChart nan = spread();
  nan.values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(draw(nan));
  DistributionChart limit = spread();
  limit.limits.push_back({.value = std::numeric_limits<double>::infinity(), .label = "far"});
  EXPECT_THAT(draw(limit).error().message, ::testing::HasSubstr("limit far"));
}

}  // namespace
}  // namespace sensotwin::render::testing
