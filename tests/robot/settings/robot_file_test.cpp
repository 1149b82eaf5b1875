// SPDX-License-Identifier: MIT
#include "robot/settings/robot_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace sensotwin::robot {
namespace {

using ::testing::HasSubstr;

constexpr const char* kMapping = R"(version: 1
devices: { base: /dev/roomba, sensors: /dev/sensors, card_readers: [floor, ahead] }
mission: { map: { explorer: idfm } }
)";

constexpr const char* kPhase = R"(version: 1
devices: { base: /dev/roomba, llrp: 10.0.0.2 }
robot:
  base: { wheel_base_m: 0.24, mass_kg: 3.6 }
  floor_reader: { read_radius_m: 0.05, exchange_s: 0.012, uid_order: lsb_first }
  uhf_reader:
    antennas:
      - { at_m: [0, 0.1, 0.1], cable_delay_s: 5.0e-9, gain_dbi: 9 }
      - { at_m: [0, -0.1, 0.1] }
    path: monostatic
    phase_sign: -1
    pi_ambiguous: true
  start: { at_m: [1, 1] }
place:
  ceiling_tags:
    - { name: door, epc: "300000000000000000000001", height_m: 2.5 }
    - { name: desk, epc: "300000000000000000000002" }
mission: { phase: { controller: own, destinations: [desk, door] } }
map_id: 77
)";

std::string complaint_about(const std::string& text) {
  try {
    (void)read_robot_text(text, "r.yaml");
  } catch (const LoadError& error) {
    return error.what();
  }
  return "none";
}

TEST(RobotFile, ReadsAMappingRobotWithDefaultsForTheRest) {
  const RobotFile robot = read_robot_text(kMapping, "r.yaml");
  EXPECT_EQ(robot.devices.base, "/dev/roomba");
  EXPECT_EQ(robot.devices.card_readers.at(1), "ahead");
  EXPECT_EQ(robot.settings.mission.map->explorer, ExplorerKind::kIdfm);
  EXPECT_EQ(robot.settings.base.wheel_base_m, BaseSettings{}.wheel_base_m);
  EXPECT_FALSE(robot.map_id_given);
}

TEST(RobotFile, TakesSectionsOfASceneAndPassesOverWhatOnlyTheTwinKnows) {
  const RobotFile robot = read_robot_text(kPhase, "r.yaml");
  EXPECT_EQ(robot.settings.base.wheel_base_m, 0.24);
  EXPECT_EQ(robot.settings.floor_reader.uid_order, UidOrder::kLsbFirst);
  EXPECT_TRUE(robot.settings.uhf_reader.monostatic);
  EXPECT_EQ(robot.settings.uhf_reader.antennas.at(0).cable_delay_s, 5e-9);
  EXPECT_EQ(robot.settings.ceiling_tags.at(1).epc.bytes[11], 2);
  EXPECT_EQ(robot.settings.map_id, 77u);
}

TEST(RobotFile, IsShownAsAFileThatReadsBackToTheSame) {
  for (const char* const text : {kMapping, kPhase}) {
    const std::string shown = robot_yaml(read_robot_text(text, "r.yaml"));
    EXPECT_EQ(robot_yaml(read_robot_text(shown, "r.yaml")), shown);
  }
}

TEST(RobotFile, TakesItsDevicesFromAnotherFile) {
  std::string name = (std::filesystem::temp_directory_path() / "sensotwin-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder{name};
  std::ofstream(folder / "devices.yaml") << "base: /dev/pts/7\ncard_readers: [\"Virtual PCD 00 00\"]\n";
  const std::string text = "version: 1\ndevices: devices.yaml\n";
  EXPECT_EQ(read_robot_text(text, folder / "r.yaml").devices.base, "/dev/pts/7");
  EXPECT_EQ(read_robot_text(kMapping, "r.yaml", folder / "devices.yaml").devices.base, "/dev/pts/7");
  std::filesystem::remove_all(folder);
}

constexpr const char* kHallways = R"(version: 1
north_deg: 12
places:
  a: { E: { to: b, length_m: 4, tags: ["1"] } }
  b: { W: { to: a, length_m: 4, tags: ["E004015012345678"] } }
)";
constexpr const char* kHallwayRobot = R"(version: 1
devices: { base: /dev/roomba, sensors: /dev/sensors, card_readers: [floor] }
place: { hallways: plan.yaml }
mission: { hallway: { from: a, to: b } }
)";

