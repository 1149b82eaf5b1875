// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "rooms.hpp"

namespace sensotwin::world {
namespace {

WorldDescription carpet_of(int columns, int rows) {
  WorldDescription world = even_floor();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      world.carpet.tiles.emplace_back(column, row);
    }
  }
  return world;
}

TEST(TagField, AnswersTheFloorAntennaWithinItsReadRadiusOnly) {
  const WorldDescription description = carpet_of(4, 3);
  const TagField field(description, robot::RandomStream{1});
  const Vec2 tag_m = field.tags()[5].at_m;
  EXPECT_EQ(field.carpet_tag(tag_m + Vec2{0.0799, 0.0}, 0.08), TagIndex{5});
  EXPECT_FALSE(field.carpet_tag(tag_m + Vec2{0.0801, 0.0}, 0.08));
  EXPECT_FALSE(field.carpet_tag({-5.0, 7.0}, 0.08));
}

TEST(TagField, FindsTheNearestTagAsASearchThroughAllOfThemDoes) {
  const TagField field(carpet_of(5, 5), robot::RandomStream{3});
  robot::RandomStream random{4};
  for (int i = 0; i < 2000; ++i) {
    const Vec2 at_m{random.uniform(-0.3, 2.9), random.uniform(-0.3, 2.9)};
    const double radius_m = random.uniform(0.02, 0.45);
    std::optional<TagIndex> nearest;
    double d_m = radius_m;
    for (TagIndex t = 0; t < field.tags().size(); ++t) {
      if ((field.tags()[t].at_m - at_m).norm() <= d_m) {
        d_m = (field.tags()[t].at_m - at_m).norm();
        nearest = t;
      }
    }
    ASSERT_EQ(field.carpet_tag(at_m, radius_m), nearest);
  }
}

TEST(TagField, KeepsDeadTagsSilent) {
  WorldDescription description = carpet_of(2, 1);
  description.carpet.unreadable.emplace_back(1, 0);
  const TagField field(description, robot::RandomStream{1});
  EXPECT_FALSE(field.carpet_tag(field.tags()[1].at_m, 0.08));
}

TEST(TagField, GivesEveryTagItsOwnIcodeNumberWhichNoOtherTagInfluences) {
  WorldDescription description = carpet_of(20, 20);
  const TagField few(description, robot::RandomStream{9});
  description.carpet.tiles.insert(description.carpet.tiles.begin(), {-3, 7});
  description.landmarks.push_back({.kind = LandmarkKind::kWindowLeft, .at_m = {1.0, 1.0}});
  const TagField more(description, robot::RandomStream{9});
  std::set<std::uint64_t> seen;
  for (TagIndex t = 0; t < few.tags().size(); ++t) {
    EXPECT_EQ(few.tags()[t].memory.uid, more.tags()[t + 1].memory.uid);
    EXPECT_EQ(few.tags()[t].at_m, more.tags()[t + 1].at_m);
    EXPECT_EQ(few.tags()[t].memory.uid >> 40, 0xE00401U);
    seen.insert(few.tags()[t].memory.uid);
  }
  EXPECT_EQ(seen.size(), few.tags().size());
}

TEST(TagField, WritesSensoBotsTablesIntoLandmarksAndFurniture) {
  WorldDescription description;
  description.landmarks.push_back({.kind = LandmarkKind::kFrontDoorOpeningSide, .at_m = {1.0, 1.0}});
  description.furniture.push_back({.name = "table",
                                   .shape = FurnitureShape::kLegs,
                                   .X_WF = {{3.0, 0.0}, robot::kPi / 2.0},
                                   .points_m = {{0.4, 0.0}, {-0.4, 0.0}},
                                   .tag = ObjectTag{3, 12, 8, 5}});
  const TagField field(description, robot::RandomStream{1});
  ASSERT_EQ(field.tags().size(), 3U);
  EXPECT_EQ(field.tags()[0].memory.blocks[0], (TagMemory::Block{0x81, 0x01, 0, 0}));
  EXPECT_EQ(field.tags()[1].memory.blocks[0][0], 0xFF);
  EXPECT_EQ(field.tags()[1].memory.blocks[1], (TagMemory::Block{3, 12, 8, 5}));
  EXPECT_NEAR((field.tags()[1].at_m - Vec2{3.0, 0.4}).norm(), 0.0, 1e-12);
}

