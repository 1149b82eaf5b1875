// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/robot/topology/kinematic_hallways.hpp"
#include "tests/robot/topology/office_map.hpp"

namespace sensotwin::robot {
namespace {

struct Survey {
  HallwayMap map;
  bool whole{false};
  int touches{0};
  std::string story;
};

Survey explore(const char* from, std::uint64_t seed, const HallwayFaults& faults = {}) {
  const HallwayMap drawn = office();
  HallwaySurvey survey{HallwaySurveyConfig{}};
  KinematicHallways building(drawn, 2.0, {*drawn.node(*drawn.find(from)).at_m, 0.5 * kPi}, faults,
                             RandomStream(seed));
  for (int tick = 0; tick < 200000 && !survey.done(); ++tick) {
    building.drive(survey.step(building.sense()));
  }
  Survey found{survey.map(), survey.whole(), building.touches(), ""};
  for (const HallwayEvent& event : survey.log().take()) {
    found.story += std::to_string(to_s(event.stamp)).substr(0, 6) + " " + std::string{words(event.kind)} +
                   " " + event.place + (event.side ? std::string(" ") + letter_of(*event.side) : "") + "\n";
  }
  return found;
}

/// In what a survey's map differs from the drawn one, places told by their tags.
std::vector<std::string> differences(const HallwayMap& drawn, const HallwayMap& found,
                                     double length_slack_m) {
  std::vector<std::string> differences;
  const auto differ = [&](const HallwayNode& node, CompassPoint side, const std::string& what) {
    differences.push_back(node.name + " " + letter_of(side) + ": " + what);
  };
  if (drawn.nodes().size() != found.nodes().size()) {
    differences.push_back(std::to_string(found.nodes().size()) + " places");
  }
  std::vector<std::optional<NodeIndex>> same(drawn.nodes().size());
  for (NodeIndex i = 0; i < drawn.nodes().size(); ++i) {
    for (const CompassPoint side : kCompassPoints) {
      for (const TagNumber tag : drawn.node(i).side(side).tags) {
        if (const auto place = found.place_of(tag)) {
          if (place->from != side || (same[i] && *same[i] != place->node)) {
            differ(drawn.node(i), side, "its tag is elsewhere");
          }
          same[i] = place->node;
        } else {
          differ(drawn.node(i), side, "its tag is not there");
        }
      }
    }
  }
  for (NodeIndex i = 0; i < drawn.nodes().size(); ++i) {
    for (const CompassPoint side : kCompassPoints) {
      if (!same[i]) {
        continue;
      }
      const Side& is = found.node(*same[i]).side(side);
      const Side& should = drawn.node(i).side(side);
      if (is.hallway != should.hallway) {
        differ(drawn.node(i), side, "another hallway");
      } else if (should.hallway == Hallway::kLeadsTo &&
                 (!same[should.to] || is.to != *same[should.to] ||
                  std::abs(*is.length_m - *should.length_m) > length_slack_m)) {
        differ(drawn.node(i), side, "leads elsewhere or is of another length");
      }
    }
  }
  return differences;
}

TEST(HallwaySurvey, BuildsTheDrawnMapFromAnyPlaceAndTheCompass) {
  const HallwayMap drawn = office();
  for (const char* from : {"a0", "b1", "c3", "a2"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Survey survey = explore(from, seed);
      EXPECT_TRUE(survey.whole) << from << " " << seed << "\n" << survey.story;
      EXPECT_THAT(differences(drawn, survey.map, 0.5), testing::ElementsAre()) << from << " " << seed << "\n"
                                                                               << survey.story;
      EXPECT_EQ(survey.touches, 0) << from << " " << seed;
      EXPECT_TRUE(survey.map.check().empty());
    }
  }
}

TEST(HallwaySurvey, FindsAllPlacesThoughTagsAreMissed) {
  HallwayFaults faults;
  faults.tags_missed = 0.1;
  int whole = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Survey survey = explore("a0", seed, faults);
    EXPECT_TRUE(survey.map.check().empty());
    whole += survey.whole && survey.map.nodes().size() == 12 ? 1 : 0;
  }
  EXPECT_GE(whole, 9);
}

}  // namespace
}  // namespace sensotwin::robot
