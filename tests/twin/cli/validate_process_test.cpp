// SPDX-License-Identifier: MIT
// `twin validate` as a process: verdicts, files, interruption, resumption, wrong words.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::string kLesson = std::string(SENSOTWIN_SOURCE_DIR) + "/scenes/lesson_2x2.yaml";

std::string quoted(const std::filesystem::path& path) {
  return "'" + path.string() + "'";
}

/// `twin -q validate` of the lesson into `out`.
std::string line(const std::string& rest, const std::filesystem::path& out) {
  return "-q validate '" + kLesson + "' " + rest + " --out " + quoted(out);
}

bool is_png(const std::filesystem::path& file) {
  return content_of(file).starts_with("\x89PNG\r\n\x1a\n");
}

TEST(ValidateProcess, AcceptsASceneThatEverySeedKeepsAndLeavesAReport) {
  const TemporaryFolder folder;
  const auto out = folder / "report";
  const Outcome outcome =
      twin(line("--seeds 1..4 --worst 1 --json --junit " + quoted(folder / "junit.xml"), out));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["verdict"], "accepted");
  EXPECT_EQ(report["seeds_done"], 4);
  EXPECT_EQ(content_of(out / "report.json"), outcome.out);
  EXPECT_THAT(content_of(folder / "junit.xml"), HasSubstr("tests=\"3\" failures=\"0\" errors=\"0\""));
  const std::string seeds = content_of(out / "seeds.csv");
  EXPECT_EQ(std::count(seeds.begin(), seeds.end(), '\n'), 5);
  for (const char* figure : {"minutes", "tiles_mapped", "tiles_wrong"}) {
    EXPECT_TRUE(is_png(out / ("distributions/" + std::string(figure) + ".png"))) << figure;
  }
  ASSERT_EQ(report["worst_seeds"].size(), 1u);
  const std::string worst = "worst/seed_" + report["worst_seeds"][0].dump();
  EXPECT_TRUE(is_png(out / (worst + "/floorplan.png")));
  EXPECT_FALSE(std::filesystem::exists(out / ".scratch"));
}

TEST(ValidateProcess, NamesTheFailingSeedsAndACommandThatRepeatsThem) {
  const TemporaryFolder folder;
  const std::string change = " --set expect.minutes.max=0.1";
  const Outcome outcome = twin(line("--seeds 3,1 --no-pictures" + change, folder / "report"));
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("minutes at most 0.1 in every seed: missed by seeds 1, 3\n"));
  EXPECT_THAT(outcome.out, HasSubstr("twin run " + kLesson + " --seed 1" + change + "\n"));
  EXPECT_THAT(outcome.out, HasSubstr("verdict not_accepted\n"));
  const Outcome again =
      twin("-q run " + kLesson + " --seed 1" + change + " --no-pictures --out " + quoted(folder / "again"));
  EXPECT_EQ(again.code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "report/worst"));
}

TEST(ValidateProcess, DoesNotDependOnItsThreadsToTheLastByte) {
  const TemporaryFolder folder;
  const std::string rest =
      "--seeds 1..5 --no-pictures --json --set 'expect.minutes.median={max: 0.7}' --jobs ";
  const Outcome one = twin(line(rest + "1 --junit " + quoted(folder / "one.xml"), folder / "one"));
  const Outcome three = twin(line(rest + "3 --junit " + quoted(folder / "three.xml"), folder / "three"));
  EXPECT_EQ(one.code, three.code);
  EXPECT_EQ(one.out, three.out);
  EXPECT_EQ(content_of(folder / "one/seeds.csv"), content_of(folder / "three/seeds.csv"));
  EXPECT_EQ(content_of(folder / "one.xml"), content_of(folder / "three.xml"));
}

TEST(ValidateProcess, GoesOnWithWhatAnEarlierOneLeft) {
  const TemporaryFolder folder;
  const auto out = folder / "report";
  ASSERT_EQ(twin(line("--seeds 1..2 --no-pictures", out)).code, 0);
  EXPECT_EQ(twin(line("--seeds 1..3 --no-pictures", out)).code, 73) << "without being told to";
  const Outcome resumed =
      twin("validate '" + kLesson + "' --seeds 1..3 --no-pictures --resume --json --out " + quoted(out));
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, HasSubstr("2 of 3 seeds are in "));
  EXPECT_THAT(resumed.err, HasSubstr("1/1 seeds"));
  const Outcome anew = twin(line("--seeds 1..3 --no-pictures --json", folder / "anew"));
  EXPECT_EQ(resumed.out, anew.out);
  EXPECT_EQ(content_of(out / "seeds.csv"), content_of(folder / "anew/seeds.csv"));
}

