// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

/// One mistake made in kSoundScene, and what the reader must say of it, to the letter.
struct Mistake {
  std::string name;
  std::string find;
  std::string replace;
  std::string message;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) {
  *stream << mistake.replace;
}

/// Keys and alternatives: unknown, twice, missing, or of two minds.
const std::vector<Mistake> kKeyMistakes{
    {"AMisspeltKey", "seed: 7", "sede: 7\nseed: 7",
     "s.yaml:3:1: error: sede: unknown key; expected one of: version, seed, title, world, robot, physics, "
     "mission, expect, time_limit_s (did you mean 'seed'?)"},
    {"AMisspeltKeyInsideASection", "size_m: [1, 0.5]", "size_m: [1, 0.5], mas_kg: 3",
     "s.yaml:8:54: error: world.furniture[0].mas_kg: unknown key; expected one of: name, at_m, heading_deg, "
     "size_m, radius_m, points_m, legs_m, leg_radius_m, height_m, clearance_m, pushable, mass_kg, friction, "
     "tag (did you mean 'mass_kg'?)"},
    {"AKeyThatResemblesNone", "seed: 7", "seed: 7\nweather: rain",
     "s.yaml:4:1: error: weather: unknown key; expected one of: version, seed, title, world, robot, physics, "
     "mission, expect, time_limit_s"},
    {"AKeyGivenTwice", "seed: 7", "seed: 7\nseed: 8",
     "s.yaml:4:1: error: seed: is given twice; it stands in s.yaml:3:1 too"},
    {"ANestedKeyGivenTwice", "heading_deg: 0", "heading_deg: 0, at_m: [2, 1]",
     "s.yaml:10:42: error: robot.start.at_m: is given twice; it stands in s.yaml:10:12 too"},
    {"NoSeed", "seed: 7\n", "",
     "s.yaml:2:1: error: seed: is missing; expected a value (every random stream of the run forks from "
     "this)"},
    {"NoVersion", "version: 1\n", "",
     "s.yaml:2:1: error: version: is missing; expected a value (of this file format: 1)"},
    {"AVersionOfTheFuture", "version: 1", "version: 2", "s.yaml:2:10: error: version: is 2; expected 1"},
    {"AStartWithoutPlace", "at_m: [1, 1], heading", "heading",
     "s.yaml:10:3: error: robot.start.at_m: is missing; expected a value (x and y in the world, m)"},
    {"NeitherRoomNorMap", "  room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }\n", "",
     "s.yaml:4:1: error: world: needs one of: room, map, hallways; none is given"},
    {"BothRoomAndMap", "  carpet:", "  map: { file: m.yaml }\n  carpet:",
     "s.yaml:6:3: error: world.map: does not go with 'room'; leave one of them out"},
    {"FurnitureWithoutShape", ", size_m: [1, 0.5]", "",
     "s.yaml:8:7: error: world.furniture[0]: needs one of: radius_m, size_m, points_m, legs_m; none is "
     "given"},
    {"FurnitureOfTwoShapes", "size_m: [1, 0.5]", "size_m: [1, 0.5], radius_m: 0.3",
     "s.yaml:8:36: error: world.furniture[0].size_m: does not go with 'radius_m'; leave one of them out"},
    {"ALegRadiusWithoutLegs", "size_m: [1, 0.5]", "size_m: [1, 0.5], leg_radius_m: 0.03",
     "s.yaml:8:54: error: world.furniture[0].leg_radius_m: does not go with 'size_m'; leave one of them "
     "out"}};

