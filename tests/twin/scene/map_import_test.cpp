// SPDX-License-Identifier: MIT
#include "twin/scene/map_import.hpp"

#include <gtest/gtest.h>

#include "map_files.hpp"
#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

/// What reading a map of this YAML, beside the picture `bytes`, ends in; the folder's name is cut out.
std::string map_message(const std::string& map_yaml, const std::string& bytes, int& exit_code) {
  const TemporaryFolder folder;
  save(folder / "map.pgm", bytes);
  save(folder / "map.yaml", map_yaml);
  exit_code = 0;
  try {
    (void)read_map(folder / "map.yaml");
    return "no error";
  } catch (const robot::LoadError& error) {
    exit_code = error.exit_code();
    std::string text = error.what();
    const std::string name = folder.path().string() + "/";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
      text.erase(at, name.size());
    }
    return text;
  }
}

std::string invalid(const std::string& find, const std::string& replace) {
  int exit_code = 0;
  const std::string text = map_message(edited(kMapYaml, find, replace), drawn({".."}), exit_code);
  EXPECT_EQ(exit_code, robot::kExitInvalid);
  return text;
}

TEST(MapImport, TellsWallFreeAndUnknownByTheTrinaryRule) {
  const OccupancyMap map = drawn_map({"#.?"});
  EXPECT_EQ(map.at(0, 0), Cell::kOccupied);
  EXPECT_EQ(map.at(1, 0), Cell::kFree);
  EXPECT_EQ(map.at(2, 0), Cell::kUnknown);
}

TEST(MapImport, PutsTheTopRowOfThePictureAtTheLargestY) {
  const OccupancyMap map = drawn_map({"#.", ".."});
  EXPECT_EQ(map.at(Vec2{0.25, 0.75}), Cell::kOccupied);
  EXPECT_EQ(map.at(Vec2{0.25, 0.25}), Cell::kFree);
}

TEST(MapImport, TakesWhatLiesBeyondThePictureAsUnknown) {
  const OccupancyMap map = drawn_map({".."});
  EXPECT_EQ(map.at(Vec2{-0.01, 0.1}), Cell::kUnknown);
  EXPECT_EQ(map.at(Vec2{1.01, 0.1}), Cell::kUnknown);
  EXPECT_EQ(map.at(Vec2{1.0e300, 0.1}), Cell::kUnknown);
}

TEST(MapImport, TurnsTheMapByTheYawOfItsOrigin) {
  // A quarter turn: the picture's x runs along the world's +y.
  const OccupancyMap map =
      drawn_map({"#."}, edited(kMapYaml, "[0.0, 0.0, 0.0]", "[10.0, 20.0, 1.5707963267948966]"));
  EXPECT_EQ(map.at(Vec2{9.75, 20.25}), Cell::kOccupied);
  EXPECT_EQ(map.at(Vec2{9.75, 20.75}), Cell::kFree);
}

TEST(MapImport, NegatesWhenTold) {
  const OccupancyMap map = drawn_map({"#."}, edited(kMapYaml, "negate: 0", "negate: 1"));
  EXPECT_EQ(map.at(0, 0), Cell::kFree);
  EXPECT_EQ(map.at(1, 0), Cell::kOccupied);
}

TEST(MapImport, ObeysItsThresholds) {
  // Grey 205 is p = 0.196078: free when free_thresh says 0.25, as slam_toolbox writes it.
  EXPECT_EQ(drawn_map({"?"}, edited(kMapYaml, "0.196", "0.25")).at(0, 0), Cell::kFree);
  EXPECT_EQ(drawn_map({"?"}, edited(edited(kMapYaml, "0.65", "0.15"), "0.196", "0.1")).at(0, 0),
            Cell::kOccupied);
}

TEST(MapImport, AcceptsWhatMapServersWrite) {
  EXPECT_EQ(drawn_map({"."}, kMapYaml + "mode: trinary\n").columns, 1);
  EXPECT_EQ(drawn_map({"."}, kMapYaml + "mode: scale\n").columns, 1);
  EXPECT_EQ(drawn_map({"."}, kMapYaml + "author: nobody\n").columns, 1);
  EXPECT_EQ(drawn_map({"."}, edited(kMapYaml, "[0.0, 0.0, 0.0]", "[-1, +.5, 0.]")).X_WO.p_m, Vec2(-1.0, 0.5));
  EXPECT_EQ(drawn_map({"."}, edited(kMapYaml, "map.pgm", "\"map.pgm\"")).columns, 1);
}

TEST(MapImport, RefusesAnOriginThatIsNotANumber) {
  EXPECT_EQ(invalid("[0.0, 0.0, 0.0]", "[.nan, 0.0, 0.0]"),
            "map.yaml:3:10: error: origin[0]: is '.nan'; expected a finite number from -1000 to 1000 (m)");
  EXPECT_EQ(invalid("[0.0, 0.0, 0.0]", "[0.0, nan, 0.0]"),
            "map.yaml:3:15: error: origin[1]: is 'nan'; expected a finite number from -1000 to 1000 (m)");
  EXPECT_EQ(invalid("[0.0, 0.0, 0.0]", "[0.0, 0.0, inf]"),
            "map.yaml:3:20: error: origin[2]: is 'inf'; expected a finite number (rad)");
}

TEST(MapImport, RefusesAnOriginWithoutYaw) {
  EXPECT_EQ(invalid("[0.0, 0.0, 0.0]", "[0.0, 0.0]"),
            "map.yaml:3:9: error: origin: is a list; expected [x, y, yaw] of the picture's lower left "
            "corner, m and rad");
}

