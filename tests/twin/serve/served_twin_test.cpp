// SPDX-License-Identifier: MIT
#include "twin/serve/served_twin.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "robot/mapping/explorer_kind.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/serve/card_service.hpp"
#include "twin/serve/devices_file.hpp"

namespace sensotwin::twin {
namespace {

Scene scene_named(const char* name, const std::vector<std::string>& set = {}) {
  return read_scene(std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "scenes" / name, {.set = set});
}

TEST(ServedTwinTest, IsTheVeryWorldOfATwinRun) {
  const Scene scene = scene_named("lesson_2x2.yaml", {"mission.map.explorer=dfm"});
  MappingTwin run(scene);
  ServedTwin served(scene);
  robot::MappingProgram program({served.machine().serial(), served.machine().floor_reader(),
                                 served.forward_reader(), served.machine().sensor_board()},
                                mapping_config_of(scene, run.map_id()),
                                robot::make_explorer(scene.mission.map->explorer, {}));
  for (int i = 0; i < 2000; ++i) {
    run.tick();
    served.tick();
    program.step(served.now());
  }
  EXPECT_EQ(served.machine().hash().text(), run.hash().text());
}

TEST(ServedTwinTest, HasAUhfReaderWhereThereAreCeilingTagsAndNoClientFromWithin) {
  EXPECT_EQ(ServedTwin(scene_named("lesson_2x2.yaml")).uhf_reader(), nullptr);
  ServedTwin twin(scene_named("hallway.yaml"));
  ASSERT_NE(twin.uhf_reader(), nullptr);
  for (int i = 0; i < 100; ++i) {
    twin.tick();
  }
  EXPECT_EQ(twin.uhf_reader()->tally().connections, 0u);
}

TEST(DevicesFile, NamesWhatThereIs) {
  EXPECT_EQ(to_yaml({.base = "/out/base", .sensors = "/out/sensors"}, "house.yaml"),
            "# The wires of twin serve house.yaml\n"
            "base: \"/out/base\"\n"
            "sensors: \"/out/sensors\"\n");
  EXPECT_EQ(to_yaml({.base = "/out/\"base",
                     .sensors = "/out/sensors",
                     .llrp = "127.0.0.1:5084",
                     .card_readers = {"Virtual PCD 00 00", "Virtual PCD 00 01"}},
                    "hallway.yaml"),
            "# The wires of twin serve hallway.yaml\n"
            "base: \"/out/\\\"base\"\n"
            "sensors: \"/out/sensors\"\n"
            "llrp: \"127.0.0.1:5084\"\n"
            "card_readers:   # floor, forward\n"
            "  - \"Virtual PCD 00 00\"\n"
            "  - \"Virtual PCD 00 01\"\n");
}

TEST(CardServiceTest, FindsTheVirtualSlotsAmongOtherReaders) {
  EXPECT_EQ(virtual_slots_among({"ACS ACR1552 00 00", "Virtual PCD 01 00", "Virtual PCD 01 01"}),
            (std::vector<std::string>{"Virtual PCD 01 00", "Virtual PCD 01 01"}));
  EXPECT_EQ(virtual_slots_among({}), (std::vector<std::string>{"Virtual PCD 00 00", "Virtual PCD 00 01"}));
}

}  // namespace
}  // namespace sensotwin::twin
