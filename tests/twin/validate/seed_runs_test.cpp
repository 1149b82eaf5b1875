// SPDX-License-Identifier: MIT
#include "twin/validate/seed_runs.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <fstream>

#include "robot/output/output_error.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin/run/mapping_run.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::ElementsAre;

Scene lesson() {
  return read_scene(std::string(SENSOTWIN_SOURCE_DIR) + "/scenes/lesson_2x2.yaml");
}

SeedRunsOptions options_for(const TemporaryFolder& folder, const std::vector<std::uint64_t>& seeds,
                            int jobs) {
  SeedRunsOptions options;
  options.seeds = seeds;
  options.jobs = jobs;
  options.scratch = folder / "scratch";
  return options;
}

TEST(SeedRuns, DoNotDependOnTheNumberOfThreads) {
  const TemporaryFolder folder;
  SeedTable one;
  SeedTable three;
  ASSERT_TRUE(run_seeds(lesson(), options_for(folder, {1, 2, 3, 4, 5}, 1), one));
  ASSERT_TRUE(run_seeds(lesson(), options_for(folder, {1, 2, 3, 4, 5}, 3), three));
  EXPECT_EQ(to_csv(one, {}), to_csv(three, {}));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "the scratch folder was left behind";
}

TEST(SeedRuns, AreTheRunsThatTwinRunMakes) {
  const TemporaryFolder folder;
  SeedTable table;
  ASSERT_TRUE(run_seeds(lesson(), options_for(folder, {8}, 1), table));
  Scene scene = lesson();
  scene.seed = 8;
  robot::RunFolder run(folder / "run", robot::Existing::kRefuse);
  SceneRunOptions options;
  options.pictures = false;
  const Summary summary = run_mapping(scene, run, options);
  EXPECT_EQ(table.at(8).state_hash, summary.state_hash);
  EXPECT_EQ(table.at(8).figures, figures_of(summary));
}

TEST(SeedRuns, RunOnlyWhatTheTableLacks) {
  const TemporaryFolder folder;
  SeedTable table;
  table[2] = {.seed = 2, .figures = {}, .state_hash = "kept"};
  std::vector<int> there;
  SeedRunsOptions options = options_for(folder, {1, 2, 3}, 1);
  options.ran = [&](const SeedTable&, int done) { there.push_back(done); };
  ASSERT_TRUE(run_seeds(lesson(), options, table));
  EXPECT_EQ(table.at(2).state_hash, "kept");
  EXPECT_THAT(there, ElementsAre(2, 3));
}

TEST(SeedRuns, KeepWhatIsDoneWhenToldToStop) {
  const TemporaryFolder folder;
  SeedTable table;
  std::atomic<bool> stop{false};
  SeedRunsOptions options = options_for(folder, {1, 2, 3, 4, 5, 6, 7, 8}, 2);
  options.keep_going = [&] { return !stop; };
  options.ran = [&](const SeedTable& so_far, int) { stop = so_far.size() >= 2; };
  EXPECT_FALSE(run_seeds(lesson(), options, table));
  EXPECT_GE(table.size(), 2u);
  EXPECT_LT(table.size(), 8u);
}

TEST(SeedRuns, EndWithTheErrorOfARunAndKeepTheOthers) {
  const TemporaryFolder folder;
  SeedTable table;
  SeedRunsOptions options = options_for(folder, {1, 2}, 2);
  std::ofstream{folder / "file"} << "no folder";
  options.scratch = folder / "file" / "scratch";
  EXPECT_THROW((void)run_seeds(lesson(), options, table), robot::OutputError);
}

}  // namespace
}  // namespace sensotwin::twin
