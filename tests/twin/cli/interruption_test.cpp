// SPDX-License-Identifier: MIT
// Ctrl-C: within a second, with a code of its own, and with what was done so far in order.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

const std::filesystem::path kSource = SENSOTWIN_SOURCE_DIR;

/// A room of 60 x 60 tiles: half a minute of wall time to map, so that it is never done before the signal
/// comes.
std::string large_room(const TemporaryFolder& folder) {
  const std::filesystem::path scene = folder / "large.yaml";
  std::ofstream{scene} << "version: 1\nseed: 1\n"
                          "world: { room: { walls_m: [[0, 0], [30.48, 0], [30.48, 30.48], [0, 30.48]] } }\n"
                          "mission: { map: { explorer: bfm, pace: paper } }\ntime_limit_s: 10000000\n";
  return scene.string();
}

/// What must hold of a folder whenever the run ended.
void expect_valid_partial_folder(const std::filesystem::path& run, bool maps = true) {
  const auto summary = nlohmann::json::parse(content_of(run / "summary.json"), nullptr, false);
  ASSERT_FALSE(summary.is_discarded());
  EXPECT_EQ(summary["verdict"], "interrupted");
  for (const char* stream : {"trace.csv", "events.jsonl"}) {
    const std::string text = content_of(run / stream);
    ASSERT_FALSE(text.empty()) << stream;
    EXPECT_EQ(text.back(), '\n') << stream;
  }
  const std::string trace = content_of(run / "trace.csv");
  const auto commas = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
  const std::size_t last = trace.rfind('\n', trace.size() - 2) + 1;
  EXPECT_EQ(commas(std::string_view(trace).substr(last)),
            commas(std::string_view(trace).substr(0, trace.find('\n'))));
  std::istringstream events(content_of(run / "events.jsonl"));
  for (std::string line; std::getline(events, line);) {
    EXPECT_FALSE(nlohmann::json::parse(line, nullptr, false).is_discarded()) << line;
  }
  EXPECT_EQ(std::filesystem::exists(run / "map.yaml"), maps);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run)) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST(Interruption, EndsALongRunWithinASecondAndLeavesAValidPartialFolder) {
  const TemporaryFolder folder;
  BackgroundTwin twin({"run", large_room(folder), "--out", (folder / "run").string()});
  ASSERT_TRUE(twin.wait_for(folder / "run/.trace.csv.part"));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto end = twin.stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  RecordProperty("after_ms", static_cast<int>(1000 * end.after_s));
  expect_valid_partial_folder(folder / "run");
}

TEST(Interruption, BySigtermEndsWithACodeOfItsOwn) {
  const TemporaryFolder folder;
  BackgroundTwin twin({"run", large_room(folder), "--out", (folder / "run").string()});
  ASSERT_TRUE(twin.wait_for(folder / "run/.events.jsonl.part"));
  const auto end = twin.stop(SIGTERM);
  EXPECT_EQ(end.code, 143);
  EXPECT_LT(end.after_s, 1.0);
  expect_valid_partial_folder(folder / "run");
}

TEST(Interruption, OfARunThatIsDrawingItsPicturesDoesNotWaitForTheRest) {
  const TemporaryFolder folder;
  BackgroundTwin twin({"run", (kSource / "scenes/house.yaml").string(), "--out", (folder / "run").string()});
  ASSERT_TRUE(twin.wait_for(folder / "run/floorplan.png"));
  const auto end = twin.stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  RecordProperty("after_ms", static_cast<int>(1000 * end.after_s));
  expect_valid_partial_folder(folder / "run");
  EXPECT_FALSE(std::filesystem::exists(folder / "run/tags_over_time.png"));
}

TEST(Interruption, OfARunAlongCeilingTagsEndsWithinASecondToo) {
  const TemporaryFolder folder;
  // A quarter of an hour under forty tags: seconds of wall time.
  BackgroundTwin twin({"run", (kSource / "scenes/hall_40.yaml").string(), "--variant", "r420", "--tag-log",
                       (folder / "reads.csv").string(), "--out", (folder / "run").string()});
  ASSERT_TRUE(twin.wait_for(folder / "run/.trace.csv.part"));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto end = twin.stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  RecordProperty("after_ms", static_cast<int>(1000 * end.after_s));
  expect_valid_partial_folder(folder / "run", false);
  EXPECT_EQ(content_of(folder / "reads.csv").back(), '\n');
}

TEST(Interruption, OfAStudyEndsAtTheFirstSigintAndLeavesNothingHalfWritten) {
  const TemporaryFolder folder;
  BackgroundTwin twin({"epsilon", "--explorer", "sweep", "--maps", "10000", "--out",
                       (folder / "cells.csv").string(), "--chart", (folder / "chart.png").string()});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto end = twin.stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Interruption, OfARealHomeEndsWithinASecondToo) {
  const std::filesystem::path map = kSource / "../shared/data/maps/home_create2_perceptor/map.yaml";
  if (!std::filesystem::exists(map)) {
    GTEST_SKIP() << "the maps of ../shared/data/maps are not here";
  }
  const TemporaryFolder folder;
  std::filesystem::copy(map.parent_path(), folder / "map");
  std::ofstream{folder / "home.yaml"}
      << "version: 1\nseed: 1\nworld: { map: { file: map/map.yaml } }\n"
         "mission: { map: { pace: { tile_s: 3600 } } }\ntime_limit_s: 10000000\n";
  BackgroundTwin twin({"run", (folder / "home.yaml").string(), "--out", (folder / "run").string()});
  ASSERT_TRUE(twin.wait_for(folder / "run/.events.jsonl.part"));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto end = twin.stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  RecordProperty("after_ms", static_cast<int>(1000 * end.after_s));
  expect_valid_partial_folder(folder / "run");
}

}  // namespace
}  // namespace sensotwin::twin
