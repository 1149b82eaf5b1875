// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/robot/topology/paper_map.hpp"

namespace sensotwin::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> texts(const std::vector<HallwayMapProblem>& problems) {
  std::vector<std::string> texts;
  for (const HallwayMapProblem& problem : problems) {
    texts.push_back(problem.node + (problem.side ? " " + std::string{name_of(*problem.side)} : "") + ": " +
                    problem.what);
  }
  return texts;
}

/// The paper's map with one node changed, as a file might hold it.
template <class Change>
std::vector<std::string> problems_after(const Change& change) {
  std::vector<HallwayNode> nodes = paper_map().nodes();
  change(nodes);
  return texts(HallwayMap::from_nodes(std::move(nodes)).check());
}

TEST(CompassPoint, TurnsRightClockwise) {
  EXPECT_EQ(turned_right(CompassPoint::kWest, 1), CompassPoint::kNorth);
  EXPECT_EQ(turned_right(CompassPoint::kNorth, -1), CompassPoint::kWest);
  EXPECT_EQ(quarter_turns_right(CompassPoint::kWest, CompassPoint::kNorth), 1);
  EXPECT_EQ(quarter_turns_right(CompassPoint::kNorth, CompassPoint::kWest), -1);
  EXPECT_EQ(quarter_turns_right(CompassPoint::kEast, CompassPoint::kWest), 2);
}

TEST(CompassPoint, IsTheNearestToAYaw) {
  for (const CompassPoint point : kCompassPoints) {
    EXPECT_EQ(nearest_point(yaw_rad_of(point)), point);
    EXPECT_EQ(nearest_point(yaw_rad_of(point) + 0.7), point);
    EXPECT_EQ(nearest_point(yaw_rad_of(point) - 0.7), point);
    EXPECT_EQ(compass_point_from(std::string(1, letter_of(point))), point);
  }
  EXPECT_LT(yaw_rad_of(CompassPoint::kEast), 0.0) << "east of north is clockwise";
  EXPECT_FALSE(compass_point_from("North"));
}

TEST(HallwayMap, KnowsByATagThePlaceAndTheSideOfArrival) {
  const HallwayMap map = paper_map();
  const std::optional<Arrival> arrival = map.place_of(9);
  ASSERT_TRUE(arrival);
  EXPECT_EQ(map.node(arrival->node).name, "c");
  EXPECT_EQ(arrival->from, CompassPoint::kEast);
  EXPECT_FALSE(map.place_of(99));
}

TEST(HallwayMap, LeadsBackByTheOppositeSide) {
  const HallwayMap map = paper_map();
  const Side& side = map.node(*map.find("c")).side(CompassPoint::kNorth);
  EXPECT_EQ(map.node(side.to).name, "d");
  EXPECT_EQ(map.node(side.to).side(CompassPoint::kSouth).to, *map.find("c"));
}

TEST(HallwayMap, OfThePaperIsSound) {
  EXPECT_THAT(texts(paper_map().check()), ElementsAre());
  EXPECT_EQ(paper_map().node(3).side(CompassPoint::kWest).hallway, Hallway::kNone);
}

TEST(HallwayMap, KnowsItsLengthsWhenAllAreThere) {
  HallwayMap map = paper_map();
  EXPECT_FALSE(map.lengths_known());
  for (NodeIndex i = 0; i < map.nodes().size(); ++i) {
    for (const CompassPoint point : kCompassPoints) {
      if (map.node(i).side(point).hallway == Hallway::kLeadsTo) {
        map.connect(i, point, map.node(i).side(point).to, 4.0);
      }
    }
  }
  EXPECT_TRUE(map.lengths_known());
  EXPECT_THAT(texts(map.check()), ElementsAre());
}

TEST(HallwayMap, NamesATagThatIsInTwoPlaces) {
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[3].side(CompassPoint::kEast).tags = {9}; }),
              ElementsAre("d east: has tag 9, which is at 'c' east too"));
}

TEST(HallwayMap, NamesAHallwayThatDoesNotLeadBack) {
  EXPECT_THAT(
      problems_after([](auto& nodes) { nodes[0].side(CompassPoint::kEast).hallway = Hallway::kUnknown; }),
      ElementsAre("c west: leads to 'a', whose east side does not lead back"));
}

TEST(HallwayMap, NamesLengthsThatDisagreeOrAreNone) {
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[0].side(CompassPoint::kEast).length_m = 3.0; }),
              ElementsAre("a east: has another length than 'c' gives it",
                          "c west: has another length than 'a' gives it"));
  EXPECT_THAT(
      problems_after([](auto& nodes) {
        nodes[0].side(CompassPoint::kEast).length_m = -3.0;
        nodes[2].side(CompassPoint::kWest).length_m = -3.0;
      }),
      ElementsAre("a east: has a length that is not above 0", "c west: has a length that is not above 0"));
}

TEST(HallwayMap, NamesWhatLeadsNowhere) {
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[5].side(CompassPoint::kNorth).to = 77; }),
              ElementsAre("e south: leads to 'f', whose north side does not lead back",
                          "f north: leads to a place that is not there"));
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[0].side(CompassPoint::kEast).to = 0; }),
              testing::Contains(HasSubstr("a east: leads back to itself")));
}

TEST(HallwayMap, NamesPlacesWithoutAHallwayOrAName) {
  EXPECT_THAT(problems_after([](auto& nodes) {
                nodes.push_back({"g", {}, {}});
              }),
              ElementsAre("g: no hallway leads here"));
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[1].name = "a"; }),
              testing::Contains("a: is there twice"));
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[1].name.clear(); }), testing::Contains(": has no name"));
}

TEST(HallwayMap, NamesTagsWhereNobodyCanCome) {
  EXPECT_THAT(problems_after([](auto& nodes) { nodes[0].side(CompassPoint::kWest).tags = {40}; }),
              ElementsAre("a west: has tags, and no hallway by which to come to them"));
}

}  // namespace
}  // namespace sensotwin::robot
