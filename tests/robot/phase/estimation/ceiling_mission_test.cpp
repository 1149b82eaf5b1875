// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/ceiling_mission.hpp"

#include <gtest/gtest.h>

#include "tests/robot/phase/estimation/mission_runs.hpp"

namespace sensotwin::robot::testing {
namespace {

/// No floor tags: what arrives, arrives by the estimate.
PhaseExperiment without_floor_tags(PhaseExperiment experiment) {
  for (KinematicTag& tag : experiment.tags) {
    tag.floor_tag = false;
  }
  return experiment;
}

MissionRun run_hallway(const CeilingMissionConfig& config, const KinematicRadio& radio, std::uint64_t seed,
                       const MissionHook& hook = {}) {
  return run_mission(without_floor_tags(hallway()), config, radio, {}, seed, 600.0, hook);
}

CeilingMissionConfig hallway_mission() {
  return mission_for(hallway(), {}, true);
}

/// \returns median error in centimetres of ten seeds, all of which arrive
double median_cm(const PhaseExperiment& experiment, bool stop_at_corners) {
  std::vector<double> rmse_cm;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const MissionRun run = run_mission(without_floor_tags(experiment),
                                       mission_for(experiment, {}, stop_at_corners), {}, {}, seed);
    EXPECT_TRUE(run.arrived) << experiment.name << ", seed " << seed;
    rmse_cm.push_back(run.rmse_cm);
  }
  return quantile(rmse_cm, 0.5);
}

// Goals of the project: medians in centimetres, "constant 0.2 m/s" and "allowed to slow and turn in place".
TEST(CeilingMission, KeepsToTheLineAtConstantSpeed) {
  EXPECT_LT(median_cm(line_at_90(), false), 1.3);
}
TEST(CeilingMission, KeepsToTheStarAtConstantSpeed) {
  EXPECT_LT(median_cm(star(), false), 4.0);
}
TEST(CeilingMission, KeepsToTheHallwayAtConstantSpeed) {
  EXPECT_LT(median_cm(hallway(), false), 3.0);
}
TEST(CeilingMission, KeepsToTheLineWhenItMayStop) {
  EXPECT_LT(median_cm(line_at_90(), true), 1.0);
}
TEST(CeilingMission, KeepsToTheStarWhenItMayTurnOnTheSpot) {
  EXPECT_LT(median_cm(star(), true), 1.5);
}
TEST(CeilingMission, KeepsToTheHallwayWhenItMayTurnOnTheSpot) {
  EXPECT_LT(median_cm(hallway(), true), 2.0);
}

TEST(CeilingMission, SaysNothingOfFaultsWhereThereAreNone) {
  const MissionRun run = run_hallway(hallway_mission(), {}, 3);
  ASSERT_TRUE(run.arrived);
  for (const CeilingEvent& event : run.events) {
    EXPECT_TRUE(event.kind == CeilingEventKind::kTagFound || event.kind == CeilingEventKind::kTagReached ||
                event.kind == CeilingEventKind::kArrived)
        << say(event.kind);
  }
}

TEST(CeilingMission, FindsAndSaysThatTheAntennaCablesAreSwappedAndArrives) {
  KinematicRadio radio;
  radio.cables_swapped = true;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const MissionRun run = run_hallway(hallway_mission(), radio, seed);
    EXPECT_TRUE(run.arrived);
    EXPECT_TRUE(run.said(CeilingEventKind::kCablesSwapped));
    EXPECT_LT(run.off_path_cm, 50.0);
  }
}

TEST(CeilingMission, DrivesOnThroughTwoSecondsOfSilenceAndSaysSo) {
  bool silenced = false;
  const MissionHook hook = [&](KinematicRobot& robot, const CeilingMission&) {
    if (!silenced && to_s(robot.now()) > 60.0) {
      robot.silence(robot.now(), robot.now() + from_s(2.0), false);
      silenced = true;
    }
  };
  const MissionRun run = run_hallway(hallway_mission(), {}, 2, hook);
  EXPECT_TRUE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kReaderSilent));
  EXPECT_TRUE(run.said(CeilingEventKind::kReaderBack));
  EXPECT_LT(run.rmse_cm, 2.0);
}

/// A run whose reader is down for so long from the start.
MissionRun run_with_reader_up_after(double s) {
  const MissionHook hook = [s](KinematicRobot& robot, const CeilingMission&) {
    if (robot.now() == Instant{}) {
      robot.silence(Instant{}, Instant{} + from_s(s), true);
    }
  };
  return run_hallway(hallway_mission(), {}, 2, hook);
}

TEST(CeilingMission, AReaderThatIsSetUpWhileTheMissionBeginsHasNotFallenSilent) {
  const MissionRun run = run_with_reader_up_after(0.1);
  EXPECT_TRUE(run.arrived);
  EXPECT_FALSE(run.said(CeilingEventKind::kReaderSilent));
  EXPECT_FALSE(run.said(CeilingEventKind::kReaderBack));
}

TEST(CeilingMission, AReaderThatDoesNotComeUpInHalfASecondIsSaidToBeSilent) {
  const MissionRun run = run_with_reader_up_after(2.0);
  EXPECT_TRUE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kReaderSilent));
  EXPECT_TRUE(run.said(CeilingEventKind::kReaderBack));
}

