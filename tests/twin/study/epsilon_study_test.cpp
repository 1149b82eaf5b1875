// SPDX-License-Identifier: MIT
#include "twin/study/epsilon_study.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace sensotwin::twin {
namespace {

using robot::ExplorerKind;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Standard deviation of epsilon from room to room about its cell's mean, IDFM, the paper's counting: at
/// most 1.6 per cent in any cell (measured, 1000 rooms a cell).
constexpr double kSpreadPercent = 1.1;

TEST(EpsilonStudy, HasThe96CellsOfThePaper) {
  const auto cells = paper_cells();
  ASSERT_EQ(cells.size(), 96u);
  EXPECT_EQ(cells.front().blocked_percent, 5);
  EXPECT_EQ(cells.back().blocked_percent, 30);
  EXPECT_EQ(cells.back().chunks, 16);
}

TEST(EpsilonStudy, FitsAPlaneExactly) {
  std::vector<std::array<double, 3>> points;
  for (const ObstacleCell& c : paper_cells()) {
    points.push_back(
        {c.blocked_percent * 1.0, c.chunks * 1.0, 0.0765 * c.blocked_percent + 0.4869 * c.chunks - 0.3437});
  }
  const PlaneFit fit = fit_plane(points);
  EXPECT_NEAR(fit.per_blocked_percent, 0.0765, 1e-12);
  EXPECT_NEAR(fit.per_chunk, 0.4869, 1e-12);
  EXPECT_NEAR(fit.constant, -0.3437, 1e-12);
  EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
}

TEST(EpsilonStudy, GivesTheSameTextForAnyNumberOfJobs) {
  EpsilonStudyOptions options{.explorers = {ExplorerKind::kIdfm, ExplorerKind::kSweep},
                              .maps_per_cell = 3,
                              .cells = {{5, 1}, {15, 7}, {30, 16}}};
  const std::string alone = to_json(*run_epsilon_study(options));
  options.jobs = 4;
  int calls = 0;
  EXPECT_EQ(to_json(*run_epsilon_study(options, [&](int, int) { return ++calls > 0; })), alone);
  EXPECT_EQ(calls, 9) << "progress is told of each room";
}

TEST(EpsilonStudy, EndsEarlyWithoutAResultWhenToldTo) {
  for (const int jobs : {1, 4}) {
    int calls = 0;
    const auto third_is_enough = [&](int, int) { return ++calls < 3; };
    EXPECT_FALSE(run_epsilon_study({.maps_per_cell = 50, .jobs = jobs}, third_is_enough));
    EXPECT_EQ(calls, 3) << "of 4800";
  }
}

TEST(EpsilonStudy, FindsThePapersPlaneWithFewMaps) {
  const EpsilonStudy study = *run_epsilon_study({.maps_per_cell = 20, .jobs = 2});
  const PlaneFit& fit = study.explorers.front().paper_fit;
  // The limits of the full study (10 % of each slope, 0.2 of the constant), and four standard errors of a fit
  // over 96 cells whose means are uncertain by spread / sqrt(20): Bp spreads by 8.54 about its mean, Bd
  // by 4.61.
  const double cell_error = kSpreadPercent / std::sqrt(20.0 * 96.0);
  EXPECT_NEAR(fit.per_blocked_percent, 0.0765, 0.00765 + 4.0 * cell_error / 8.54);
  EXPECT_NEAR(fit.per_chunk, 0.4869, 0.04869 + 4.0 * cell_error / 4.61);
  // The constant lies 17.5 / 8.54 and 8.5 / 4.61 spreads from the middle of the cells.
  EXPECT_NEAR(fit.constant, -0.3437, 0.2 + 4.0 * cell_error * std::sqrt(1.0 + 2.05 * 2.05 + 1.84 * 1.84));
  for (const EpsilonCell& cell : study.explorers.front().cells) EXPECT_EQ(cell.incomplete_maps, 0);
}

TEST(EpsilonStudy, SweepStaysUnderSixPercentWhereTheSpiralNeedsTen) {
  // Every fourth chunk count of all six percentages.
  std::vector<ObstacleCell> cells;
  for (const ObstacleCell& c : paper_cells()) {
    if (c.chunks % 4 == 1) cells.push_back(c);
  }
  const EpsilonStudy study = *run_epsilon_study({.explorers = {ExplorerKind::kSweep, ExplorerKind::kSpiral},
                                                 .maps_per_cell = 4,
                                                 .jobs = 2,
                                                 .cells = cells});
  EXPECT_LT(study.explorers[0].mean_physical_percent(), 6.0);
  EXPECT_LT(study.explorers[0].mean_physical_percent(), 0.7 * study.explorers[1].mean_physical_percent());
}

TEST(EpsilonStudy, WritesCsvAndATableForPeople) {
  const EpsilonStudy study = *run_epsilon_study({.maps_per_cell = 2, .cells = {{5, 1}, {5, 2}, {10, 1}}});
  EXPECT_THAT(to_csv(study), StartsWith("explorer,blocked_percent,chunks,paper_mean_percent"));
  EXPECT_THAT(to_csv(study), HasSubstr("\nidfm,5,1,"));
  EXPECT_THAT(to_table(study), HasSubstr("2 maps in each of 3 cells, seed 1"));
  EXPECT_THAT(to_table(study), HasSubstr("0.0765 Bp"));
}

}  // namespace
}  // namespace sensotwin::twin