/// Values of the wrong kind or outside their range.
const std::vector<Mistake> kValueMistakes{
    {"AWordWhereANumberBelongs", "tile_m: 0.5", "tile_m: wide",
     "s.yaml:6:21: error: world.carpet.tile_m: is 'wide'; expected a number from 0.1 to 5"},
    {"ANumberInQuotes", "tile_m: 0.5", "tile_m: \"0.5\"",
     "s.yaml:6:21: error: world.carpet.tile_m: is the text \"0.5\"; expected a number from 0.1 to 5, without "
     "quotes"},
    {"ANumberWithAUnit", "tile_m: 0.5", "tile_m: 0.5m",
     "s.yaml:6:21: error: world.carpet.tile_m: is '0.5m'; expected a number from 0.1 to 5 (the unit is in "
     "the key: write the number alone)"},
    {"ADecimalComma", "expect:", "time_limit_s: 0,5\nexpect:",
     "s.yaml:13:15: error: time_limit_s: is '0,5'; expected a number above 0 and at most 10000000 (the "
     "decimal mark is a point)"},
    {"NotANumber", "heading_deg: 0", "heading_deg: .nan",
     "s.yaml:10:39: error: robot.start.heading_deg: is '.nan'; expected a number from -360 to 360 (it must "
     "be finite)"},
    {"Infinity", "heading_deg: 0", "heading_deg: -.inf",
     "s.yaml:10:39: error: robot.start.heading_deg: is '-.inf'; expected a number from -360 to 360 (it must "
     "be finite)"},
    {"ANumberTooLargeForADouble", "heading_deg: 0", "heading_deg: 1e999",
     "s.yaml:10:39: error: robot.start.heading_deg: is 1e999; expected a number from -360 to 360"},
    {"AnOctalLookingSeed", "seed: 7", "seed: 010",
     "s.yaml:3:7: error: seed: is '010'; expected a whole number from 0 to 18446744073709551615 (a leading "
     "zero means octal to some readers: leave it out)"},
    {"ANegativeSeed", "seed: 7", "seed: -7",
     "s.yaml:3:7: error: seed: is -7; expected a whole number from 0 to 18446744073709551615"},
    {"ABrokenWholeNumber", "expect:", "physics: { steps_per_tick: 2.5 }\nexpect:",
     "s.yaml:13:28: error: physics.steps_per_tick: is 2.5; expected a whole number from 1 to 100"},
    {"OnForTrue", "size_m: [1, 0.5]", "size_m: [1, 0.5], pushable: on",
     "s.yaml:8:64: error: world.furniture[0].pushable: is 'on'; expected true or false"},
    {"ANumberBelowItsRange", "tile_m: 0.5", "tile_m: -0.5",
     "s.yaml:6:21: error: world.carpet.tile_m: is -0.5; expected a number from 0.1 to 5"},
    {"ANumberAboveItsRange", "size_m: [1, 0.5]", "size_m: [1, 0.5], mass_kg: 5000",
     "s.yaml:8:63: error: world.furniture[0].mass_kg: is 5000; expected a number from 0.01 to 1000"},
    {"AHeadingOfManyTurns", "heading_deg: 0", "heading_deg: 720",
     "s.yaml:10:39: error: robot.start.heading_deg: is 720; expected a number from -360 to 360"},
    {"ThreeCoordinates", "at_m: [1, 1]", "at_m: [1, 1, 0]",
     "s.yaml:10:18: error: robot.start.at_m: has 3 of them; expected a list of 2 numbers [x, y]"},
    {"APointThatIsANumber", "at_m: [1, 1]", "at_m: 1",
     "s.yaml:10:18: error: robot.start.at_m: is 1; expected a list of 2 numbers [x, y]"},
    {"ANumberThatIsAList", "tile_m: 0.5", "tile_m: [0.5, 0.5]",
     "s.yaml:6:21: error: world.carpet.tile_m: is a list; expected a number from 0.1 to 5"},
    {"ASectionThatIsAWord", "robot:\n  start: { at_m: [1, 1], heading_deg: 0 }", "robot: fast",
     "s.yaml:9:8: error: robot: is 'fast'; expected a section (key: value)"},
    {"AnEmptySection", "robot:\n  start: { at_m: [1, 1], heading_deg: 0 }",
     "robot:", "s.yaml:9:1: error: robot: is empty; expected a section (key: value)"},
    {"AListThatIsASection", "furniture:\n    - { name: table, at_m: [2, 2], size_m: [1, 0.5] }",
     "furniture: { name: table }",
     "s.yaml:7:14: error: world.furniture: is a section; expected a list of sections"}};