TEST(ValidateProcess, DoesNotGoOnWithAnotherScene) {
  const TemporaryFolder folder;
  const auto out = folder / "report";
  ASSERT_EQ(twin(line("--seeds 1 --no-pictures", out)).code, 0);
  const std::string before = content_of(out / "seeds.csv");
  const Outcome other = twin(line("--seeds 1..2 --no-pictures --resume --set time_limit_s=800", out));
  EXPECT_EQ(other.code, 65);
  EXPECT_THAT(other.err, HasSubstr("seeds.csv:2: is a run of another scene"));
  EXPECT_EQ(content_of(out / "seeds.csv"), before);
  EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
  EXPECT_EQ(twin(line("--seeds 1 --no-pictures --force --set time_limit_s=800", out)).code, 0);
}

TEST(ValidateProcess, KeepsWhatIsDoneWhenInterruptedAndResumes) {
  const TemporaryFolder folder;
  const auto out = folder / "report";
  BackgroundTwin running({"validate", kLesson, "--seeds", "1..100000", "--jobs", "2", "--no-pictures",
                          "--junit", (folder / "junit.xml").string(), "--out", out.string()});
  ASSERT_TRUE(running.wait_for(out / ".scratch/seed_3"));
  const auto end = running.stop(SIGINT);
  EXPECT_EQ(end.code, 75);
  EXPECT_LT(end.after_s, 2.0);
  const auto report = nlohmann::json::parse(content_of(out / "report.json"));
  EXPECT_EQ(report["verdict"], "interrupted");
  const int done = report["seeds_done"];
  EXPECT_GE(done, 1);
  const std::string seeds = content_of(out / "seeds.csv");
  EXPECT_EQ(std::count(seeds.begin(), seeds.end(), '\n'), 1 + done);
  EXPECT_THAT(content_of(folder / "junit.xml"), HasSubstr("<error message=\"interrupted after "));
  EXPECT_FALSE(std::filesystem::exists(out / ".scratch"));
  const std::string last = std::to_string(done + 1);
  EXPECT_EQ(twin(line("--seeds 1.." + last + " --no-pictures --resume", out)).code, 0);
}

TEST(ValidateProcess, RefusesSeedsThatAreNone) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> wrong[] = {
      {"5..1", "'5..1' runs backwards"},
      {"1..x", "'1..x' is no seed and no range of seeds such as 1..200"},
      {"''", "'' is no seed"},
      {"1,,2", "'' is no seed"},
      {"1..5,3", "seed 3 is there twice"},
      {"1..2000000", "makes more than 100000 seeds"}};
  for (const auto& [seeds, message] : wrong) {
    const Outcome outcome = twin("validate --seeds " + std::string(seeds) + " '" + kLesson + "' --out " +
                                 quoted(folder / "report"));
    EXPECT_EQ(outcome.code, 2) << seeds;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
  EXPECT_THAT(twin(line("", folder / "report")).err, HasSubstr("--seeds"));
  EXPECT_EQ(twin(line("--seeds 1 --rate 95", folder / "report")).code, 2);
  EXPECT_EQ(twin(line("--seeds 1 --confidence 1", folder / "report")).code, 2);
  EXPECT_EQ(twin(line("--seeds 1 --intervals waldo", folder / "report")).code, 2);
  EXPECT_EQ(twin(line("--seeds 1 --force --resume", folder / "report")).code, 2);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ValidateProcess, RefusesAnExpectationOfNoFigureBeforeItRuns) {
  const TemporaryFolder folder;
  const Outcome outcome =
      twin(line("--seeds 1 --set 'expect.minuets={median: {max: 3}}'", folder / "report"));
  EXPECT_EQ(outcome.code, 65);
  EXPECT_THAT(outcome.err, HasSubstr("no figure is called 'minuets'"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ValidateProcess, FindsThatItsJUnitFileCannotBeWrittenBeforeItRuns) {
  const TemporaryFolder folder;
  const Outcome outcome =
      twin(line("--seeds 1..100000 --junit " + quoted(folder / "none/junit.xml"), folder / "report"));
  EXPECT_EQ(outcome.code, 73);
  EXPECT_THAT(outcome.err, HasSubstr("none/junit.xml"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ValidateProcess, GoesToAFolderOfItsOwnWhenNoneIsNamed) {
  const TemporaryFolder folder;
  const std::string here = "cd " + quoted(folder.path()) + " &&";
  const std::string rest = "-q validate '" + kLesson + "' --seeds 1 --no-pictures --junit junit.xml";
  EXPECT_EQ(twin(rest, here).code, 0);
  EXPECT_EQ(twin(rest, here).code, 0);
  int reports = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "runs")) {
    EXPECT_TRUE(entry.path().filename().string().starts_with("validate-lesson_2x2-")) << entry.path();
    reports += std::filesystem::exists(entry.path() / "report.json") ? 1 : 0;
  }
  EXPECT_EQ(reports, 2);
}

TEST(ValidateProcess, HelpOpensWithExamples) {
  const Outcome outcome = twin("validate --help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("twin validate scenes/house.yaml --seeds 1..200"));
  EXPECT_THAT(outcome.out, HasSubstr("--junit PATH"));
}

}  // namespace
}  // namespace sensotwin::twin
