// SPDX-License-Identifier: MIT
#include "twin/trace/drawing_advice.hpp"

#include <gmock/gmock.h>

#include <string>
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

TEST(DrawingAdvice, HasNothingToSayOfAGoodDrawing) {
  EXPECT_TRUE(advice_on(pair({10.0, 0.5})).empty());
}

TEST(DrawingAdvice, SeesAHallwayThatRunsOffItsCompassPoint) {
  const auto advice = advice_on(pair({8.66, 5.0}));
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].side, CompassPoint::kEast);
  EXPECT_EQ(advice[0].what, "leads to 'b', which lies 30 degrees off east on the plan");
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
