// SPDX-License-Identifier: MIT
#include "twin/study/house_study.hpp"

#include <gmock/gmock.h>

namespace sensotwin::twin {
namespace {

using robot::ExplorerKind;

class HouseStudy : public ::testing::Test {
 protected:
  static const std::vector<HouseRun>& runs() {
    static const std::vector<HouseRun> kRuns = run_house_study();
    return kRuns;
  }
  static double minutes(const HouseRun& run, const Pace& pace, ExplorerKind kind) {
    return pace.minutes(run.tally(kind, Knowledge::kAdjacent));
  }
};

TEST_F(HouseStudy, HasThreeLayoutsOf207Tags) {
  ASSERT_EQ(house_layouts().size(), 3u);
  for (const HouseLayout& layout : house_layouts())
    EXPECT_EQ(layout.room().reachable().size(), 207u) << layout.name;
}

TEST_F(HouseStudy, EveryExplorerFindsAllTags) {
  for (const HouseRun& run : runs()) {
    for (const HouseRow& row : run.rows) {
      EXPECT_EQ(row.tally.tags_visited, 207) << robot::name_of(row.explorer);
      EXPECT_TRUE(row.tally.ended);
    }
  }
}

TEST_F(HouseStudy, ThePapersMinutesComeOutWithinTenPercentAtItsPace) {
  for (const HouseRun& run : runs()) {
    EXPECT_NEAR(minutes(run, kPaperPace, ExplorerKind::kBfm), 69.0, 6.9) << run.layout.name;
    EXPECT_NEAR(minutes(run, kPaperPace, ExplorerKind::kDfm), 42.0, 4.2) << run.layout.name;
    EXPECT_NEAR(minutes(run, kPaperPace, ExplorerKind::kIdfm), 26.0, 2.6) << run.layout.name;
  }
}

TEST_F(HouseStudy, SweepNeedsFivePercentLessTimeThanIdfmAndTheSpiral) {
  for (const HouseRun& run : runs()) {
    const double sweep = minutes(run, kRoombaPace, ExplorerKind::kSweep);
    EXPECT_LT(sweep, 0.95 * minutes(run, kRoombaPace, ExplorerKind::kIdfm)) << run.layout.name;
    EXPECT_LT(sweep, 0.95 * minutes(run, kRoombaPace, ExplorerKind::kSpiral)) << run.layout.name;
    EXPECT_LT(sweep, 9.0) << run.layout.name;
  }
}

TEST_F(HouseStudy, PrintsTheHouseAndTheMinutes) {
  const std::string table = to_table(runs());
  EXPECT_THAT(table, ::testing::HasSubstr("sofa_in_the_middle"));
  EXPECT_THAT(table, ::testing::HasSubstr("idfm"));
  EXPECT_THAT(table, ::testing::HasSubstr("\nS.................\n"));
}

}  // namespace
}  // namespace sensotwin::twin
