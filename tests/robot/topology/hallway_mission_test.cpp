// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_mission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/robot/topology/kinematic_hallways.hpp"
#include "tests/robot/topology/office_map.hpp"

namespace sensotwin::robot {
namespace {

constexpr double kWidth_m = 2.0;

struct Outcome {
  bool arrived{false};
  double way_m{0.0};
  double shortest_m{0.0};
  int touches{0};
  double end_error_m{0.0};
  std::vector<HallwayEvent> events;

  [[nodiscard]] int count(HallwayEventKind kind) const {
    return static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [&](const HallwayEvent& event) { return event.kind == kind; }));
  }
  [[nodiscard]] std::string story() const {
    std::string text;
    for (const HallwayEvent& event : events) {
      text += std::to_string(to_s(event.stamp)).substr(0, 6) + " " + std::string{words(event.kind)} + " " +
              event.place + (event.side ? std::string(" ") + letter_of(*event.side) : "") + "\n";
    }
    return text;
  }
};

struct Trip {
  HallwayMap map = office();
  const char* from{"a0"};
  const char* to{"c3"};
  HallwayFaults faults{};
  std::uint64_t seed{1};
  bool start_known{true};
};

template <class Meanwhile>
Outcome travel(const Trip& trip, const Meanwhile& meanwhile) {
  HallwayMissionConfig config;
  config.map = trip.map;
  config.goal = *trip.map.find(trip.to);
  const NodeIndex start = *trip.map.find(trip.from);
  if (trip.start_known) {
    config.start = start;
  }
  HallwayMission mission(config);
  KinematicHallways building(trip.map, kWidth_m, {*trip.map.node(start).at_m, 0.5 * kPi}, trip.faults,
                             RandomStream(trip.seed));
  for (int tick = 0; tick < 60000 && !mission.done(); ++tick) {
    building.drive(mission.step(building.sense()));
    meanwhile(building, tick);
  }
  Outcome outcome;
  outcome.arrived = mission.status().arrived;
  outcome.way_m = building.way_m();
  outcome.shortest_m = plan_route(trip.map, start, config.goal)->cost;
  outcome.touches = building.touches();
  outcome.end_error_m = (building.X_WR().p_m - *trip.map.node(config.goal).at_m).norm();
  outcome.events = mission.log().take();
  return outcome;
}
Outcome travel(const Trip& trip) {
  return travel(trip, [](KinematicHallways&, int) {});
}

TEST(HallwayMission, GoesFromEveryPlaceToEveryOtherByTheShortestWay) {
  const HallwayMap map = office();
  double way_m = 0.0;
  double shortest_m = 0.0;
  for (const HallwayNode& from : map.nodes()) {
    for (const HallwayNode& to : map.nodes()) {
      if (from.name == to.name) {
        continue;
      }
      Trip trip;
      trip.from = from.name.c_str();
      trip.to = to.name.c_str();
      const Outcome outcome = travel(trip);
      ASSERT_TRUE(outcome.arrived) << from.name << " to " << to.name << "\n" << outcome.story();
      EXPECT_EQ(outcome.touches, 0) << from.name << " to " << to.name << "\n" << outcome.story();
      EXPECT_LT(outcome.end_error_m, 0.5) << from.name << " to " << to.name;
      way_m += outcome.way_m;
      shortest_m += outcome.shortest_m;
    }
  }
  EXPECT_LT(way_m / shortest_m, 1.05);
  EXPECT_GT(way_m / shortest_m, 0.90);
}

TEST(HallwayMission, FindsOutWhereItIsByTheFirstTag) {
  Trip trip;
  trip.start_known = false;
  trip.from = "b1";
  const Outcome outcome = travel(trip);
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kPlaced), 1) << outcome.story();
}

TEST(HallwayMission, ArrivesThoughTagsAreMissed) {
  int missed = 0;
  double way_m = 0.0;
  double shortest_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Trip trip;
    trip.seed = seed;
    trip.faults.tags_missed = 0.1;
    const Outcome outcome = travel(trip);
    ASSERT_TRUE(outcome.arrived) << seed << "\n" << outcome.story();
    EXPECT_EQ(outcome.touches, 0) << seed << "\n" << outcome.story();
    missed += outcome.count(HallwayEventKind::kTagMissed);
    way_m += outcome.way_m;
    shortest_m += outcome.shortest_m;
  }
  EXPECT_GT(missed, 3);
  EXPECT_LT(way_m / shortest_m, 1.05);
}

TEST(HallwayMission, GoesRoundABoxWhereThereIsRoom) {
  Trip trip;
  trip.to = "a3";
  trip.faults.boxes_m = {{3.5, 0.25}};
  const Outcome outcome = travel(trip);
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kWentRound), 1) << outcome.story();
  EXPECT_EQ(outcome.touches, 0) << outcome.story();
}

TEST(HallwayMission, WaitsForPeopleToGo) {
  Trip trip;
  trip.to = "a3";
  trip.faults.boxes_m = {{3.5, 0.5}, {3.5, 0.0}, {3.5, -0.5}};
  const Outcome outcome = travel(trip, [](KinematicHallways& building, int tick) {
    if (tick == 1000) {
      building.clear_boxes();
    }
  });
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kWaiting), 1) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kWentRound), 0) << outcome.story();
}

