// SPDX-License-Identifier: MIT
#include "robot/settings/hallway_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace sensotwin::robot {
namespace {

const std::string kSound = R"(version: 1
north_deg: 12.5
places:
  c:
    at_m: [7, -6]
    N: { to: d, length_m: 6, tags: ["6"] }
    E: { to: "?", tags: ["9", "E004015012345678"] }
  d:
    S: { to: c, length_m: 6, tags: ["11"] }
)";

std::string edited(const std::string& find, const std::string& replace) {
  std::string text = kSound;
  const std::size_t at = text.find(find);
  if (at == std::string::npos) {
    throw std::logic_error("nothing to edit");
  }
  return text.replace(at, find.size(), replace);
}

std::string messages(const std::string& text) {
  try {
    static_cast<void>(read_hallway_text(text, "m.yaml"));
  } catch (const LoadError& error) {
    return error.what();
  }
  return "no error";
}

TEST(HallwayFile, GivesPlacesSidesAndTags) {
  const HallwayFile file = read_hallway_text(kSound, "m.yaml");
  const NodeIndex c = *file.map.find("c");
  EXPECT_NEAR(file.north_rad, rad_from_deg(12.5), 1e-12);
  EXPECT_EQ(file.map.node(c).side(CompassPoint::kNorth).to, *file.map.find("d"));
  EXPECT_EQ(file.map.node(c).side(CompassPoint::kEast).hallway, Hallway::kUnknown);
  EXPECT_EQ(file.map.node(c).side(CompassPoint::kWest).hallway, Hallway::kNone);
  EXPECT_EQ(file.map.place_of(9)->from, CompassPoint::kEast);
  EXPECT_EQ(file.map.place_of(0xE004015012345678u)->node, c);
}

TEST(HallwayFile, ReadsBackWhatItWrites) {
  const HallwayFile file = read_hallway_text(kSound, "m.yaml");
  const std::string text = hallway_yaml(file);
  EXPECT_EQ(hallway_yaml(read_hallway_text(text, "m.yaml")), text);
  EXPECT_THAT(text, testing::HasSubstr("E004015012345678"));
}

TEST(HallwayFile, WritesBearingsAsACompassSaysThem) {
  std::string text = edited("N: { to: d, ", "N: { to: d, bearing_deg: 43, tag_m: 1.5, ");
  text.replace(text.find("S: { to: c, "), 12, "S: { to: c, bearing_deg: -137, ");
  const HallwayFile file = read_hallway_text(text, "m.yaml");
  const std::string written = hallway_yaml(file);
  EXPECT_THAT(written, testing::HasSubstr("bearing_deg: 43"));
  EXPECT_THAT(written, testing::HasSubstr("bearing_deg: 223"));
  const HallwayFile again = read_hallway_text(written, "m.yaml");
  EXPECT_EQ(hallway_yaml(again), written);
  for (const CompassPoint point : {CompassPoint::kNorth, CompassPoint::kSouth}) {
    const NodeIndex node = *file.map.find(point == CompassPoint::kNorth ? "c" : "d");
    EXPECT_NEAR(again.map.node(node).bearing_rad(point), file.map.node(node).bearing_rad(point), 1e-9);
    EXPECT_EQ(again.map.node(node).side(point).tag_m, file.map.node(node).side(point).tag_m);
  }
}

TEST(HallwayFile, NamesAPlaceThatIsNotThere) {
  EXPECT_EQ(
      messages(edited("to: d", "to: e")),
      "m.yaml:6:14: error: places.c.N.to: there is no place 'e'; expected a name under places, or \"?\"");
}

TEST(HallwayFile, NamesAHallwayThatDoesNotLeadBack) {
  EXPECT_EQ(messages(edited("    S: { to: c, length_m: 6, tags: [\"11\"] }\n", "    E: { to: \"?\" }\n")),
            "m.yaml:6:8: error: places.c.N: leads to 'd', whose south side does not lead back");
}

TEST(HallwayFile, NamesAllMistakesInOnePass) {
  const std::string text =
      messages(edited("length_m: 6, tags: [\"6\"]", "length_m: -6, tags: [\"six\"], colour: red"));
  EXPECT_THAT(text, testing::HasSubstr("places.c.N.length_m"));
  EXPECT_THAT(text, testing::HasSubstr("places.c.N.tags: 'six' is no tag"));
  EXPECT_THAT(text, testing::HasSubstr("places.c.N.colour: unknown key"));
}

TEST(HallwayFile, WantsTagsInQuotes) {
  EXPECT_THAT(messages(edited("[\"6\"]", "[6]")), testing::HasSubstr("put it in quotes"));
}

TEST(HallwayFile, OfNothingIsRefused) {
  EXPECT_THAT(messages(""), testing::StartsWith("m.yaml:1:1: error:"));
  EXPECT_THAT(messages("- a\n"), testing::StartsWith("m.yaml:1:1: error:"));
  EXPECT_THAT(messages("version: 2\nplaces: {}\n"), testing::HasSubstr("version"));
}

}  // namespace
}  // namespace sensotwin::robot
