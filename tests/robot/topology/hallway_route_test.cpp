// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_route.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/base/random.hpp"
#include "tests/robot/topology/paper_map.hpp"

namespace sensotwin::robot {
namespace {

/// "c N d, d E e": the way in words.
std::string words(const HallwayMap& map, const HallwayRoute& route) {
  std::string text;
  for (const RouteStep& step : route.steps) {
    text += (text.empty() ? "" : ", ") + map.node(step.from).name + " " + letter_of(step.exit) + " " +
            map.node(step.to).name;
  }
  return text;
}

std::string way(const HallwayMap& map, const char* from, const char* to,
                const BlockedHallways& blocked = {}) {
  const auto route = plan_route(map, *map.find(from), *map.find(to), blocked);
  return route ? words(map, *route) : route.error() == RouteError::kNoWay ? "no way" : "by the unknown";
}

/// A street grid with random lengths; some hallways left out.
HallwayMap grid(int side, RandomStream& random) {
  HallwayMap map;
  for (int i = 0; i < side * side; ++i) {
    map.add("n" + std::to_string(i));
  }
  for (int i = 0; i < side * side; ++i) {
    const double length_m = 3.0 + 10.0 * random.uniform();
    const auto node = static_cast<NodeIndex>(i);
    if (i % side + 1 < side && random.uniform() < 0.8) {
      map.connect(node, CompassPoint::kEast, node + 1, length_m);
    }
    if (i / side + 1 < side && random.uniform() < 0.8) {
      map.connect(node, CompassPoint::kNorth, node + static_cast<NodeIndex>(side), 1.5 * length_m);
    }
  }
  return map;
}

/// Bellman and Ford: slow, and nothing like Dijkstra.
std::vector<double> all_costs(const HallwayMap& map, NodeIndex start) {
  std::vector<double> cost(map.nodes().size(), 1e9);
  cost[start] = 0.0;
  for (std::size_t round = 0; round < map.nodes().size(); ++round) {
    for (NodeIndex i = 0; i < map.nodes().size(); ++i) {
      for (const Side& side : map.node(i).sides) {
        if (side.hallway == Hallway::kLeadsTo) {
          cost[side.to] = std::min(cost[side.to], cost[i] + *side.length_m);
        }
      }
    }
  }
  return cost;
}

TEST(HallwayRoute, TurnsRightFromTheEastToTheNorthAsInThePaper) {
  EXPECT_EQ(turn_at(CompassPoint::kEast, CompassPoint::kNorth), 1);
  EXPECT_EQ(turn_at(CompassPoint::kSouth, CompassPoint::kNorth), 0);
  EXPECT_EQ(turn_at(CompassPoint::kSouth, CompassPoint::kWest), -1);
  EXPECT_EQ(turn_at(CompassPoint::kSouth, CompassPoint::kSouth), 2);
}

TEST(HallwayRoute, TakesTheFewestHallwaysWhereNoLengthIsKnown) {
  const HallwayMap map = paper_map();
  EXPECT_EQ(way(map, "b", "d"), "b N c, c N d");
  EXPECT_EQ(way(map, "a", "f"), "a E c, c E f");
  EXPECT_EQ(way(map, "d", "d"), "");
}

TEST(HallwayRoute, TakesTheShortestWhereAllLengthsAreKnown) {
  RandomStream random(5);
  int compared = 0;
  for (int round = 0; round < 20; ++round) {
    const HallwayMap map = grid(6, random);
    const std::vector<double> costs = all_costs(map, 0);
    for (NodeIndex goal = 0; goal < map.nodes().size(); ++goal) {
      const auto route = plan_route(map, 0, goal);
      ASSERT_EQ(static_cast<bool>(route), costs[goal] < 1e8);
      if (route) {
        EXPECT_NEAR(route->cost, costs[goal], 1e-9);
        EXPECT_TRUE(route->by_length);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 600);
}

TEST(HallwayRoute, GoesRoundABlockedHallway) {
  const HallwayMap map = paper_map();
  BlockedHallways blocked;
  blocked.block(map, *map.find("d"), CompassPoint::kSouth);
  EXPECT_EQ(way(map, "c", "d", blocked), "c E f, f N e, e W d");
  EXPECT_EQ(way(map, "d", "c", blocked), "d E e, e S f, f W c") << "blocked from both ends";
}

TEST(HallwayRoute, SaysWhetherAnUnknownHallwayMightHelp) {
  HallwayMap map = paper_map();
  map.add("x");
  BlockedHallways blocked;
  EXPECT_EQ(way(map, "a", "x", blocked), "by the unknown");
  blocked.block(map, *map.find("e"), CompassPoint::kEast);
  EXPECT_EQ(way(map, "a", "x", blocked), "no way");
}

TEST(NearestUnknown, IsWhereTheMapEnds) {
  const HallwayMap map = paper_map();
  const auto frontier = nearest_unknown(map, *map.find("d"), CompassPoint::kNorth);
  ASSERT_TRUE(frontier);
  EXPECT_EQ(words(map, frontier->route), "d E e");
  EXPECT_EQ(frontier->exit, CompassPoint::kEast);
}

TEST(NearestUnknown, OfOnePlaceIsTheOneAheadThenRightThenLeft) {
  HallwayMap map;
  const NodeIndex only = map.add("only");
  map.set_hallway(only, CompassPoint::kWest, Hallway::kUnknown);
  EXPECT_EQ(nearest_unknown(map, only, CompassPoint::kNorth)->exit, CompassPoint::kWest);
  map.set_hallway(only, CompassPoint::kEast, Hallway::kUnknown);
  EXPECT_EQ(nearest_unknown(map, only, CompassPoint::kNorth)->exit, CompassPoint::kEast);
  map.set_hallway(only, CompassPoint::kNorth, Hallway::kUnknown);
  EXPECT_EQ(nearest_unknown(map, only, CompassPoint::kNorth)->exit, CompassPoint::kNorth);
}

TEST(NearestUnknown, IsNoneWhenTheMapIsWholeOrTheRestBlocked) {
  HallwayMap map = paper_map();
  BlockedHallways blocked;
  blocked.block(map, *map.find("e"), CompassPoint::kEast);
  EXPECT_FALSE(nearest_unknown(map, 0, CompassPoint::kNorth, blocked));
  map.set_hallway(*map.find("e"), CompassPoint::kEast, Hallway::kNone);
  EXPECT_FALSE(nearest_unknown(map, 0, CompassPoint::kNorth));
}

}  // namespace
}  // namespace sensotwin::robot
