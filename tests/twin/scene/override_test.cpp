// SPDX-License-Identifier: MIT
#include "twin/scene/override.hpp"

#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

Scene read_with(const std::vector<std::string>& set) {
  return read_scene_text(kSoundScene, "s.yaml", {set, std::nullopt});
}

TEST(Override, ReplacesAValue) {
  EXPECT_EQ(read_with({"mission.map.explorer=dfm"}).mission.map->explorer, robot::ExplorerKind::kDfm);
}

TEST(Override, ReachesIntoAList) {
  EXPECT_EQ(read_with({"world.furniture[0].mass_kg=4"}).world.furniture[0].mass_kg, 4.0);
}

TEST(Override, MakesTheSectionsThatTheFileLeavesOut) {
  EXPECT_EQ(read_with({"robot.base.kind=roomba400"}).robot.base.kind, world::RoombaKind::kRoomba400);
}

TEST(Override, TakesListsAndSections) {
  const Scene scene = read_with({"robot.start.at_m=[3, 1]", "mission.map.pace={ tile_s: 2, tag_s: 1 }"});
  EXPECT_EQ(scene.robot.X_WR_start.p_m, Vec2(3.0, 1.0));
  EXPECT_EQ(scene.mission.map->pace.tile_s, 2.0);
}

TEST(Override, OfALaterOptionWins) {
  EXPECT_EQ(read_with({"seed=1", "seed=2"}).seed, 2u);
}

TEST(Override, OfTheSeedWinsOverTheFile) {
  EXPECT_EQ(read_scene_text(kSoundScene, "s.yaml", {{}, 99u}).seed, 99u);
}

TEST(Override, ServesASceneThatForgotItsSeed) {
  EXPECT_EQ(read_scene_text(edited(kSoundScene, "seed: 7\n", ""), "s.yaml", {{}, 99u}).seed, 99u);
}

TEST(Override, OfAnUnknownKeyIsNamedByTheOption) {
  EXPECT_EQ(messages(kSoundScene, {{"mission.map.explorr=dfm"}, {}}),
            "--set mission.map.explorr=dfm: error: mission.map.explorr: unknown key; expected one of: "
            "explorer, pace "
            "(did you mean 'explorer'?)");
}

TEST(Override, OfAWrongValueIsNamedByTheOption) {
  EXPECT_EQ(messages(kSoundScene, {{"robot.base.mass_kg=heavy"}, {}}),
            "--set robot.base.mass_kg=heavy: error: robot.base.mass_kg: is 'heavy'; expected a number from "
            "0.1 to 50");
}

TEST(Override, OfAnItemThatIsNotThereIsNamedByTheOption) {
  EXPECT_EQ(
      messages(kSoundScene, {{"world.furniture[3].mass_kg=4"}, {}}),
      "--set world.furniture[3].mass_kg=4: error: world.furniture: has no item 3; it has 1, counted from 0");
}

TEST(Override, BelowAWordIsNamedByTheOption) {
  EXPECT_EQ(messages(kSoundScene, {{"mission.map.explorer.kind=dfm"}, {}}),
            "--set mission.map.explorer.kind=dfm: error: mission.map.explorer: is 'idfm' in the file; only a "
            "section "
            "has a key 'kind'");
}

TEST(Override, WithoutAnEqualsSignIsAMistakeOfTheCommandLine) {
  try {
    (void)read_with({"mission.map.explorer"});
    FAIL();
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), robot::kExitUsage);
    EXPECT_STREQ(error.what(),
                 "--set mission.map.explorer: error: is no assignment; expected key.path=value, such as "
                 "mission.map.explorer=dfm");
  }
}

TEST(Override, MistakesComeAfterThoseOfTheFile) {
  EXPECT_EQ(messages(edited(kSoundScene, "tile_m: 0.5", "tile_m: 50"), {{"robot.base.mass_kg=0"}, {}}),
            "s.yaml:6:21: error: world.carpet.tile_m: is 50; expected a number from 0.1 to 5\n"
            "--set robot.base.mass_kg=0: error: robot.base.mass_kg: is 0; expected a number from 0.1 to 50");
}

}  // namespace
}  // namespace sensotwin::twin
