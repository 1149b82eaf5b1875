// SPDX-License-Identifier: MIT
// The commands beside `run`, each as a process on real files.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/scene/scene_writer.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;

const std::string kScenes = std::string(SENSOTWIN_SOURCE_DIR) + "/scenes/";

std::string quoted(const std::filesystem::path& path) {
  return "'" + path.string() + "'";
}

bool is_png(const std::filesystem::path& file) {
  return content_of(file).starts_with("\x89PNG\r\n\x1a\n");
}

TEST(ShowProcess, PrintsASceneThatReadsBackTheSame) {
  const Outcome outcome = twin("show '" + kScenes + "house.yaml' --seed 9 --set mission.map.explorer=dfm");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  const Scene scene = read_scene_text(outcome.out, kScenes + "house.yaml");
  EXPECT_EQ(scene.seed, 9u);
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kDfm);
  EXPECT_EQ(scene_yaml(scene), outcome.out);
}

TEST(ShowProcess, GivesDefaultsThatTheFileLeavesOut) {
  EXPECT_THAT(twin("show '" + kScenes + "lesson_2x2.yaml'").out, HasSubstr("read_radius_m: 0.08"));
}

TEST(BoundProcess, SaysLegByLegWhatNoEstimatorCanGoBelow) {
  const Outcome outcome = twin("bound '" + kScenes + "line_at_90.yaml' --variant own_slow");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("not counted"));
  EXPECT_THAT(outcome.out, HasSubstr("bound_m"));
  const auto json =
      nlohmann::json::parse(twin("bound '" + kScenes + "line_at_90.yaml' --variant own_slow --json").out);
  EXPECT_EQ(json["variant"], "own_slow");
  EXPECT_EQ(json["legs"][0]["to"], "B");
  EXPECT_NEAR(json["bound_m"].get<double>(), 0.0072, 0.0012);
}

TEST(BoundProcess, RefusesASceneWithoutCeilingTags) {
  const Outcome outcome = twin("bound '" + kScenes + "house.yaml'");
  EXPECT_EQ(outcome.code, 65);
  EXPECT_THAT(outcome.err, HasSubstr("no path along ceiling tags"));
}

TEST(ListProcess, NamesEveryExplorer) {
  const auto json = nlohmann::json::parse(twin("list explorers --json").out);
  std::vector<std::string> names;
  for (const auto& entry : json) {
    names.push_back(entry["name"]);
    EXPECT_NE(entry["summary"], "");
  }
  for (const char* name : {"bfm", "dfm", "idfm", "spiral", "sweep"}) {
    EXPECT_THAT(names, ::testing::Contains(name));
  }
}

TEST(RenderProcess, DrawsASceneFromAboveAndAtAnAngle) {
  const TemporaryFolder folder;
  for (const char* view : {"top", "oblique"}) {
    const auto picture = folder / (std::string(view) + ".png");
    const Outcome outcome = twin("render '" + kScenes + "lesson_2x2.yaml' --width-px 400 --view " + view +
                                 " --out " + quoted(picture));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, picture.string() + "\n");
    EXPECT_TRUE(is_png(picture));
  }
}

TEST(RenderProcess, ReplacesAPictureOnlyWhenForced) {
  const TemporaryFolder folder;
  std::ofstream{folder / "top.png"} << "mine";
  const std::string line =
      "render '" + kScenes + "lesson_2x2.yaml' --width-px 400 --out " + quoted(folder / "top.png");
  EXPECT_EQ(twin(line).code, 73);
  EXPECT_EQ(content_of(folder / "top.png"), "mine");
  EXPECT_EQ(twin(line + " --force").code, 0);
  EXPECT_TRUE(is_png(folder / "top.png"));
}