WorldDescription below_ceiling_tags() {
  WorldDescription world = even_floor();
  world.radio.emplace();
  world.radio->tags.push_back({.name = "a", .at_m = {1.0, 0.0}});
  world.radio->tags.push_back({.name = "b", .at_m = {2.0, 0.0}, .floor_tag = false});
  world.radio->tags.push_back({.name = "c", .at_m = {3.0, 0.0}, .present = false});
  for (std::uint8_t i = 0; i < 12; ++i) {
    world.radio->tags[0].epc.bytes[i] = static_cast<std::uint8_t>(0x30 + i);
  }
  return world;
}

// Gueaieb & Miah, section III: a short-range tag on the floor says that the robot is below the ceiling tag.
TEST(TagField, LaysFloorTagsThatNameTheCeilingTagAbove) {
  const TagField field(below_ceiling_tags(), robot::RandomStream{1});
  ASSERT_EQ(field.tags().size(), 2U) << "one has none; one fell off the ceiling, and its floor tag stays";
  EXPECT_EQ(field.tags()[0].place, TagPlace::kFloor);
  EXPECT_EQ(field.tags()[1].owner, 2U);
  EXPECT_EQ(field.tags()[0].memory.blocks[0], (TagMemory::Block{0x30, 0x31, 0x32, 0x33}));
  EXPECT_EQ(field.tags()[0].memory.blocks[2], (TagMemory::Block{0x38, 0x39, 0x3A, 0x3B}));
  EXPECT_EQ(field.loose_tag({1.049, 0.0}, 0.05), TagIndex{0});
  EXPECT_FALSE(field.loose_tag({1.051, 0.0}, 0.05));
  EXPECT_FALSE(field.standing_tag({1.0, 0.0}, 0.05)) << "the forward antenna does not see the floor";
}

TEST(TagField, NumbersFloorTagsWhateverElseIsLaid) {
  WorldDescription world = below_ceiling_tags();
  const TagField few(world, robot::RandomStream{9});
  world.carpet.tiles.emplace_back(0, 0);
  world.radio->tags.insert(world.radio->tags.begin(), {.name = "z", .at_m = {9.0, 9.0}});
  const TagField more(world, robot::RandomStream{9});
  EXPECT_EQ(few.tags()[0].memory.uid, more.tags()[2].memory.uid);
  EXPECT_NE(few.tags()[0].memory.uid, few.tags()[1].memory.uid);
}

TEST(World, ReadsTheNearerOfCarpetTagAndFloorTag) {
  WorldDescription description = below_ceiling_tags();
  description.carpet.tag_offset_sigma_m = 0.0;
  description.carpet.origin_m = {1.02 - 0.254, -0.254};
  description.carpet.tiles.emplace_back(0, 0);
  World near_floor_tag = make(description, exact_robot({{0.99, 0.0}, 0.0}));
  EXPECT_EQ(near_floor_tag.floor_tag(), TagIndex{1});
  World near_carpet_tag = make(description, exact_robot({{1.03, 0.0}, 0.0}));
  EXPECT_EQ(near_carpet_tag.floor_tag(), TagIndex{0});
}

TEST(World, ReadsTheTagUnderTheRobotAndTheOneInFrontOfIt) {
  WorldDescription description = carpet_of(3, 1);
  description.landmarks.push_back({.kind = LandmarkKind::kPowerOutlet, .at_m = {0.49, 0.25}});
  World world = make(description, exact_robot({{0.254, 0.254}, 0.0}));
  EXPECT_EQ(world.floor_tag(), TagIndex{0});
  EXPECT_EQ(world.forward_tag(), TagIndex{3});
  run(world, wheels(0.3, 0.3), 1.0);
  EXPECT_FALSE(world.floor_tag());
  world.tag_memory(0).blocks[2] = {1, 2, 3, 4};
  EXPECT_EQ(world.tags()[0].memory.blocks[2], (TagMemory::Block{1, 2, 3, 4}));
}

TEST(World, CarriesTheTagsOfFurnitureThatIsPushed) {
  WorldDescription description = even_floor();
  description.furniture.push_back({.name = "stool",
                                   .shape = FurnitureShape::kCircle,
                                   .X_WF = {{0.5, 0.0}, 0.0},
                                   .radius_m = 0.15,
                                   .points_m = {},
                                   .pushable = true,
                                   .mass_kg = 1.5,
                                   .tag = ObjectTag{}});
  World world = make(description, exact_robot());
  const double before_m = world.tags()[0].at_m.x();
  run(world, wheels(0.2, 0.2), 3.0);
  EXPECT_GT(world.X_WF()[0].p_m.x(), 0.6);
  EXPECT_NEAR((world.tags()[0].at_m - world.X_WF()[0] * Vec2{0.15, 0.0}).norm(), 0.0, 1e-9);
  EXPECT_GT(world.tags()[0].at_m.x(), before_m + 0.1);
}

}  // namespace
}  // namespace sensotwin::world
