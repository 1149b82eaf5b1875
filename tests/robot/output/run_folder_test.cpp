// SPDX-License-Identifier: MIT
#include "robot/output/run_folder.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <utility>

#include "robot/output/output_error.hpp"
#include "tests/robot/output/temporary_folder.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// While it lives, no file can grow beyond `bytes`: what a full disk looks like to write(), without one.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

template <class Action>
std::pair<int, std::string> failure_of(Action action) {
  try {
    action();
  } catch (const OutputError& error) {
    return {as_int(error.exit_code()), error.what()};
  }
  return {0, "nothing was thrown"};
}

TEST(RunFolder, CreatesTheFolderAndItsParents) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary / "a/b/c", Existing::kRefuse);
  folder.write("note.txt", "hello\n");
  EXPECT_EQ(content_of(temporary / "a/b/c/note.txt"), "hello\n");
}

TEST(RunFolder, RefusesAFolderThatIsNotEmpty) {
  const TemporaryFolder temporary;
  RunFolder{temporary.path(), Existing::kRefuse}.write("summary.json", "{}");
  const auto [code, text] = failure_of([&] { RunFolder{temporary.path(), Existing::kRefuse}; });
  EXPECT_EQ(code, 73);
  EXPECT_THAT(text, HasSubstr("not empty"));
  EXPECT_THAT(text, HasSubstr("--force"));
}

TEST(RunFolder, WithForceRemovesTheOldVerdictAtOnceAndKeepsForeignFiles) {
  const TemporaryFolder temporary;
  RunFolder old(temporary.path(), Existing::kRefuse);
  old.write("summary.json", "{}");
  old.write("diary.txt", "mine");
  old.write(".trace.csv.part", "left by a killed run");
  old.write(".plan.part.png", "left by a killed run");
  const RunFolder folder(temporary.path(), Existing::kReplace);
  EXPECT_FALSE(fs::exists(temporary / "summary.json"));
  EXPECT_FALSE(fs::exists(temporary / ".trace.csv.part"));
  EXPECT_FALSE(fs::exists(temporary / ".plan.part.png"));
  EXPECT_EQ(content_of(temporary / "diary.txt"), "mine");
}

TEST(RunFolder, SaysThatAPathBelowARegularFileCannotBeCreated) {
  const TemporaryFolder temporary;
  RunFolder{temporary.path(), Existing::kRefuse}.write("file", "x");
  const auto [code, text] = failure_of([&] { RunFolder{temporary / "file/run", Existing::kRefuse}; });
  EXPECT_EQ(code, 73);
  EXPECT_THAT(text, HasSubstr("file/run"));
  EXPECT_THAT(text, HasSubstr("Not a directory"));
}

TEST(RunFolder, SaysThatAFileIsNoFolder) {
  const TemporaryFolder temporary;
  RunFolder{temporary.path(), Existing::kRefuse}.write("file", "x");
  EXPECT_EQ(failure_of([&] { RunFolder{temporary / "file", Existing::kRefuse}; }).first, 73);
}

TEST(RunFolder, SaysThatAnUnwritablePlaceCannotBeCreated) {
  EXPECT_EQ(failure_of([] { RunFolder{"/proc/twin/run", Existing::kRefuse}; }).first, 73);
}

TEST(RunFolder, ShowsAStreamUnderItsNameOnlyWhenFinished) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  OutputFile file = folder.stream("trace.csv");
  file.append("a,b\n");
  EXPECT_FALSE(fs::exists(temporary / "trace.csv"));
  file.finish();
  EXPECT_EQ(content_of(temporary / "trace.csv"), "a,b\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(temporary.path()), {}), 1);
}

TEST(RunFolder, LeavesNothingOfAStreamThatWasAbandoned) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  { folder.stream("trace.csv").append("half a li"); }
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(RunFolder, KeepsAllOfAFileThatIsLargerThanTheBuffer) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  const std::string content(1'000'003, 'x');
  folder.write("large", content);
  EXPECT_EQ(content_of(temporary / "large"), content);
}

TEST(RunFolder, ReportsAFullDiskAsIoErrorAndLeavesNoFile) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  const FileSizeLimit limit(100'000);
  const auto [code, text] = failure_of([&] { folder.write("large", std::string(200'000, 'x')); });
  EXPECT_EQ(code, 74);
  EXPECT_THAT(text, HasSubstr("cannot write"));
  EXPECT_THAT(text, HasSubstr("large"));
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(RunFolder, KeepsTheOldFileWhenItsSuccessorFails) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  folder.write("map.yaml", "old");
  const FileSizeLimit limit(1000);
  EXPECT_EQ(failure_of([&] { folder.write("map.yaml", std::string(2000, 'n')); }).first, 74);
  EXPECT_EQ(content_of(temporary / "map.yaml"), "old");
}

TEST(RunFolder, CatchesAFullDeviceInWhatWasStillBuffered) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "this system has no /dev/full";
  }
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  fs::create_symlink("/dev/full", part_path_of(temporary / "events.jsonl"));
  OutputFile file = folder.stream("events.jsonl");
  file.append("{}\n");
  const auto [code, text] = failure_of([&] { file.finish(); });
  EXPECT_EQ(code, 74);
  EXPECT_THAT(text, HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(RunFolder, PutsFilesIntoSubFolders) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  folder.write("snapshots/0001.txt", "x");
  EXPECT_EQ(content_of(temporary / "snapshots/0001.txt"), "x");
}

TEST(RunFolder, RenamesWhatAnotherLibraryWroteAndKeepsItsExtension) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  folder.write_by("plan.png", [&](const fs::path& path) {
    EXPECT_EQ(path.extension(), ".png");
    EXPECT_NE(path.filename(), "plan.png");
    std::ofstream{path} << "pixels";
  });
  EXPECT_EQ(content_of(temporary / "plan.png"), "pixels");
}

TEST(RunFolder, LeavesNothingOfAPictureWhoseWriterThrew) {
  const TemporaryFolder temporary;
  RunFolder folder(temporary.path(), Existing::kRefuse);
  EXPECT_THROW(folder.write_by("plan.png",
                               [](const fs::path& path) {
                                 std::ofstream{path} << "pix";
                                 throw std::runtime_error("no colours");
                               }),
               std::runtime_error);
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(RunFolder, NamesItselfAfterSceneSeedAndTheTimeThatItWasHanded) {
  EXPECT_EQ(default_run_folder("house", 7, "20260131T235959Z"), "runs/house-7-20260131T235959Z");
}

}  // namespace
}  // namespace sensotwin::robot