/// What to do and what to expect of it.
const std::vector<Mistake> kMissionMistakes{
    {"AMisspeltExplorer", "explorer: idfm", "explorer: idmf",
     "s.yaml:12:20: error: mission.map.explorer: is 'idmf'; expected one of: bfm, bfm_out_and_back, "
     "bfm_all_neighbours, dfm, idfm, spiral, sweep (did you mean 'idfm'?)"},
    {"AnUnknownPace", "explorer: idfm", "explorer: idfm, pace: papers",
     "s.yaml:12:32: error: mission.map.pace: is 'papers'; expected a section, or the word own or paper (did "
     "you mean 'paper'?)"},
    {"AMissionWithoutKind", "mission:\n  map: { explorer: idfm }", "mission: {}",
     "s.yaml:11:1: error: mission: needs one of: map, phase, hallway; none is given"},
    {"AnExpectationWithoutBounds", "{ min: 1 }", "{}",
     "s.yaml:14:3: error: expect.tiles_mapped: needs min or max or mean or median or quantile_2_5 or "
     "quantile_5 or quantile_95 or quantile_97_5; none is given"},
    {"AStatisticOverSeedsWithoutBounds", "{ min: 1 }", "{ median: {} }",
     "s.yaml:14:19: error: expect.tiles_mapped.median: needs min or max; none is given"},
    {"AMisspeltStatistic", "{ min: 1 }", "{ min: 1, medain: { min: 1 } }",
     "s.yaml:14:27: error: expect.tiles_mapped.medain: unknown key; expected one of: min, max, rate, mean, "
     "median, quantile_2_5, quantile_5, quantile_95, quantile_97_5 (did you mean 'median'?)"},
    {"AStatisticNobodyCanMeet", "{ min: 1 }", "{ mean: { min: 9, max: 3 } }",
     "s.yaml:14:25: error: expect.tiles_mapped.mean: min 9 is above max 3; no run can keep both"},
    {"ARateOfNothing", "{ min: 1 }", "{ mean: { min: 1 }, rate: { min: 0.9 } }",
     "s.yaml:14:43: error: expect.tiles_mapped.rate: there is no limit for it; expected min or max beside "
     "it"},
    {"ARateInPerCent", "{ min: 1 }", "{ min: 1, rate: { min: 95 } }",
     "s.yaml:14:40: error: expect.tiles_mapped.rate.min: is 95; expected a number above 0 and at most 1"},
    {"AnExpectationNobodyCanMeet", "{ min: 1 }", "{ min: 9, max: 3 }",
     "s.yaml:14:3: error: expect.tiles_mapped: min 9 is above max 3; no run can keep both"},
    {"AnExpectationWithACapital", "tiles_mapped", "TilesMapped",
     "s.yaml:14:3: error: expect.TilesMapped: is no name; expected small letters, digits, _ and ."}};

