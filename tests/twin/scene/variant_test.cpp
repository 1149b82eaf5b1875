// SPDX-License-Identifier: MIT
#include "twin/scene/variant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

const std::string kWithVariants = kSoundScene + R"(variants:
  dfm:
    mission.map.explorer: dfm
    expect: { minutes: { max: 5 } }
  heavy:
    world.furniture[0].mass_kg: 4
    title: A heavy table
)";

Scene read_as(const std::string& variant, const std::vector<std::string>& set = {}) {
  return read_scene_text(kWithVariants, "s.yaml", {.set = set, .variant = variant});
}

TEST(Variant, ThatNobodyChoseChangesNothing) {
  const Scene scene = read_as("");
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kIdfm);
  EXPECT_EQ(scene.name, "s");
  EXPECT_EQ(scene.variant, "");
  EXPECT_THAT(scene.variants, testing::ElementsAre("dfm", "heavy"));
}

TEST(Variant, ReplacesWhatItsPathsName) {
  const Scene scene = read_as("dfm");
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kDfm);
  EXPECT_EQ(scene.world.furniture[0].mass_kg, read_as("").world.furniture[0].mass_kg);
  EXPECT_EQ(scene.name, "s-dfm");
  EXPECT_EQ(scene.variant, "dfm");
}

TEST(Variant, ReplacesExpectationsAsAWhole) {
  const Scene scene = read_as("dfm");
  ASSERT_EQ(scene.expect.size(), 1u);
  EXPECT_EQ(scene.expect[0].name, "minutes");
}

TEST(Variant, GoesOnFromOneAboveIt) {
  const Scene scene = read_scene_text(kWithVariants + "  both:\n    from: dfm\n    title: Both\n", "s.yaml",
                                      {.variant = "both"});
  EXPECT_EQ(scene.mission.map->explorer, robot::ExplorerKind::kDfm);
  EXPECT_EQ(scene.title, "Both");
  EXPECT_EQ(scene.expect.at(0).name, "minutes");
}

TEST(Variant, GoesOnFromNoneBelowNorFromItself) {
  for (const char* base : {"self", "later", "none"}) {
    const std::string text = kWithVariants + "  self:\n    from: " + base + "\n  later:\n    title: Later\n";
    try {
      (void)read_scene_text(text, "s.yaml", {.variant = "self"});
      ADD_FAILURE() << base;
    } catch (const robot::LoadError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("variants.self.from: is '" + std::string(base)));
      EXPECT_THAT(error.what(), testing::HasSubstr("expected the name of a variant above this one"));
    }
  }
}

TEST(Variant, ReachesIntoAList) {
  EXPECT_EQ(read_as("heavy").world.furniture[0].mass_kg, 4.0);
  EXPECT_EQ(read_as("heavy").title, "A heavy table");
}

TEST(Variant, YieldsToTheCommandLine) {
  EXPECT_EQ(read_as("dfm", {"mission.map.explorer=bfm"}).mission.map->explorer, robot::ExplorerKind::kBfm);
}

TEST(Variant, ThatIsNotThereEndsAsAWrongCommandLineWithTheNamesThatAre) {
  EXPECT_EQ(
      messages(kWithVariants, {.variant = "hevy"}),
      "--variant hevy: error: the scene has no such variant (did you mean 'heavy'?); it has dfm, heavy");
  try {
    static_cast<void>(read_as("hevy"));
    FAIL() << "read";
  } catch (const robot::LoadError& error) {
    EXPECT_EQ(error.exit_code(), robot::kExitUsage);
  }
}

TEST(Variant, OfASceneWithoutAnyIsRefused) {
  EXPECT_EQ(messages(kSoundScene, {.variant = "dfm"}),
            "--variant dfm: error: the scene has no such variant; it has none");
}

TEST(Variant, NamesAWrongValueByItsOwnLine) {
  const std::string text = edited(kWithVariants, "explorer: dfm", "explorer: dmf");
  EXPECT_EQ(messages(text), "no error");
  EXPECT_THAT(messages(text, {.variant = "dfm"}),
              testing::StartsWith("s.yaml:17:27: error: mission.map.explorer: "));
}

TEST(Variant, NamesAPathThatLeadsNowhereByItsOwnLine) {
  const std::string text = edited(kWithVariants, "furniture[0]", "furniture[7]");
  EXPECT_EQ(messages(text, {.variant = "heavy"}),
            "s.yaml:20:5: error: world.furniture: has no item 7; it has 1, counted from 0");
}

TEST(Variant, WithABrokenPathIsRefused) {
  const std::string text = edited(kWithVariants, "furniture[0]", "furniture[0");
  EXPECT_THAT(
      messages(text, {.variant = "heavy"}),
      testing::StartsWith("s.yaml:20:5: error: variants.heavy: 'world.furniture[0.mass_kg' is no path; "));
}

TEST(Variant, MustBeASectionWhetherItIsChosenOrNot) {
  EXPECT_THAT(messages(kSoundScene + "variants: [a]\n"), testing::HasSubstr("variants: is a list"));
  EXPECT_THAT(messages(kSoundScene + "variants: { a: 3 }\n"), testing::HasSubstr("variants.a: is "));
}

TEST(Variant, MayBeThereOnce) {
  EXPECT_THAT(messages(kWithVariants + "  dfm: {}\n"), testing::HasSubstr("variants.dfm: is there twice"));
  EXPECT_THAT(messages(kWithVariants + "    title: Again\n"), testing::HasSubstr("'title' is there twice"));
}

TEST(Variant, MayNotChangeWhatASceneIs) {
  EXPECT_THAT(messages(kWithVariants + "    seed: 8\n"), testing::HasSubstr("changes 'seed'"));
}

}  // namespace
}  // namespace sensotwin::twin