TEST(MapImport, RefusesAnAbsurdResolution) {
  EXPECT_EQ(invalid("0.5", "0"),
            "map.yaml:2:13: error: resolution: is 0; expected metres a cell, from 0.01 to 1");
  EXPECT_EQ(invalid("0.5", "-0.05"),
            "map.yaml:2:13: error: resolution: is -0.05; expected metres a cell, from 0.01 to 1");
  EXPECT_EQ(invalid("0.5", "fine"),
            "map.yaml:2:13: error: resolution: is 'fine'; expected metres a cell, from 0.01 to 1");
}

TEST(MapImport, RefusesThresholdsThatOverlap) {
  EXPECT_EQ(invalid("0.196", "0.9"),
            "map.yaml:6:14: error: free_thresh: is above occupied_thresh; a cell would be free and occupied");
}

TEST(MapImport, RefusesTheRawMode) {
  EXPECT_EQ(invalid("negate: 0", "negate: 0\nmode: raw"),
            "map.yaml:5:7: error: mode: is 'raw'; expected trinary or scale (raw holds no walls that we "
            "could tell)");
}

TEST(MapImport, NamesEveryKeyThatIsMissing) {
  EXPECT_EQ(invalid("image: map.pgm\nresolution: 0.5\n", ""),
            "map.yaml:1:1: error: image: is missing; expected the picture's file, relative to this one\n"
            "map.yaml:1:1: error: resolution: is missing; expected metres a cell, from 0.01 to 1");
}

TEST(MapImport, RefusesATruncatedPgm) {
  int exit_code = 0;
  EXPECT_EQ(map_message(kMapYaml, "P5\n313 375\n255\nabc", exit_code),
            "map.yaml:1:8: error: image: map.pgm is cut off: 3 bytes of pixels where 117375 are needed; "
            "expected a whole "
            "PGM or PNG");
  EXPECT_EQ(exit_code, robot::kExitInvalid);
}

TEST(MapImport, RefusesAnEmptyPicture) {
  int exit_code = 0;
  EXPECT_EQ(map_message(kMapYaml, "", exit_code),
            "map.yaml:1:8: error: image: map.pgm is empty (0 bytes); expected a whole PGM or PNG");
  EXPECT_EQ(exit_code, robot::kExitInvalid);
}

TEST(MapImport, ReportsAMissingPictureWithExitCode66) {
  int exit_code = 0;
  EXPECT_EQ(map_message(edited(kMapYaml, "map.pgm", "gone.png"), "", exit_code),
            "map.yaml:1:8: error: image: gone.png: no such file; expected a picture");
  EXPECT_EQ(exit_code, robot::kExitMissing);
}

TEST(MapImport, ReportsAMissingMapWithExitCode66) {
  try {
    (void)read_map("no/such/map.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), robot::kExitMissing);
    EXPECT_STREQ(error.what(), "no/such/map.yaml: error: no such file; expected a map");
  }
}

TEST(MapImport, ReportsAPictureGivenInPlaceOfTheMap) {
  int exit_code = 0;
  const std::string text = map_message(drawn({".."}), "", exit_code);
  EXPECT_EQ(exit_code, robot::kExitInvalid);
  EXPECT_EQ(text.find("map.yaml:"), 0u) << text;
}

TEST(MapImport, MakesASceneWhoseErrorsNameTheMapsFile) {
  const TemporaryFolder folder;
  save(folder / "map.yaml", edited(kMapYaml, "0.5", "nan"));
  try {
    (void)read_scene_text("version: 1\nseed: 1\nworld: { map: { file: map.yaml } }\ntime_limit_s: 0\n",
                          folder / "s.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    ASSERT_EQ(error.problems().size(), 2u);
    EXPECT_EQ(error.problems()[0].place.source, (folder / "s.yaml").string());
    EXPECT_EQ(error.problems()[1].place.source, (folder / "map.yaml").string());
    EXPECT_EQ(error.problems()[1].place.line, 2);
  }
}

TEST(MapImport, RefusesAMapWithoutFloor) {
  const TemporaryFolder folder;
  save(folder / "map.pgm", drawn({"##", "??"}));
  save(folder / "map.yaml", kMapYaml);
  try {
    (void)read_scene_text("version: 1\nseed: 1\nworld: { map: { file: map.yaml } }\n", folder / "s.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    ASSERT_EQ(error.problems().size(), 1u);
    EXPECT_EQ(error.problems()[0].what, "the map has no free cell");
  }
}

TEST(MapImport, CarpetsTheFloorAndStartsOnIt) {
  const TemporaryFolder folder;
  save(folder / "map.pgm", drawn({"######", "#....#", "#..?.#", "#....#", "######"}));
  save(folder / "map.yaml", kMapYaml);
  const Scene scene =
      read_scene_text("version: 1\nseed: 1\nworld: { map: { file: map.yaml }, carpet: { tile_m: 0.5 } }\n",
                      folder / "s.yaml");
  EXPECT_EQ(scene.world.carpet.tiles.size(), 11u);
  EXPECT_EQ(scene.world.walls.size(), 2u);
  EXPECT_EQ(scene.world.carpet.origin_m, Vec2(0.5, 0.5));
  // Free space spans 0.5..2.5 by 0.5..2.0; tile middles with 0.22 m around them; nearest to the middle
  // (1.5, 1.25)
  EXPECT_NEAR((scene.robot.X_WR_start.p_m - Vec2(1.25, 1.25)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace sensotwin::twin