/// Walls, start and furniture that cannot be where they are.
const std::vector<Mistake> kPlaceMistakes{
    {"ARoomOfTwoCorners", "[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [4, 0]]",
     "s.yaml:5:20: error: world.room.walls_m: has 2 of them; expected a list of 3 to 10000 points [x, y]"},
    {"AWallThatCrossesItself", "[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [4, 3], [4, 0], [0, 3]]",
     "s.yaml:5:20: error: world.room.walls_m: the outer wall crosses or touches itself; expected the corners "
     "in order around the room, each once"},
    {"AWallWithACornerTwice", "[[0, 0], [4, 0], [4, 3], [0, 3]]",
     "[[0, 0], [4, 0], [4, 0.004], [4, 3], [0, 3]]",
     "s.yaml:5:20: error: world.room.walls_m: two corners at [4, 0] are 0.004 m apart; expected at least "
     "0.01 m"},
    {"ARoomWithoutArea", "[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]",
     "s.yaml:5:20: error: world.room.walls_m: the room has 0.040 m2; expected at least 0.1 m2"},
    {"AStartOutsideTheRoom", "at_m: [1, 1]", "at_m: [5, 1]",
     "s.yaml:10:18: error: robot.start.at_m: [5, 1] m is not on the floor; expected a place inside the "
     "walls"},
    {"AStartInAWall", "at_m: [1, 1]", "at_m: [0.1, 1]",
     "s.yaml:10:18: error: robot.start.at_m: is 0.100 m from a wall; expected the robot's radius, 0.17 m, "
     "free all round"},
    {"AStartInFurniture", "at_m: [1, 1]", "at_m: [2, 2.1]",
     "s.yaml:10:18: error: robot.start.at_m: is inside furniture 'table'; expected the robot's radius, 0.17 "
     "m, free all round"},
    {"AStartTooNearFurniture", "at_m: [1, 1]", "at_m: [2, 1.65]",
     "s.yaml:10:18: error: robot.start.at_m: is 0.100 m from furniture 'table'; expected the robot's radius, "
     "0.17 m, free all round"},
    {"AStartOverAHole",
     "  furniture:", "  cliffs: [{ corners_m: [[0.5, 0.5], [1.5, 0.5], [1, 1.5]] }]\n  furniture:",
     "s.yaml:11:18: error: robot.start.at_m: is over world.cliffs[0]; expected floor under the robot"},
    {"FurnitureOutsideTheRoom", "at_m: [2, 2]", "at_m: [3.8, 2]",
     "s.yaml:8:7: error: world.furniture[0]: 'table' reaches [4.3, 1.75] m, where no floor is; expected it "
     "to stand inside the walls"},
    {"FurnitureThatIsNotConvex", "size_m: [1, 0.5]", "points_m: [[0, 0], [1, 0], [0.2, 0.2], [0, 1]]",
     "s.yaml:8:46: error: world.furniture[0].points_m: the polygon is not convex; expected corners that all "
     "turn the same way; split it into several"},
    {"FurnitureOfNineCorners", "size_m: [1, 0.5]",
     "points_m: [[0,0],[1,0],[2,1],[2,2],[1,3],[0,3],[-1,2],[-1,1],[-0.5,0.2]]",
     "s.yaml:8:46: error: world.furniture[0].points_m: has 9 of them; expected a list of 3 to 8 points [x, "
     "y]"},
    {"TwoPiecesOfOneName", "size_m: [1, 0.5] }",
     "size_m: [1, 0.5] }\n    - { name: table, at_m: [3, 1], radius_m: 0.2 }",
     "s.yaml:9:15: error: world.furniture[1].name: 'table' is the name of world.furniture[0] too; expected a "
     "name of its own"}};