TEST(ChartProcess, DrawsTheRunsOfSeveralExplorersOnOneChart) {
  const TemporaryFolder folder;
  std::string runs;
  for (const char* explorer : {"idfm", "sweep"}) {
    const std::string run = quoted(folder / explorer);
    ASSERT_EQ(twin("-q run '" + kScenes +
                   "lesson_2x2.yaml' --no-pictures --set mission.map.explorer=" + explorer + " --out " + run)
                  .code,
              0);
    runs += " " + run;
  }
  const Outcome outcome = twin("chart" + runs + " --out " + quoted(folder / "chart.png"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(is_png(folder / "chart.png"));
}

TEST(ChartProcess, SaysWhichFolderIsNoRun) {
  const TemporaryFolder folder;
  const Outcome outcome = twin("chart " + quoted(folder.path()) + " --out " + quoted(folder / "chart.png"));
  EXPECT_EQ(outcome.code, 66);
  EXPECT_THAT(outcome.err, HasSubstr("is this the folder of a run?"));
  EXPECT_FALSE(std::filesystem::exists(folder / "chart.png"));
}

TEST(ChartProcess, SaysWhichLineOfARunIsNoEvent) {
  const TemporaryFolder folder;
  const auto run = folder / "run";
  ASSERT_EQ(twin("-q run '" + kScenes + "lesson_2x2.yaml' --no-pictures --out " + quoted(run)).code, 0);
  std::ofstream{run / "events.jsonl", std::ios::trunc} << "{\"t_s\":0.1,\"event\":\"bump\"}\nnonsense\n";
  const Outcome outcome = twin("chart " + quoted(run) + " --out " + quoted(folder / "chart.png"));
  EXPECT_EQ(outcome.code, 65);
  EXPECT_THAT(outcome.err, HasSubstr("events.jsonl:2: no event"));
}

/// A flat of 3 m by 2 m as map_server keeps it, 10 cm a cell.
void draw_flat(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string pgm = "P5\n32 22\n255\n";
  for (int row = 0; row < 22; ++row) {
    for (int column = 0; column < 32; ++column) {
      const bool wall = row == 0 || row == 21 || column == 0 || column == 31;
      pgm += static_cast<char>(wall ? 0 : 254);
    }
  }
  std::ofstream{folder / "map.pgm", std::ios::binary} << pgm;
  std::ofstream{folder / "map.yaml"}
      << "image: map.pgm\nresolution: 0.1\norigin: [-1.0, -2.0, 0.0]\nnegate: 0\n"
         "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

TEST(ImportProcess, MakesASceneThatRuns) {
  const TemporaryFolder folder;
  draw_flat(folder / "flat");
  const Outcome outcome =
      twin("import " + quoted(folder / "flat/map.yaml") + " --out " + quoted(folder / "flat.yaml"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("6 m2 of floor"));
  const Outcome run = twin("-q run " + quoted(folder / "flat.yaml") + " --no-pictures --json --out " +
                           quoted(folder / "run"));
  EXPECT_EQ(run.code, 0) << run.err << run.out;
  const auto summary = nlohmann::json::parse(run.out);
  EXPECT_EQ(summary["map"]["tiles_missed"], 0);
  EXPECT_GE(summary["map"]["tiles_mapped"], 15);
}

TEST(ImportProcess, MakesASceneOfTheMapThatARunDrew) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      twin("-q run '" + kScenes + "lesson_2x2.yaml' --no-pictures --out " + quoted(folder / "run")).code, 0);
  EXPECT_EQ(
      twin("import " + quoted(folder / "run/map.yaml") + " --out " + quoted(folder / "again.yaml")).code, 0);
  EXPECT_EQ(twin("show " + quoted(folder / "again.yaml")).code, 0);
}

TEST(ImportProcess, RefusesWhatIsNoMapAndKeepsWhatIsThere) {
  const TemporaryFolder folder;
  draw_flat(folder / "flat");
  std::ofstream{folder / "scene.yaml"} << "mine";
  const std::string to = " --out " + quoted(folder / "scene.yaml");
  EXPECT_EQ(twin("import " + quoted(folder / "none.yaml") + to + " --force").code, 66);
  EXPECT_EQ(twin("import " + quoted(folder / "flat/map.yaml") + to).code, 73);
  std::filesystem::resize_file(folder / "flat/map.pgm", 100);
  const Outcome truncated = twin("import " + quoted(folder / "flat/map.yaml") + to + " --force");
  EXPECT_EQ(truncated.code, 65);
  EXPECT_EQ(std::count(truncated.err.begin(), truncated.err.end(), '\n'), 1) << truncated.err;
  EXPECT_EQ(content_of(folder / "scene.yaml"), "mine");
}

TEST(EpsilonProcess, PrintsTheTableAndKeepsAllCells) {
  const TemporaryFolder folder;
  const Outcome outcome =
      twin("-q epsilon --maps 2 --explorer idfm --explorer spiral --out " + quoted(folder / "cells.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 maps in each of 96 cells"));
  EXPECT_THAT(outcome.out, HasSubstr("\nidfm\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nspiral\n"));
  const std::string csv = content_of(folder / "cells.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 96);
  EXPECT_TRUE(csv.starts_with("explorer,blocked_percent,chunks,"));
}

TEST(EpsilonProcess, DoesNotDependOnItsThreads) {
  const std::string study = "-q epsilon --maps 2 --explorer idfm --json --jobs ";
  EXPECT_EQ(twin(study + "1").out, twin(study + "3").out);
}

TEST(EpsilonProcess, NamesTheExplorerThatDoesNotExist) {
  const Outcome outcome = twin("epsilon --maps 1 --explorer sideways");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("'sideways'"));
}

}  // namespace
}  // namespace sensotwin::twin
