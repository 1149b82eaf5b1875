// SPDX-License-Identifier: MIT
// What a run leaves can be read by others: the map by map_server's rules, the trace as CSV, the events as
// JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "mapping_case.hpp"
#include "twin/scene/map_import.hpp"

namespace sensotwin::twin {
namespace {

/// The house by IDFM, run once for all tests of this file.
class RecordedRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    summary_ = new Summary(run_into(run(), published("house")));
  }
  static void TearDownTestSuite() {
    delete summary_;
    delete folder_;
  }
  static std::filesystem::path run() { return *folder_ / "run"; }
  static const MapResult& result() { return *summary_->map; }

 private:
  static inline TemporaryFolder* folder_{nullptr};
  static inline Summary* summary_{nullptr};
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

TEST_F(RecordedRun, LeavesAMapThatLoadsBackWithTheAreaOfItsTiles) {
  const OccupancyMap map = read_map(run() / "map.yaml");
  const double free_m2 = static_cast<double>(map.count(Cell::kFree)) * map.resolution_m * map.resolution_m;
  // Whole tiles are floor. A tile at furniture loses a ring of cells to what was felt there, and the disc of
  // the robot sweeps a little beyond: 5 %.
  EXPECT_NEAR(free_m2 / (result().tiles_mapped * 0.508 * 0.508), 1.0, 0.05);
  EXPECT_GT(map.count(Cell::kOccupied), 0u);
  // The origin of M is the middle of the first tile.
  EXPECT_EQ(map.at(robot::Vec2{0.0, 0.0}), Cell::kFree);
}

TEST_F(RecordedRun, ListsEveryMappedTileWithItsTagOnceAndBlack) {
  const auto lines = lines_of(content_of(run() / "tiles.csv"));
  EXPECT_EQ(lines.at(0), "column,row,state,tag");
  EXPECT_EQ(lines.size(), static_cast<std::size_t>(result().tiles_mapped) + 1);
  std::set<std::string> tags;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = cells_of(lines[i]);
    ASSERT_EQ(cells.size(), 4u) << lines[i];
    EXPECT_EQ(cells[2], "black") << lines[i];
    EXPECT_EQ(cells[3].substr(0, 4), "E004") << "ICODE: " << lines[i];
    EXPECT_TRUE(tags.insert(cells[3]).second) << "twice: " << lines[i];
  }
}

TEST_F(RecordedRun, WritesATraceWhoseEveryRowHasEveryColumn) {
  const auto lines = lines_of(content_of(run() / "trace.csv"));
  const auto header = cells_of(lines.at(0));
  EXPECT_EQ(header.front(), "t_s");
  EXPECT_EQ(header.back(), "tag");
  double last_s = -1.0;
  std::size_t estimates = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = cells_of(lines[i]);
    ASSERT_EQ(cells.size(), header.size()) << "line " << i + 1;
    for (std::size_t column = 0; column + 1 < cells.size(); ++column) {
      char* end = nullptr;
      const double value = std::strtod(cells[column].c_str(), &end);
      ASSERT_TRUE(*end == '\0' && std::isfinite(value)) << "line " << i + 1 << ", " << header[column];
    }
    estimates += cells[7].empty() ? 0 : 1;
    const double t_s = std::strtod(cells[0].c_str(), nullptr);
    // Seven ticks of 15 ms.
    ASSERT_TRUE(last_s < 0.0 || std::abs(t_s - last_s - 0.105) < 1e-6) << "line " << i + 1;
    last_s = t_s;
  }
  EXPECT_NEAR(last_s, result().minutes * 60.0, 0.11);
  EXPECT_GT(estimates, lines.size() * 9 / 10);
}

TEST_F(RecordedRun, WritesEventsAsJsonLinesInTheOrderOfTime) {
  double last_s = 0.0;
  std::set<std::pair<int, int>> found;
  int written = 0;
  std::string last_event;
  for (const std::string& line : lines_of(content_of(run() / "events.jsonl"))) {
    const auto event = nlohmann::json::parse(line, nullptr, false);
    ASSERT_FALSE(event.is_discarded()) << line;
    ASSERT_GE(event.at("t_s").get<double>(), last_s) << line;
    last_s = event["t_s"].get<double>();
    last_event = event.at("event").get<std::string>();
    if (last_event == "tile_found") {
      const std::pair<int, int> tile{event.at("column").get<int>(), event.at("row").get<int>()};
      EXPECT_TRUE(found.insert(tile).second) << "found twice: " << line;
    }
    written += last_event == "tile_written" ? 1 : 0;
  }
  EXPECT_EQ(found.size(), static_cast<std::size_t>(result().tiles_mapped));
  EXPECT_EQ(written, result().tiles_mapped);
  EXPECT_EQ(last_event, "map_complete");
}

TEST_F(RecordedRun, SaysTheSameInItsSummaryAsItsCaller) {
  const auto summary = nlohmann::json::parse(content_of(run() / "summary.json"));
  EXPECT_EQ(summary["verdict"], "accepted");
  EXPECT_EQ(summary["map"]["tiles_mapped"], result().tiles_mapped);
  EXPECT_EQ(summary["map"]["explorer"], "idfm");
  EXPECT_EQ(summary["links"]["roomba_frames_corrupt"], 0);
}

TEST(InterruptedRun, EndsWhenToldToAndLeavesAShorterValidFolder) {
  const TemporaryFolder folder;
  robot::RunFolder results(folder / "run", robot::Existing::kRefuse);
  int asked = 0;
  SceneRunOptions options;
  options.keep_going = [&](const RunProgress& progress) { return ++asked < 10 && progress.total == 225; };
  const Summary summary = run_mapping(published("house"), results, options);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(verdict_of(summary), "interrupted");
  EXPECT_LT(summary.sim_s, 200.0);
  const auto files = files_in(folder / "run");
  EXPECT_EQ(files.size(), 6u) << "summary, trace, events and the map in three files; no pictures";
  EXPECT_EQ(files.at("trace.csv").back(), '\n');
  EXPECT_EQ(files.at("events.jsonl").back(), '\n');
}

TEST(InterruptedRun, LeavesOutThePicturesThatWereNotDrawnYet) {
  const TemporaryFolder folder;
  robot::RunFolder results(folder / "run", robot::Existing::kRefuse);
  SceneRunOptions options;
  const Scene scene = published("lesson_2x2");
  const double whole_s = run_of(scene).sim_s;
  options.keep_going = [&](const RunProgress& progress) { return progress.sim_s < whole_s; };
  const Summary summary = run_mapping(scene, results, options);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(summary.map->tiles_mapped, 16);
  const auto files = files_in(folder / "run");
  EXPECT_TRUE(files.contains("floorplan.png"));
  EXPECT_FALSE(files.contains("tags_over_time.png"));
}

}  // namespace
}  // namespace sensotwin::twin