/// The carpet, and the rest of the world.
const std::vector<Mistake> kCarpetMistakes{
    {"ACarpetWithoutTile", "tile_m: 0.5", "tile_m: 0.5, region_m: [[5, 5], [6, 6]]",
     "s.yaml:6:11: error: world.carpet: has no tile; expected at least one tile whose middle lies on the "
     "floor"},
    {"ACarpetOfTinyTilesInAHugeHall", "walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]]",
     "walls_m: [[0, 0], [900, 0], [900, 900], [0, 900]]",
     "s.yaml:6:11: error: world.carpet: 3240000 tiles of 0.5 m would be laid; expected at most 100000: is "
     "tile_m right?"},
    {"ATileOutsideTheRoom", "tile_m: 0.5", "tile_m: 0.5, tiles: [[0, 0], [9, 0]]",
     "s.yaml:6:42: error: world.carpet.tiles[1]: the middle of [9, 0] is at [4.75, 0.25] m, where no floor "
     "is; expected tiles whose tag lies on the floor"},
    {"ATileListedTwice", "tile_m: 0.5", "tile_m: 0.5, tiles: [[0, 0], [1, 0], [0, 0]]",
     "s.yaml:6:50: error: world.carpet.tiles[2]: [0, 0] is listed twice; expected each tile once"},
    {"ADeadTagThatIsNotThere", "tile_m: 0.5", "tile_m: 0.5, unreadable: [[8, 0]]",
     "s.yaml:6:39: error: world.carpet.unreadable[0]: there is no tile [8, 0]; expected [column, row] of a "
     "tile that is laid"},
    {"NothingToMap", "carpet: { tile_m: 0.5 }", "carpet: none",
     "s.yaml:6:11: error: world.carpet: is none, but the mission is to map the carpet; expected a carpet, or "
     "another mission"},
    {"ALandmarkOutside",
     "  furniture:", "  landmarks: [{ kind: power_outlet, at_m: [4.5, 1] }]\n  furniture:",
     "s.yaml:7:43: error: world.landmarks[0].at_m: [4.5, 1] m is not on the floor; expected a place inside "
     "the walls"},
    {"AnOverfullBattery", "robot:", "robot:\n  base: { battery_charge_mah: 3000 }",
     "s.yaml:10:31: error: robot.base.battery_charge_mah: 3000 mAh do not fit a battery of 2696 mAh; "
     "expected at most battery_capacity_mah"}};

/// What is no YAML, or more of it than a scene holds; and the map beside it.
const std::vector<Mistake> kYamlMistakes{
    {"ATabForIndent", "  room:", "\troom:",
     "s.yaml:5:6: error: not YAML: illegal map value; indent with spaces, not tabs, and put a space after "
     "each colon"},
    {"AnUnclosedBracket", "[0, 3]] }", "[0, 3] }",
     "s.yaml:5:52: error: not YAML: illegal flow end; check indentation, brackets and quotes up to here"},
    {"AnAlias", "heading_deg: 0", "heading_deg: *north",
     "s.yaml:10:39: error: not YAML: the referenced anchor is not defined; check indentation, brackets and "
     "quotes up to here"},
    {"AnAnchor", "heading_deg: 0", "heading_deg: &north 0",
     "s.yaml:10:39: error: an anchor (&name) is not supported; write the value out: a scene holds no "
     "references"},
    {"AMergeKey", "heading_deg: 0", "heading_deg: 0, <<: { x: 1 }",
     "s.yaml:10:42: error: a merge key (<<) is not supported; write the keys out: a scene holds no "
     "references"},
    {"ATag", "heading_deg: 0", "heading_deg: !!float 0",
     "s.yaml:10:39: error: the tag 'tag:yaml.org,2002:float' is not supported; write the value without a "
     "tag"},
    {"ASecondDocument", "expect:\n  tiles_mapped: { min: 1 }\n", "---\nversion: 1\n",
     "s.yaml:14:1: error: a second document; one file holds one scene"},
    {"AMapThatIsNotThere", "room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }",
     "map: { file: nowhere.yaml }",
     "s.yaml:5:16: error: world.map.file: nowhere.yaml: no such file; expected a map"}};

class BrokenScene : public testing::TestWithParam<Mistake> {};

TEST_P(BrokenScene, IsRefusedWithItsPlaceAndWhatWasExpected) {
  EXPECT_EQ(messages(edited(kSoundScene, GetParam().find, GetParam().replace)), GetParam().message);
}

std::string name_of_case(const testing::TestParamInfo<Mistake>& mistake) {
  return mistake.param.name;
}

