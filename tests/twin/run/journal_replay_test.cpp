// SPDX-License-Identifier: MIT
// A bug report is one file: what a journal holds is enough to run its program again, whatever the mission.
#include "robot/replay/journal_replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mapping_case.hpp"
#include "robot/journal/replay.hpp"
#include "robot/replay/journal_file.hpp"
#include "twin/run/scene_run.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Journalled {
  const char* name;
  const char* scene;
  std::vector<std::string> set;
};

/// Runs a scene of the gallery. \returns its journal
robot::Journal journal_of(const Journalled& wanted) {
  const TemporaryFolder folder;
  robot::RunFolder results(folder / "run", robot::Existing::kRefuse);
  SceneRunOptions options;
  options.pictures = false;
  options.journal = folder / "journal";
  const Scene scene =
      read_scene(std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes" / wanted.scene, {.set = wanted.set});
  (void)run_scene(scene, results, options);
  return robot::journal_in(folder / "journal");
}

class JournalOf : public testing::TestWithParam<Journalled> {};

TEST_P(JournalOf, IsReplayedWithTheSameCommandsByteForByte) {
  const robot::Journal journal = journal_of(GetParam());
  const robot::ReplayOutcome outcome = robot::replay(journal, "journal");
  EXPECT_FALSE(outcome.difference) << robot::report_of(outcome, journal, false);
  EXPECT_GT(outcome.steps, 100u);
  EXPECT_GT(outcome.bytes_compared, 100u);
}

TEST_P(JournalOf, TellsAProgramThatWouldHaveDecidedOtherwise) {
  robot::Journal journal = journal_of(GetParam());
  // Everything the robot was told goes on, but its wheels stand on another base.
  const std::string key = "wheel_base_m: ";
  const std::size_t at = journal.robot_file.find(key);
  ASSERT_NE(at, std::string::npos);
  journal.robot_file.replace(at + key.size(), std::string{"0.235"}.size(), "0.225");
  EXPECT_TRUE(robot::replay(journal, "journal").difference);
}

const Journalled kMissions[] = {
    {"Mapping", "lesson_2x2.yaml", {}},
    {"FuzzyPath", "line_at_0.yaml", {}},
    {"OwnPath", "line_at_0.yaml", {"mission.phase.controller=own"}},
    {"Hallways", "office.yaml", {"time_limit_s=60"}},
    {"Survey", "office.yaml", {"mission.hallway={ survey: true }", "time_limit_s=60"}},
};
INSTANTIATE_TEST_SUITE_P(EachMission, JournalOf, testing::ValuesIn(kMissions),
                         [](const auto& mission) { return std::string{mission.param.name}; });

TEST(Journal, HoldsTheHallwayMapItself) {
  const robot::Journal journal = journal_of({"", "office.yaml", {"time_limit_s=2"}});
  EXPECT_THAT(journal.robot_file, HasSubstr("places:"));
  EXPECT_THAT(journal.robot_file, Not(HasSubstr(".yaml")));
}

}  // namespace
}  // namespace sensotwin::twin
