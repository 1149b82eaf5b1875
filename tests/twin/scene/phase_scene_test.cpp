// SPDX-License-Identifier: MIT
// Ceiling tags, radio and missions along them in scenes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scene_texts.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin/scene/scene_writer.hpp"
#include "world/radio/profiles.hpp"

namespace sensotwin::twin {
namespace {

const std::string kTagScene = R"(# Two tags.
version: 1
seed: 7
world:
  room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }
  carpet: none
  ceiling_tags:
    - { name: A, at_m: [1, 1] }
    - { name: B, at_m: [3, 1], epc: "300000000000000000000AFF", shadow_db: 3 }
  radio: { profile: paper, noise_scale: 2 }
robot:
  start: { at_m: [1, 1], heading_deg: 0 }
mission:
  phase: { controller: fuzzy }
)";

TEST(PhaseScene, NamesTagsAndGivesThoseWithoutACodeOne) {
  const Scene scene = read_scene_text(kTagScene, "s.yaml");
  ASSERT_TRUE(scene.world.radio);
  ASSERT_EQ(scene.world.radio->tags.size(), 2u);
  EXPECT_EQ(scene.world.radio->tags[0].epc.bytes[0], 0x30);
  EXPECT_EQ(scene.world.radio->tags[0].epc.bytes[11], 1);
  EXPECT_EQ(scene.world.radio->tags[1].epc.bytes[10], 0x0A);
  EXPECT_EQ(scene.world.radio->tags[1].epc.bytes[11], 0xFF);
  EXPECT_EQ(scene.world.radio->tags[1].shadow_db, 3.0);
}

TEST(PhaseScene, PutsTwoAntennasOnTheRobotWhenNoneAreGiven) {
  const Scene scene = read_scene_text(kTagScene, "s.yaml");
  ASSERT_EQ(scene.world.radio->antennas.size(), 2u);
  EXPECT_EQ(scene.world.radio->antennas[0].at_m.y(), 0.08);
  EXPECT_EQ(scene.world.radio->antennas[1].at_m.y(), -0.08);
}

TEST(PhaseScene, MountsFourAntennasOnARoofWhenTold) {
  const Scene scene =
      read_scene_text(kTagScene, "s.yaml",
                      {.set = {"robot.uhf_reader.mount=roof", "mission.phase.controller=own"}, .seed = {}});
  const auto& antennas = scene.world.radio->antennas;
  ASSERT_EQ(antennas.size(), 4u);
  for (const world::AntennaDescription& antenna : antennas) {
    EXPECT_NEAR(antenna.boresight.norm(), 1.0, 1e-12);
    EXPECT_GT(antenna.boresight.x() * antenna.at_m.x(), 0.0) << "each looks away from the middle";
    EXPECT_LT(antenna.at_m.head<2>().norm(), scene.robot.base.radius_m);
  }
}

TEST(PhaseScene, StatesFaultsOfReaderCablesAndList) {
  const Scene scene =
      read_scene_text(kTagScene, "s.yaml",
                      {.set = {"robot.uhf_reader.faults.silent_s=[[20, 22], [30, 31]]",
                               "robot.uhf_reader.faults.lost_share=0.5",
                               "robot.uhf_reader.faults.cables=swapped", "mission.phase.exchanged=[A, B]"},
                       .seed = {}});
  const world::ReaderFaults& faults = scene.world.radio->faults;
  ASSERT_EQ(faults.silent_s.size(), 2u);
  EXPECT_EQ(faults.silent_s[1].x(), 30.0);
  EXPECT_EQ(faults.lost_share, 0.5);
  EXPECT_TRUE(faults.cables_swapped);
  EXPECT_EQ(scene.mission.phase->exchanged.size(), 2u);
}