INSTANTIATE_TEST_SUITE_P(Keys, BrokenScene, testing::ValuesIn(kKeyMistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Values, BrokenScene, testing::ValuesIn(kValueMistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Missions, BrokenScene, testing::ValuesIn(kMissionMistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Places, BrokenScene, testing::ValuesIn(kPlaceMistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Carpets, BrokenScene, testing::ValuesIn(kCarpetMistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Yaml, BrokenScene, testing::ValuesIn(kYamlMistakes), name_of_case);

TEST(BrokenScenes, AreAllNamedInOnePass) {
  EXPECT_EQ(messages(R"(version: 1
world:
  room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }
  carpet: { tile_m: 0.5, colour: red }
robot:
  start: { at_m: [9, 9], heading_deg: 0 }
  compass: { rate_hz: .nan }
mission:
  map: { explorer: dmf }
)"),
            "s.yaml:1:1: error: seed: is missing; expected a value (every random stream of the run forks "
            "from this)\n"
            "s.yaml:4:26: error: world.carpet.colour: unknown key; expected one of: tile_m, origin_m, "
            "region_m, tiles, without, unreadable, tag_offset_sigma_m\n"
            "s.yaml:6:18: error: robot.start.at_m: [9, 9] m is not on the floor; expected a place inside the "
            "walls\n"
            "s.yaml:7:23: error: robot.compass.rate_hz: is '.nan'; expected a number from 0.1 to 66 (it must "
            "be finite)\n"
            "s.yaml:9:20: error: mission.map.explorer: is 'dmf'; expected one of: bfm, bfm_out_and_back, "
            "bfm_all_neighbours, dfm, idfm, spiral, sweep (did you mean 'dfm'?)");
}

TEST(BrokenScenes, AreNamedUpToTwentyMistakes) {
  std::string text = kSoundScene;
  for (int i = 0; i < 50; ++i) {
    text += "extra" + std::to_string(i) + ": 1\n";
  }
  try {
    (void)read_scene_text(text, "s.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.problems().size(), 20u);
    EXPECT_EQ(error.problems().front().path, "extra0");
    EXPECT_EQ(error.exit_code(), robot::kExitInvalid);
  }
}

TEST(BrokenScenes, ThatAreEmptySayWhatASceneHolds) {
  EXPECT_EQ(messages(""), "s.yaml:1:1: error: the file holds no scene; expected version, seed, world ...");
  EXPECT_EQ(messages("# only a comment\n"),
            "s.yaml:1:1: error: the file holds no scene; expected version, seed, world ...");
  EXPECT_EQ(messages("- 1\n- 2\n"), "s.yaml:1:1: error: is a list; expected keys: version, seed, world ...");
  EXPECT_EQ(messages("just words\n"),
            "s.yaml:1:1: error: is 'just words'; expected keys: version, seed, world ...");
}

TEST(BrokenScenes, ThatAreNotThereEndInExitCode66) {
  try {
    (void)read_scene("no/such/scene.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_STREQ(error.what(), "no/such/scene.yaml: error: no such file; expected a scene");
    EXPECT_EQ(error.exit_code(), robot::kExitMissing);
  }
}

TEST(BrokenScenes, ThatNameAMissingMapEndInExitCode66) {
  try {
    (void)read_scene_text("version: 1\nseed: 1\nworld: { map: { file: gone.yaml } }\n", "scenes/s.yaml");
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_STREQ(error.what(),
                 "scenes/s.yaml:3:23: error: world.map.file: scenes/gone.yaml: no such file; expected a map");
    EXPECT_EQ(error.exit_code(), robot::kExitMissing);
  }
}

TEST(BrokenScenes, NeverCrashTheReaderWhateverBytesTheyAre) {
  // Every prefix of a sound scene, and the scene with each byte replaced by each of a few awkward ones.
  for (std::size_t n = 0; n < kSoundScene.size(); ++n) {
    (void)messages(kSoundScene.substr(0, n));
    for (const char byte : {'\0', '\t', '{', ']', '"', '-', ':', '\xff', '9'}) {
      std::string text = kSoundScene;
      text[n] = byte;
      (void)messages(text);
    }
  }
}

}  // namespace
}  // namespace sensotwin::twin
