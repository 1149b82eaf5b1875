// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "robot/mapping/explorer_kind.hpp"
#include "robot/mapping/mapping_mission.hpp"
#include "tests/robot/mapping/kinematic_carpet.hpp"

namespace sensotwin::robot::testing {

/// A mapping mission on a drawn room, and what came of it.
struct Drive {
  KinematicCarpet carpet;
  MappingMission mission;
  Command command{};
  std::vector<MissionEvent> events{};

  explicit Drive(const std::vector<std::string>& plan, const KinematicCarpet::Errors& errors = {},
                 ExplorerKind explorer = kDefaultExplorer, const MappingConfig& config = {},
                 std::uint64_t seed = 1)
      : carpet(plan, errors, seed), mission(config, make_explorer(explorer)) {}

  void step() {
    command = mission.step(carpet.step(command));
    const std::vector<MissionEvent> new_events = mission.log().take();
    events.insert(events.end(), new_events.begin(), new_events.end());
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) {
      step();
    }
  }
  /// Until the mission is over. \param limit_s  no room in these tests takes longer
  /// \returns whether it ended by itself
  bool run(double limit_s = 3600.0) {
    const Instant limit = carpet.now() + from_s(limit_s);
    while (!mission.done() && carpet.now() < limit) {
      step();
    }
    return mission.done();
  }
  /// Until the tag of this tile of the plan was found. \returns false when the mission ended before
  bool run_until_found(Tile plan_tile) {
    while (!mission.done() && !mission.map().visited(in_M(plan_tile))) {
      step();
    }
    return !mission.done();
  }
  /// The start is the robot's (0, 0), and it faces east there.
  [[nodiscard]] Tile in_M(Tile plan_tile) const {
    return {plan_tile.column - carpet.start().column, plan_tile.row - carpet.start().row};
  }
  [[nodiscard]] int times(MissionEventKind kind) const {
    return static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [kind](const MissionEvent& e) { return e.kind == kind; }));
  }
  [[nodiscard]] double elapsed_s() const { return to_s(carpet.now()); }
};

/// Every tag of the plan is in the map at its place, no other is, and each was given its coordinates.
inline void expect_whole_map(const Drive& drive) {
  EXPECT_TRUE(drive.mission.succeeded());
  for (const Tile tile : drive.carpet.tags()) {
    const TagUid tag = KinematicCarpet::uid(tile);
    EXPECT_EQ(drive.mission.map().tag_on(drive.in_M(tile)), tag)
        << "column " << tile.column << ", row " << tile.row;
    const auto written = drive.carpet.written().find(tag);
    EXPECT_TRUE(written != drive.carpet.written().end() && written->second == drive.in_M(tile))
        << "coordinates of column " << tile.column << ", row " << tile.row;
  }
  EXPECT_EQ(drive.mission.map().visited_count(), drive.carpet.tags().size());
}

}  // namespace sensotwin::robot::testing