TEST(HallwayMission, TakesAnotherWayWhenAHallwayIsBlocked) {
  Trip trip;
  trip.to = "a3";
  trip.faults.boxes_m = {{10.5, 0.75}, {10.5, 0.25}, {10.5, -0.25}, {10.5, -0.75}};
  const Outcome outcome = travel(trip);
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kBlocked), 1) << outcome.story();
}

TEST(HallwayMission, StopsAndSaysWhyWhenNoWayIsLeft) {
  Trip trip;
  trip.from = "b0";
  trip.to = "c2";
  trip.faults.boxes_m = {{7.0, -9.0}, {7.5, -9.0}, {6.5, -9.0}, {7.9, -9.0}, {6.1, -9.0}};
  const Outcome outcome = travel(trip);
  EXPECT_FALSE(outcome.arrived);
  EXPECT_EQ(outcome.count(HallwayEventKind::kNoWay), 1) << outcome.story();
}

TEST(HallwayMission, SetsItsHeadingRightByATagWhenTheCompassLied) {
  Trip trip;
  trip.to = "a3";
  // The compass is a quarter turn off from the beginning: the robot goes south and thinks that it goes east.
  const Outcome outcome = travel(trip, [](KinematicHallways& building, int tick) {
    building.turn_compass(tick < 400 ? 0.5 * kPi : 0.0);
  });
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_GE(outcome.count(HallwayEventKind::kTurnedWrong), 1) << outcome.story();
}

TEST(HallwayMission, NoticesThatSomebodyTurnedItWhereItStood) {
  for (const double turn_rad : {-0.5 * kPi, 0.5 * kPi, kPi}) {
    Trip trip;
    trip.to = "a3";
    const Outcome outcome = travel(trip, [&](KinematicHallways& building, int tick) {
      if (tick == 12) {
        building.turn_by_hand(turn_rad);
      }
    });
    EXPECT_TRUE(outcome.arrived) << outcome.story();
    EXPECT_EQ(outcome.count(HallwayEventKind::kTurnedByHand), 1) << outcome.story();
    EXPECT_EQ(outcome.count(HallwayEventKind::kTurnedWrong), 0) << outcome.story();
    EXPECT_LT(outcome.way_m, 1.05 * outcome.shortest_m) << outcome.story();
  }
}

TEST(HallwayMission, BelievesNoCompassThatGoesOverToAnotherDirectionWhileItDrives) {
  Trip trip;
  trip.to = "a3";
  const Outcome outcome = travel(trip, [](KinematicHallways& building, int tick) {
    building.turn_compass(tick > 800 && tick < 1200 ? 0.5 * kPi : 0.0);
  });
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kTurnedByHand), 0) << outcome.story();
}

TEST(HallwayMission, GoesBackForTheTagOfAPlaceThatItIsNotSureOf) {
  int looks = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Trip trip;
    trip.to = "a1";
    trip.seed = seed;
    trip.faults.tags_missed = 0.5;
    // It is 7 m, and the map says 8: what the sonars see comes too early.
    trip.map.connect(*trip.map.find("a0"), CompassPoint::kEast, *trip.map.find("a1"), 8.0);
    const Outcome outcome = travel(trip);
    EXPECT_TRUE(outcome.arrived) << seed << "\n" << outcome.story();
    EXPECT_LT(outcome.end_error_m, 0.7) << seed << "\n" << outcome.story();
    looks += outcome.count(HallwayEventKind::kLooksAgain);
  }
  EXPECT_GT(looks, 2);
}

TEST(HallwayMission, GoesOnPastAPlaceThatItIsNotSureOfWhereItsWayLeadsStraightOnThere) {
  // Nothing is to be seen of a1 but its tags, and nothing turns there.
  int went_on = 0;
  int looks = 0;
  double way_m = 0.0;
  double shortest_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Trip trip;
    trip.to = "a3";
    trip.seed = seed;
    trip.faults.tags_missed = 0.4;
    const Outcome outcome = travel(trip);
    EXPECT_TRUE(outcome.arrived) << seed << "\n" << outcome.story();
    EXPECT_LT(outcome.end_error_m, 0.7) << seed << "\n" << outcome.story();
    went_on += outcome.count(HallwayEventKind::kGoesOn);
    looks += outcome.count(HallwayEventKind::kLooksAgain);
    way_m += outcome.way_m;
    shortest_m += outcome.shortest_m;
  }
  EXPECT_GT(went_on, 2);
  EXPECT_LT(looks, went_on);
  EXPECT_LT(way_m / shortest_m, 1.1);
}

TEST(HallwayMission, KnowsByItsTagThatAPlaceWhichItThoughtBehindIsOnlyComing) {
  Trip trip;
  trip.to = "a3";
  // It is 7 m to a1, and the map says 4.
  trip.map.connect(*trip.map.find("a0"), CompassPoint::kEast, *trip.map.find("a1"), 4.0);
  const Outcome outcome = travel(trip);
  EXPECT_TRUE(outcome.arrived) << outcome.story();
  EXPECT_LT(outcome.end_error_m, 0.5) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kGoesOn), 1) << outcome.story();
  EXPECT_EQ(outcome.count(HallwayEventKind::kTurnedWrong), 0) << outcome.story();
}

TEST(HallwayMission, EndsAtOnceWhereItIsTheGoal) {
  Trip trip;
  trip.from = "a0";
  trip.to = "a0";
  EXPECT_TRUE(travel(trip).arrived);
}

}  // namespace
}  // namespace sensotwin::robot
