// SPDX-License-Identifier: MIT
#include "twin/trace/drawing_advice.hpp"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace sensotwin::twin {
namespace {

using robot::CompassPoint;
using robot::Vec2;
using testing::HasSubstr;

/// Two places 10 m apart, the second due east, a tag on either side.
robot::HallwayFile pair(const Vec2& second_m, double length_m = 10.0) {
  robot::HallwayFile file;
  const auto a = file.map.add("a", Vec2{0.0, 0.0});
  const auto b = file.map.add("b", second_m);
  file.map.connect(a, CompassPoint::kEast, b, length_m);
  file.map.add_tag(a, CompassPoint::kEast, 1);
  file.map.add_tag(b, CompassPoint::kWest, 2);
  return file;
}

/// The same, and the hallway leaves a at that many degrees clockwise from north.
robot::HallwayMap with_bearing(const robot::HallwayMap& map, double a_deg) {
  std::vector<robot::HallwayNode> nodes = map.nodes();
  const double leaves_rad = -robot::rad_from_deg(a_deg);
  nodes[0].side(CompassPoint::kEast).bearing_rad = robot::wrap_angle(leaves_rad);
  nodes[1].side(CompassPoint::kWest).bearing_rad = robot::wrap_angle(leaves_rad + robot::kPi);
  return robot::HallwayMap::from_nodes(std::move(nodes));
}

TEST(DrawingAdvice, HasNothingToSayOfAGoodDrawing) {
  EXPECT_TRUE(advice_on(pair({10.0, 0.5})).empty());
}

TEST(DrawingAdvice, SeesAHallwayThatRunsOffItsCompassPoint) {
  const auto advice = advice_on(pair({8.66, 5.0}));
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].side, CompassPoint::kEast);
  EXPECT_EQ(advice[0].what, "leads to 'b', which lies 30 degrees off east on the plan");
}

TEST(DrawingAdvice, ComparesASlantedHallwayWithItsBearing) {
  robot::HallwayFile file = pair({8.66, 5.0});
  const auto say = [&](double east_deg) {
    file.map = with_bearing(file.map, east_deg);
    return advice_on(file);
  };
  EXPECT_TRUE(say(60.0).empty());
  ASSERT_EQ(say(100.0).size(), 1u);
  EXPECT_EQ(say(100.0)[0].what,
            "leads to 'b', which lies 40 degrees off the bearing of 100 degrees on the plan");
}

TEST(DrawingAdvice, SeesATagFartherOffThanItsHallwayIsLong) {
  robot::HallwayFile file = pair({10.0, 0.0});
  file.tag_to_middle_m = 9.5;
  EXPECT_TRUE(advice_on(file).empty());
  std::vector<robot::HallwayNode> nodes = file.map.nodes();
  nodes[1].side(CompassPoint::kWest).tag_m = 10.0;
  file.map = robot::HallwayMap::from_nodes(std::move(nodes));
  const auto advice = advice_on(file);
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].node, "b");
  EXPECT_EQ(advice[0].what, "has tags 10.0 m from the middle of the place, and the hallway is 10.0 m long");
}

TEST(DrawingAdvice, SeesALengthThatWasNotDrawn) {
  const auto advice = advice_on(pair({10.0, 0.0}, 12.0));
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].what, "is 12.0 m long, and drawn 10.0 m long");
}

TEST(DrawingAdvice, SeesHallwaysThatCrossWhereNoPlaceIs) {
  robot::HallwayFile file = pair({10.0, 0.0});
  const auto c = file.map.add("c", Vec2{5.0, -5.0});
  const auto d = file.map.add("d", Vec2{5.0, 5.0});
  file.map.connect(c, CompassPoint::kNorth, d, 10.0);
  std::string said;
  for (const auto& one : advice_on(file)) {
    said += one.what + "\n";
  }
  EXPECT_THAT(said, HasSubstr("crosses the hallway from 'c' to 'd'"));
  EXPECT_THAT(said, HasSubstr("no known way leads here from 'a'"));
  EXPECT_THAT(said, HasSubstr("2 of 4 arrivals have no tag"));
}

TEST(DrawingAdvice, SeesPlacesOnTopOfEachOther) {
  robot::HallwayFile file = pair({10.0, 0.0});
  file.map.add("c", Vec2{10.0, 0.5});
  EXPECT_THAT(advice_on(file).front().what, HasSubstr("within half a hallway's width of 'b'"));
}

TEST(DrawingAdvice, AsksForNoMetres) {
  robot::HallwayFile file;
  const auto a = file.map.add("a");
  const auto b = file.map.add("b");
  file.map.connect(a, CompassPoint::kEast, b);
  file.map.add_tag(a, CompassPoint::kEast, 1);
  file.map.add_tag(b, CompassPoint::kWest, 2);
  EXPECT_TRUE(advice_on(file).empty());
  EXPECT_TRUE(advice_on({}).empty());
}

}  // namespace
}  // namespace sensotwin::twin