TEST(RobotFile, TakesTheHallwayMapOfAnotherFileInAndIsShownWithIt) {
  std::string name = (std::filesystem::temp_directory_path() / "sensotwin-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder{name};
  std::ofstream(folder / "plan.yaml") << kHallways;
  const RobotFile robot = read_robot_text(kHallwayRobot, folder / "r.yaml");
  std::ofstream(folder / "plan.yaml") << "version: 1\nplaces: { a: { X: {} } }\n";
  try {
    (void)read_robot_text(kHallwayRobot, folder / "r.yaml");
    ADD_FAILURE() << "it was read";
  } catch (const LoadError& error) {
    EXPECT_THAT(error.what(), HasSubstr("plan.yaml:2:16: error: place.hallways.places.a.X: unknown key"));
  }
  std::filesystem::remove_all(folder);
  ASSERT_EQ(robot.settings.hallways.map.nodes().size(), 2u);
  // Alone, anywhere: the file it named is not asked for again.
  const std::string shown = robot_yaml(robot);
  EXPECT_THAT(shown, HasSubstr("E004015012345678"));
  const RobotFile again = read_robot_text(shown, "elsewhere.yaml");
  EXPECT_EQ(again.settings.hallways.north_rad, robot.settings.hallways.north_rad);
  EXPECT_EQ(hallway_yaml(again.settings.hallways), hallway_yaml(robot.settings.hallways));
  EXPECT_EQ(robot_yaml(again), shown);
}

struct Mistake {
  const char* text;
  const char* complaint;
};

TEST(RobotFile, RefusesWhatIsWrongAndSaysWhere) {
  const Mistake mistakes[] = {
      {"version: 1\n", "r.yaml:1:1: error: devices: is missing"},
      {"version: 1\ndevices: { bsae: /dev/x }\n", "r.yaml:2:12: error: devices.bsae: unknown key"},
      {"version: 1\ndevices: { base: /dev/x }\n", "'card_readers' is missing"},
      {"version: 1\ndevices: { card_readers: [a] }\n", "'base' is missing"},
      {"version: 1\ndevices: { base: /dev/x, card_readers: [a, b, c] }\n", "a list of"},
      {"version: 1\ndevices: { base: /dev/x, card_readers: [a] }\nrobot: { base: { kind: roomba400 } }\n",
       "r.yaml:3:24: error: robot.base.kind: a Roomba 400 has no encoders"},
      {"version: 1\ndevices: { base: /dev/x }\nmission: { phase: {} }\n", "'llrp' is missing"},
      {"version: 1\ndevices: { base: /dev/x, llrp: h }\nmission: { phase: {} }\n",
       "mission.phase: needs ceiling tags; expected place.ceiling_tags"},
      {"version: 1\ndevices: { base: /dev/x, llrp: h }\n"
       "place: { ceiling_tags: [{ name: a, epc: \"300000000000000000000001\" }] }\n"
       "mission: { phase: { destinations: [b] } }\n",
       "mission.phase.destinations[0]: there is no tag 'b'"},
      {"version: 1\ndevices: { base: /dev/x, card_readers: [a] }\nrobot: { uhf_reader: { phase_sign: 0.5 } "
       "}\n",
       "robot.uhf_reader.phase_sign: is 0.5; expected 1 or -1"},
      {"[1, 2]\n", "r.yaml:1:1: error: is a list"},
  };
  for (const Mistake& mistake : mistakes) {
    EXPECT_THAT(complaint_about(mistake.text), HasSubstr(mistake.complaint)) << mistake.text;
  }
}

TEST(RobotFile, IsReadForACheckWhateverItsMissionLacks) {
  const std::string text = "version: 1\ndevices: { base: /dev/x }\nrobot: { base: { kind: roomba400 } }\n";
  EXPECT_EQ(read_robot_text(text, "r.yaml", {}, RobotFileUse::kCheck).settings.base.kind,
            BaseKind::kRoomba400);
}

TEST(RobotFile, NamesAFileThatIsNotThere) {
  try {
    (void)read_robot_file("/nowhere/robot.yaml");
    FAIL() << "it was read";
  } catch (const LoadError& error) {
    EXPECT_EQ(error.exit_code(), kExitMissing);
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/robot.yaml"));
  }
}

}  // namespace
}  // namespace sensotwin::robot