TEST(PhaseScene, RefusesFaultsThatSayNothing) {
  for (const auto& [set, message] :
       {std::pair{"robot.uhf_reader.faults.silent_s=[[22, 20]]", "is from 22 s to 20 s"},
        {"mission.phase.exchanged=[A]", "names one tag"},
        {"mission.phase.exchanged=[A, A]", "names one tag"},
        {"mission.phase.exchanged=[A, C]", "there is no tag 'C'"}}) {
    try {
      (void)read_scene_text(kTagScene, "s.yaml", {.set = {set}, .seed = {}});
      ADD_FAILURE() << set;
    } catch (const robot::LoadError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

TEST(PhaseScene, TakesAProfileAndWhatDiffersFromIt) {
  const Scene scene =
      read_scene_text(kTagScene, "s.yaml", {.set = {"world.radio.profile=impinj_r420"}, .seed = {}});
  const world::RadioDescription& radio = scene.world.radio->radio;
  EXPECT_EQ(radio.profile, "impinj_r420");
  EXPECT_EQ(radio.noise_scale, 2.0);
  EXPECT_EQ(radio.phase_sign, -1.0);
  EXPECT_FALSE(radio.simultaneous);
  EXPECT_TRUE(radio.channels_hz.empty()) << "each run shuffles its own";
}

TEST(PhaseScene, IsShownAndReadAgainAsItWas) {
  for (const char* profile : {"paper", "impinj_r420"}) {
    const Scene scene = read_scene_text(kTagScene, "s.yaml",
                                        {.set = {std::string("world.radio.profile=") + profile}, .seed = {}});
    const std::string shown = scene_yaml(scene, {});
    const Scene again = read_scene_text(shown, "s.yaml");
    EXPECT_EQ(scene_yaml(again, {}), shown);
    EXPECT_EQ(again.world.radio->tags[1].epc, scene.world.radio->tags[1].epc);
    EXPECT_EQ(again.world.radio->radio.noise_floor_rad, scene.world.radio->radio.noise_floor_rad);
    ASSERT_TRUE(again.mission.phase);
    EXPECT_EQ(again.mission.phase->sets, robot::kReproductionSets);
  }
}

TEST(PhaseScene, TakesSetsByWordByTwoNumbersAndCornerByCorner) {
  const auto sets = [](const std::string& value) {
    return read_scene_text(kTagScene, "s.yaml", {.set = {"mission.phase.sets=" + value}, .seed = {}})
        .mission.phase->sets;
  };
  EXPECT_EQ(sets("tuned"), robot::kTunedSets);
  EXPECT_EQ(sets("{ z_rad: 1, w_radps: 2.5 }"), robot::kTunedSets);
  EXPECT_EQ(sets("{ zero_rad: [-0.5, -0.1, 0.1, 0.5] }").zero_rad.right_shoulder, 0.1);
}

TEST(PhaseScene, ReadsAProfileThatTwinCalibrateWrote) {
  const TemporaryFolder folder;
  std::ofstream(folder / "reader.yaml") << "# Fitted.\nradio:\n  profile: impinj_r420\n  phase_sign: -1\n"
                                           "  noise_law: rssi\n  noise_floor_rad: 0.011\n  noise_scale: 9\n";
  const Scene scene =
      read_scene_text(edited(kTagScene, "profile: paper", "file: reader.yaml"), folder / "s.yaml");
  EXPECT_EQ(scene.world.radio->radio.profile, "impinj_r420");
  EXPECT_EQ(scene.world.radio->radio.noise_floor_rad, 0.011);
  EXPECT_EQ(scene.world.radio->radio.noise_scale, 2.0) << "the scene's own key goes before the file's";
  EXPECT_EQ(messages(edited(kTagScene, "profile: paper", "file: nowhere.yaml")),
            "s.yaml:10:18: error: world.radio.file: nowhere.yaml: no such file; expected a radio profile");
}

TEST(PhaseScene, TellsWhatCannotBe) {
  const auto with = [](const std::string& set) { return messages(kTagScene, {.set = {set}, .seed = {}}); };
  EXPECT_NE(with("mission.phase.destinations=[A, C]").find("there is no tag 'C'"), std::string::npos);
  EXPECT_NE(with("mission.phase.destinations=[A, A]").find("comes twice in a row"), std::string::npos);
  EXPECT_NE(with("world.ceiling_tags[1].name=A").find("is the name of world.ceiling_tags[0] too"),
            std::string::npos);
  EXPECT_NE(with("world.ceiling_tags[1].epc=300000000000000000000001").find("is the code of"),
            std::string::npos);
  EXPECT_NE(with("world.ceiling_tags[1].epc=30").find("24 hexadecimal digits"), std::string::npos);
  EXPECT_NE(with("world.radio={ profile: impinj_r420, slots_s: [0.05] }").find("1 of them for 2 antennas"),
            std::string::npos);
  EXPECT_NE(with("world.radio.phase_sign=0.5").find("expected 1 or -1"), std::string::npos);
  EXPECT_NE(with("mission.phase.path=smooth").find("polylines only"), std::string::npos);
  EXPECT_NE(with("mission={ map: {}, phase: {} }").find("does not go with 'map'"), std::string::npos);
  EXPECT_NE(with("world.ceiling_tags=[]").find("needs ceiling tags"), std::string::npos);
}

}  // namespace
}  // namespace sensotwin::twin