TEST(CeilingMission, StopsForGoodWhenTheReaderStaysSilent) {
  CeilingMissionConfig config = hallway_mission();
  config.faults.give_up_s = 20.0;
  const MissionHook hook = [](KinematicRobot& robot, const CeilingMission&) {
    if (robot.now() == Instant{}) {
      robot.silence(Instant{} + from_s(60.0), Instant{} + from_s(1e6), true);
    }
  };
  const MissionRun run = run_hallway(config, {}, 2, hook);
  EXPECT_FALSE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kStopped));
  EXPECT_LT(run.time_s, 90.0);
  EXPECT_LT(run.off_path_cm, 20.0);
}

TEST(CeilingMission, ArrivesWithHalfTheReadsLost) {
  KinematicRadio radio;
  radio.loss = 0.5;
  const MissionRun run = run_hallway(hallway_mission(), radio, 4);
  EXPECT_TRUE(run.arrived);
  EXPECT_LT(run.rmse_cm, 3.0);
}

TEST(CeilingMission, LearnsThatTheNoiseIsThreeTimesWhatItWasTold) {
  KinematicRadio radio;
  radio.noise_rad_per_m *= 3.0;
  double learned = 0.0;
  const MissionRun run =
      run_hallway(hallway_mission(), radio, 5,
                  [&](KinematicRobot&, const CeilingMission& m) { learned = m.estimator().noise_scale(); });
  EXPECT_TRUE(run.arrived);
  EXPECT_NEAR(learned, 3.0, 0.5);
}

PhaseExperiment hallway_without(std::size_t tag) {
  PhaseExperiment experiment = without_floor_tags(hallway());
  experiment.tags[tag].present = false;
  return experiment;
}

TEST(CeilingMission, SkipsAMissingTagWithAWord) {
  const MissionRun run = run_mission(hallway_without(3), hallway_mission(), {}, {}, 1, 600.0);
  EXPECT_TRUE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kTagMissing));
  EXPECT_EQ(run.skipped, 1);
}

TEST(CeilingMission, StopsAtAMissingTagIfSoConfigured) {
  CeilingMissionConfig config = hallway_mission();
  config.faults.on_missing = OnTagFault::kStop;
  const MissionRun run = run_mission(hallway_without(3), config, {}, {}, 1, 600.0);
  EXPECT_FALSE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kTagMissing));
  EXPECT_LT(run.off_path_cm, 10.0);
}

TEST(CeilingMission, SearchesForAMissingTagThenSkipsItIfSoConfigured) {
  CeilingMissionConfig config = hallway_mission();
  config.faults.on_missing = OnTagFault::kSearch;
  const MissionRun run = run_mission(hallway_without(3), config, {}, {}, 1, 600.0);
  EXPECT_TRUE(run.said(CeilingEventKind::kSearching));
  EXPECT_TRUE(run.said(CeilingEventKind::kTagSkipped));
  EXPECT_TRUE(run.arrived);
}

TEST(CeilingMission, NoticesThatATagWasMovedAndGoesWhereItHangsNow) {
  const MissionHook hook = [](KinematicRobot& robot, const CeilingMission& mission) {
    if (mission.leg() == 1 && to_s(robot.now()) > 20.0 && robot.tags()[1].at_m.x() < 8.5) {
      robot.tags()[1].at_m = {9.0, 0.0};
    }
  };
  const MissionRun run = run_hallway(hallway_mission(), {}, 1, hook);
  EXPECT_TRUE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kTagLost));
  EXPECT_TRUE(run.said(CeilingEventKind::kTagMoved));
}

TEST(CeilingMission, NoticesTwoEpcsSwappedAndGoesOnWithTheOrderThatIsShorter) {
  PhaseExperiment swapped = without_floor_tags(hallway());
  CeilingMissionConfig config = hallway_mission();
  config.faults.order_factor = 1.2;
  std::swap(swapped.tags[2].epc, swapped.tags[3].epc);
  const MissionRun run = run_mission(swapped, config, {}, {}, 1, 600.0);
  EXPECT_TRUE(run.arrived);
  EXPECT_TRUE(run.said(CeilingEventKind::kOrderDoubtful));
  EXPECT_TRUE(run.said(CeilingEventKind::kOrderExchanged));
  EXPECT_LT(run.off_path_cm, 20.0);
}

TEST(CeilingMission, BacksOffAfterABumpAndStopsForGoodAfterTheFourthOnALeg) {
  CeilingMission mission{hallway_mission()};
  KinematicRobot robot{without_floor_tags(hallway()).tags, {}, {}, {}, 1};
  PhaseCommand command;
  bool backed = false;
  while (!mission.done() && to_s(robot.now()) < 60.0) {
    PhaseSensed sensed = robot.step(command);
    sensed.bump_left = robot.X_WR().p_m.x() > 1.0;
    command = mission.step(sensed);
    backed = backed || command.wheels.left_mps < 0.0;
    EXPECT_LT(robot.X_WR().p_m.x(), 1.02);
  }
  EXPECT_TRUE(backed);
  EXPECT_TRUE(mission.done());
  EXPECT_FALSE(mission.arrived());
}

TEST(CeilingMission, UsesAReaderWhosePhaseFallsWithDistance) {
  KinematicRadio radio;
  radio.phase_sign = -1.0;
  const MissionRun run = run_hallway(mission_for(hallway(), radio, true), radio, 1);
  EXPECT_TRUE(run.arrived);
  EXPECT_LT(run.rmse_cm, 2.0);
}

}  // namespace
}  // namespace sensotwin::robot::testing
