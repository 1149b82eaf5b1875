// SPDX-License-Identifier: MIT
#include "twin/validate/seed_table.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::string kLesson = std::string(SENSOTWIN_SOURCE_DIR) + "/scenes/lesson_2x2.yaml";
const Origin kHere{"aaaaaaaaaaaaaaaa", "bbbbbbbbbbbbbbbb"};

SeedTable two_runs() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {{3, {.seed = 3, .figures = {{"minutes", 0.1 + 0.2}, {"tiles", 16.0}}, .state_hash = "01"}},
          {18446744073709551615u,
           {.seed = 18446744073709551615u,
            .figures = {{"minutes", nan}, {"tiles", -1e-300}},
            .state_hash = "02"}}};
}

std::string complaint_about(const std::string& csv) {
  try {
    (void)seed_table_from(csv, kHere, "seeds.csv");
  } catch (const SeedTableError& error) {
    return error.what();
  }
  return "none";
}

TEST(SeedTable, ReadsBackToTheSameBits) {
  const SeedTable table = seed_table_from(to_csv(two_runs(), kHere), kHere, "seeds.csv");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.at(3).figures.at("minutes"), 0.1 + 0.2);
  EXPECT_EQ(table.at(3).state_hash, "01");
  const RunOutcome& last = table.at(18446744073709551615u);
  EXPECT_TRUE(std::isnan(last.figures.at("minutes")));
  EXPECT_EQ(last.figures.at("tiles"), -1e-300);
  EXPECT_EQ(to_csv(table, kHere), to_csv(two_runs(), kHere));
}

TEST(SeedTable, OfNothingReadsBackToo) {
  EXPECT_TRUE(seed_table_from(to_csv({}, kHere), kHere, "seeds.csv").empty());
}

TEST(SeedTable, RefusesRowsOfAnotherSceneOrProgram) {
  EXPECT_THAT(complaint_about(to_csv(two_runs(), {"another", kHere.program_hash})),
              HasSubstr("seeds.csv:2: is a run of another scene"));
  EXPECT_THAT(complaint_about(to_csv(two_runs(), {kHere.scene_hash, "another"})),
              HasSubstr("seeds.csv:2: is a run of another build"));
}

TEST(SeedTable, RefusesWhatIsNone) {
  EXPECT_THAT(complaint_about(""), HasSubstr("seeds.csv:1: is not the seeds.csv of a validation"));
  EXPECT_THAT(complaint_about("a,b\n1,2\n"), HasSubstr("seeds.csv:1: is not"));
  const std::string csv = to_csv(two_runs(), kHere);
  EXPECT_THAT(complaint_about(csv.substr(0, csv.size() - 1)), HasSubstr("seeds.csv:1: is not"));
  EXPECT_THAT(complaint_about(csv + "4,x\n"), HasSubstr("seeds.csv:4: has 2 cells, the heading 6"));
  EXPECT_THAT(complaint_about(csv + "-4," + kHere.scene_hash + "," + kHere.program_hash + ",03,1,2\n"),
              HasSubstr("seeds.csv:4: '-4' is no seed"));
  EXPECT_THAT(complaint_about(csv + "4," + kHere.scene_hash + "," + kHere.program_hash + ",03,many,2\n"),
              HasSubstr("seeds.csv:4: 'many' is no number"));
}

TEST(SceneHash, DependsOnWhatDecidesARunAndOnNothingElse) {
  const std::string base = scene_hash_of(read_scene(kLesson));
  EXPECT_EQ(scene_hash_of(read_scene(kLesson, {.set = {}, .seed = 99})), base);
  EXPECT_EQ(scene_hash_of(read_scene(kLesson, {.set = {"title=other"}, .seed = {}})), base);
  EXPECT_EQ(scene_hash_of(read_scene(kLesson, {.set = {"expect.minutes.max=1"}, .seed = {}})), base);
  EXPECT_NE(scene_hash_of(read_scene(kLesson, {.set = {"time_limit_s=901"}, .seed = {}})), base);
  EXPECT_NE(scene_hash_of(read_scene(kLesson, {.set = {"robot.start.heading_deg=91"}, .seed = {}})), base);
}

}  // namespace
}  // namespace sensotwin::twin
