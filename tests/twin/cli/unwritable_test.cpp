// SPDX-License-Identifier: MIT
// What cannot be read or written ends a run with a code of its own, one line, and nothing half-written.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::string kLesson = std::string(SENSOTWIN_SOURCE_DIR) + "/scenes/lesson_2x2.yaml";

void expect_one_error_line(const Outcome& outcome) {
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
  EXPECT_EQ(outcome.out, "");
}

TEST(UnwritableRun, BelowAFileCannotBeCreated) {
  const TemporaryFolder folder;
  std::ofstream{folder / "file"} << "kept";
  const Outcome outcome = twin("-q run '" + kLesson + "' --out '" + (folder / "file/run").string() + "'");
  EXPECT_EQ(outcome.code, 73);
  expect_one_error_line(outcome);
  EXPECT_EQ(content_of(folder / "file"), "kept");
}

TEST(UnwritableRun, InAFolderThatHoldsSomethingIsRefusedWithoutForce) {
  const TemporaryFolder folder;
  std::ofstream{folder / "mine.txt"} << "kept";
  const std::string run = "-q run '" + kLesson + "' --no-pictures --out '" + folder.path().string() + "'";
  const Outcome refused = twin(run);
  EXPECT_EQ(refused.code, 73);
  expect_one_error_line(refused);
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
  EXPECT_EQ(twin(run + " --force").code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
  EXPECT_EQ(content_of(folder / "mine.txt"), "kept");
}

// A limit of file size is a full disk: write() fails half-way. The shell counts it in blocks of 512 or 1024
// bytes.
TEST(UnwritableRun, OnAFullDiskLeavesNothingHalfWritten) {
  const TemporaryFolder folder;
  // 64 of them hold part of the trace of a 2x2 lesson at every tick, 0.5 MB.
  const Outcome outcome =
      twin("-q run '" + kLesson + "' --no-pictures --trace-every 1 --out '" + (folder / "run").string() + "'",
           "ulimit -f 64;");
  EXPECT_EQ(outcome.code, 74);
  expect_one_error_line(outcome);
  EXPECT_THAT(outcome.err, HasSubstr("trace.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run/trace.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run/summary.json"));
  for (const auto& entry : std::filesystem::directory_iterator(folder / "run")) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST(UnwritableRun, OnADiskThatFillsUpWhilePicturesAreDrawnKeepsWhatIsComplete) {
  const TemporaryFolder folder;
  // Trace and map of the lesson fit, pictures do not.
  const Outcome outcome =
      twin("-q run '" + kLesson + "' --trace-every 100000 --out '" + (folder / "run").string() + "'",
           "ulimit -f 40;");
  EXPECT_EQ(outcome.code, 74);
  expect_one_error_line(outcome);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/events.jsonl"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run/summary.json"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "run")) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST(UnreadableScene, EndsWithTheCodeOfWhatIsWrong) {
  const TemporaryFolder folder;
  std::ofstream{folder / "broken.yaml"} << "version: 1\nsede: 1\nworld: {}\n";
  std::ofstream{folder / "mapless.yaml"} << "version: 1\nseed: 1\nworld: { map: { file: none.yaml } }\n";
  const auto run = [&](const std::string& scene, const std::string& more = "") {
    return twin("run '" + scene + "' --out '" + (folder / "run").string() + "' " + more);
  };
  const Outcome broken = run((folder / "broken.yaml").string());
  EXPECT_EQ(broken.code, 65);
  EXPECT_THAT(broken.err, HasSubstr("broken.yaml:2:1: error: "));
  EXPECT_THAT(broken.err, HasSubstr("seed"));
  EXPECT_EQ(run((folder / "missing.yaml").string()).code, 66);
  EXPECT_EQ(run((folder / "mapless.yaml").string()).code, 66);
  EXPECT_EQ(run(kLesson, "--bogus").code, 2);
  EXPECT_EQ(run(kLesson, "--set mission.map.explorer=sideways").code, 65);
  EXPECT_FALSE(std::filesystem::exists(folder / "run")) << "a scene that does not run leaves no folder";
}

TEST(UnreadableScene, ThatExpectsAFigureOfNoNameIsRefusedBeforeItRuns) {
  const TemporaryFolder folder;
  const Outcome outcome =
      twin("run '" + kLesson + "' --set expect.tiles_maped.min=1 --out '" + (folder / "run").string() + "'");
  EXPECT_EQ(outcome.code, 65);
  expect_one_error_line(outcome);
  EXPECT_THAT(outcome.err, HasSubstr("lesson_2x2.yaml: expect: no figure is called 'tiles_maped'"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

TEST(MissedExpectation, EndsTheRunWithOneAndAllItsFiles) {
  const TemporaryFolder folder;
  const Outcome outcome =
      twin("-q run '" + kLesson + "' --no-pictures --set expect.minutes.max=0.01 --json --out '" +
           (folder / "run").string() + "'");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["verdict"], "not_accepted");
  EXPECT_EQ(outcome.out, content_of(folder / "run/summary.json"));
}

}  // namespace
}  // namespace sensotwin::twin
