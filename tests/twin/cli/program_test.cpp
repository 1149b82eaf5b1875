// SPDX-License-Identifier: MIT
// The program as users meet it: a process with two streams and an exit code.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "twin_process.hpp"

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using ::sensotwin::twin::Outcome;
using ::sensotwin::twin::take;
using ::sensotwin::twin::twin;

TEST(Program, PrintsItsVersionOnStdout) {
  const Outcome outcome = twin("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.out.starts_with("twin "));
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(Program, PrintsTheVersionsOfItsLibrariesAsJson) {
  const auto json = nlohmann::json::parse(twin("--version --json").out);
  EXPECT_EQ(json["libraries"]["Box2D"], "2.4.1");
  EXPECT_TRUE(json["libraries"].contains("yaml-cpp"));
}

TEST(Program, OpensItsHelpWithExamplesAndEndsItWithExitCodes) {
  const Outcome outcome = twin("--help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_LT(outcome.out.find("Examples:\n  twin "), outcome.out.find("Usage:"));
  EXPECT_THAT(outcome.out, HasSubstr("130  interrupted"));
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(Program, EndsWithTwoAndNothingOnStdoutWhenCalledWrongly) {
  for (const char* arguments :
       {"", "lsit", "list --bogus", "list a b", "list nonsense", "--color blue list", "-q -v list"}) {
    const Outcome outcome = twin(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    EXPECT_TRUE(outcome.err.starts_with("error: ")) << arguments << ": " << outcome.err;
  }
}

TEST(Program, SuggestsTheCommandThatWasMeant) {
  EXPECT_THAT(twin("lsit").err, HasSubstr("(did you mean 'list'?)"));
  EXPECT_THAT(twin("list --jsn").err, HasSubstr("(did you mean '--json'?)"));
}

TEST(Program, ColoursErrorsOnlyWhenAskedToOffTheTerminal) {
  EXPECT_THAT(twin("list nonsense").err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(twin("list nonsense", "NO_COLOR=1").err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(twin("list nonsense --color always").err, HasSubstr("\x1b[31m"));
}

TEST(Program, ListsScenesOfTheWorkingDirectoryWithTheirLesson) {
  const std::filesystem::path folder = ::testing::TempDir() + "twin-list-" + std::to_string(getpid());
  std::filesystem::create_directories(folder / "scenes");
  std::ofstream{folder / "scenes/b.yaml"}
      << "# SPDX-License-Identifier: MIT\n# A second lesson.\nversion: 1\n";
  std::ofstream{folder / "scenes/a.yaml"} << "# A first lesson.\nversion: 1\n";
  const Outcome outcome = twin("list scenes", "cd '" + folder.string() + "' &&");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "scenes/a.yaml  A first lesson.\nscenes/b.yaml  A second lesson.\n");
}

TEST(Program, ListsAsJson) {
  const auto json = nlohmann::json::parse(twin("list exit-codes --json").out);
  EXPECT_EQ(json[0]["name"], "0");
  EXPECT_EQ(json.back()["name"], "143");
}

TEST(Program, ExaminesTheMachine) {
  const Outcome outcome = twin("doctor --json");
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(outcome.code, json["healthy"].get<bool>() ? 0 : 69);
  EXPECT_GE(json["probes"].size(), 10u);
}

TEST(Program, SaysWhenItsResultsDidNotReachStdout) {
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "this system has no /dev/full";
  }
  const std::string line = std::string{"'"} + TWIN_PROGRAM + "' list exit-codes >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 74);  // NOLINT(cert-env33-c): a shell is what users have
}

TEST(Program, EndsSilentlyWhenThePipeCloses) {
  const std::string err = ::testing::TempDir() + "twin-pipe-" + std::to_string(getpid());
  const std::string line = std::string{"'"} + TWIN_PROGRAM + "' list figures 2>'" + err + "' | true";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 0);  // NOLINT(cert-env33-c): a shell is what users have
  EXPECT_THAT(take(err), IsEmpty());
}

}  // namespace
