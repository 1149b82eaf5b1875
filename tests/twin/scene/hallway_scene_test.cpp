// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "scene_texts.hpp"
#include "twin/scene/hallway_building.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/scene/scene_writer.hpp"

namespace sensotwin::twin {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes";

Scene office(const std::vector<std::string>& set = {}) {
  return read_scene(kScenes / "office.yaml", {.set = set});
}

std::string complaint(const std::vector<std::string>& set) {
  try {
    static_cast<void>(office(set));
  } catch (const robot::LoadError& error) {
    return error.what();
  }
  return "no error";
}

TEST(HallwayScene, HasWallsOnBothSidesOfItsHallways) {
  const OccupancyMap floor = floor_of(office().hallways);
  EXPECT_EQ(floor.at(Vec2{3.5, 0.0}), Cell::kFree);
  EXPECT_EQ(floor.at(Vec2{3.5, 0.97}), Cell::kFree);
  EXPECT_EQ(floor.at(Vec2{3.5, 1.03}), Cell::kOccupied);
  EXPECT_EQ(floor.at(Vec2{3.5, -3.0}), Cell::kOccupied) << "between a and b";
  EXPECT_EQ(floor.at(Vec2{21.9, -12.9}), Cell::kFree) << "half a width beyond the end";
  EXPECT_GE(office().world.walls.size(), 3u);
}

TEST(HallwayScene, HasWallsAlongAHallwayThatSlants) {
  robot::HallwayFile slanted;
  const auto a = slanted.map.add("a", Vec2{0.0, 0.0});
  const auto b = slanted.map.add("b", Vec2{6.0, 8.0});
  slanted.map.connect(a, robot::CompassPoint::kNorth, b, 10.0);
  const OccupancyMap floor = floor_of(slanted);
  const Vec2 along{0.6, 0.8};
  const Vec2 across{0.8, -0.6};
  const double half_m = 0.5 * slanted.width_m;
  for (const double metres : {0.0, 2.5, 5.0, 10.0}) {
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(floor.at(metres * along + side * (half_m - 0.05) * across), Cell::kFree) << metres;
      EXPECT_EQ(floor.at(metres * along + side * (half_m + 0.05) * across), Cell::kOccupied) << metres;
    }
  }
  EXPECT_EQ(floor.at((10.0 + half_m - 0.05) * along), Cell::kFree);
  EXPECT_EQ(floor.at((10.0 + half_m + 0.05) * along), Cell::kOccupied);
}

TEST(HallwayScene, LaysEachTagBesideItsPlaceOnTheSideThatItIsMetOn) {
  const Scene scene = office();
  ASSERT_EQ(scene.world.hallway_tags.size(), 26u);
  const auto& first = scene.world.hallway_tags.front();
  EXPECT_EQ(first.uid, 0xE004015000000100u);
  EXPECT_EQ(first.at_m, Vec2(1.0, 0.0)) << "a0 from the east";
}

TEST(HallwayScene, BringsRangefindersAndStartsWhereItsMissionDoes) {
  const Scene scene = office({"robot.start=auto", "mission.hallway.from=b2"});
  EXPECT_TRUE(scene.robot.sonar);
  EXPECT_EQ(scene.robot.X_WR_start.p_m, Vec2(14.0, -6.0));
}

TEST(HallwayScene, ReadsBackWhatIsShownOfIt) {
  const Scene scene = office();
  EXPECT_EQ(scene_yaml(read_scene_text(scene_yaml(scene), kScenes / "office.yaml")), scene_yaml(scene));
}

TEST(HallwayScene, NamesAPlaceThatIsNotOnItsMap) {
  EXPECT_THAT(complaint({"mission.hallway.to=c9"}),
              testing::HasSubstr("mission.hallway.to: there is no place 'c9'; expected"));
  EXPECT_THAT(complaint({"mission.hallway={ from: a0 }"}),
              testing::HasSubstr("mission.hallway.to: is missing"));
}

TEST(HallwayScene, NamesAHallwayMapThatIsNotThere) {
  EXPECT_THAT(complaint({"world.hallways.file=hallways/nowhere.yaml"}), testing::HasSubstr("nowhere.yaml"));
}

TEST(HallwayScene, WithoutHallwaysIsRefused) {
  EXPECT_THAT(messages(edited(kSoundScene, "map: { explorer: idfm }", "hallway: { to: a }")),
              testing::HasSubstr("mission.hallway: needs hallways"));
}

}  // namespace
}  // namespace sensotwin::twin
