// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "twin/scene/floor_plan.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/scene/scene_writer.hpp"

namespace sensotwin::twin {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes";

/// Tiles whose middle no furniture covers.
int bare_tiles(const Scene& scene) {
  int bare = 0;
  for (const auto& [column, row] : scene.world.carpet.tiles) {
    const Vec2 middle =
        scene.world.carpet.origin_m + scene.world.carpet.tile_m * Vec2{column + 0.5, row + 0.5};
    bool covered = false;
    for (const world::Furniture& piece : scene.world.furniture) {
      covered = covered || distance_m({middle, middle}, piece) == 0.0;
    }
    bare += covered ? 0 : 1;
  }
  return bare;
}

TEST(PublishedScenes, AllReadAndShow) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.path().extension() == ".yaml") {
      const Scene scene = read_scene(entry.path());
      EXPECT_FALSE(scene.title.empty()) << entry.path();
      EXPECT_FALSE(scene.expect.empty()) << entry.path();
      EXPECT_EQ(scene_yaml(read_scene_text(scene_yaml(scene), entry.path())), scene_yaml(scene))
          << entry.path();
      for (const std::string& variant : scene.variants) {
        EXPECT_NO_THROW(static_cast<void>(read_scene(entry.path(), {.variant = variant})))
            << entry.path() << " --variant " << variant;
      }
      ++count;
    }
  }
  EXPECT_GE(count, 3);
}

TEST(PublishedScenes, GiveTheHouse207TilesOutsideItsFurniture) {
  const Scene scene = read_scene(kScenes / "house.yaml");
  EXPECT_EQ(scene.world.carpet.tiles.size(), 225u);
  EXPECT_EQ(bare_tiles(scene), 207);
}

TEST(PublishedScenes, GiveTheRoom266Of324Tiles) {
  const Scene scene = read_scene(kScenes / "room_324.yaml");
  EXPECT_EQ(scene.world.carpet.tiles.size(), 324u);
  EXPECT_EQ(bare_tiles(scene), 266);
}

TEST(PublishedScenes, GiveTheLessonSixteenTiles) {
  EXPECT_EQ(read_scene(kScenes / "lesson_2x2.yaml").world.carpet.tiles.size(), 16u);
}

}  // namespace
}  // namespace sensotwin::twin
