// SPDX-License-Identifier: MIT
#include "twin/trace/trace_folder.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "robot/output/output_error.hpp"
#include "trace_bench.hpp"
#include "twin/trace/trace_error.hpp"

namespace sensotwin::twin {
namespace {

TEST(TraceFolder, ListsWhatThePageCanOpen) {
  TraceBench bench;
  bench.put("a.png", "x");
  bench.put("a.trace.json", "{}");
  bench.put("a.yaml", "version: 1\nplaces: {}\n");
  bench.put("m.yaml", "image: a.png\n");
  bench.put("s.yaml", "world: {}\n");
  bench.put("notes.txt", "x");
  bench.put(".secret.png", "x");
  const TraceFolder folder(bench.folder.path());
  std::vector<std::string> found;
  for (const TraceFile& file : folder.files()) {
    found.push_back(file.name + " " + file.kind);
  }
  EXPECT_THAT(found, testing::ElementsAre("a.png picture", "a.trace.json tracing", "a.yaml hallways",
                                          "m.yaml map", "s.yaml scene"));
}

TEST(TraceFolder, RefusesALinkThatLeadsOut) {
  TraceBench bench;
  std::filesystem::create_symlink("/etc/hostname", bench.folder / "inside.yaml");
  const TraceFolder folder(bench.folder.path());
  EXPECT_THROW((void)folder.read("inside.yaml"), TraceError);
}

TEST(TraceFolder, ReplacesALinkInsteadOfWritingThroughIt) {
  TraceBench bench;
  std::ofstream(bench.scratch / "outside.yaml") << "untouched";
  std::filesystem::create_symlink(bench.scratch / "outside.yaml", bench.folder / "a.yaml");
  TraceFolder folder(bench.folder.path());
  EXPECT_EQ(folder.conflicts({{"a.yaml", "new"}}, {}), std::vector<std::string>{"a.yaml"});
  folder.write({{"a.yaml", "new"}});
  EXPECT_EQ(content_of(bench.scratch / "outside.yaml"), "untouched");
  EXPECT_EQ(bench.content("a.yaml"), "new");
}

TEST(TraceFolder, LeavesTheOldFileWhenTheDiskIsFull) {
  TraceBench bench;
  bench.put("a.yaml", "old");
  TraceFolder folder(bench.folder.path());
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(folder.write({{"a.yaml", std::string(100'000, 'x')}}), TraceError);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(bench.content("a.yaml"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(bench.folder.path()), {}), 1);
}

TEST(TraceFolder, RefusesToWriteAnythingWhenOneNameIsNone) {
  TraceBench bench;
  TraceFolder folder(bench.folder.path());
  EXPECT_THROW(folder.write({{"a.yaml", "x"}, {"b/../../c.yaml", "x"}}), TraceError);
  EXPECT_TRUE(std::filesystem::is_empty(bench.folder.path()));
}

TEST(TraceFolder, CannotBeWhereAFileIs) {
  TraceBench bench;
  bench.put("file", "x");
  EXPECT_THROW(TraceFolder(bench.folder / "file"), robot::OutputError);
}

TEST(TraceFolder, SeesNoConflictInWhatIsTheSameAnyway) {
  TraceBench bench;
  bench.put("a.yaml", "same");
  const TraceFolder folder(bench.folder.path());
  EXPECT_TRUE(folder.conflicts({{"a.yaml", "same"}}, {}).empty());
  EXPECT_TRUE(folder.conflicts({{"a.yaml", "new"}}, {{"a.yaml", stamp_of_content("same")}}).empty());
  EXPECT_FALSE(folder.conflicts({{"a.yaml", "new"}}, {{"a.yaml", stamp_of_content("older")}}).empty());
}

}  // namespace
}  // namespace sensotwin::twin
