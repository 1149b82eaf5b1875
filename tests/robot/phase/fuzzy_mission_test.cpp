// SPDX-License-Identifier: MIT
#include "robot/phase/fuzzy_mission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/robot/phase/fuzzy_study.hpp"

namespace sensotwin::robot::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A mission on one of the experiments, step by step.
struct Drive {
  KinematicRobot robot;
  FuzzyMission mission;
  PhaseCommand command{};
  std::vector<FuzzyEventKind> events{};

  explicit Drive(const PhaseExperiment& experiment, const FuzzyMissionConfig& config = {},
                 const KinematicRadio& radio = {})
      : robot(experiment.tags, experiment.X_WR_start, {}, radio, 1), mission(with_list(config, experiment)) {}

  static FuzzyMissionConfig with_list(FuzzyMissionConfig config, const PhaseExperiment& experiment) {
    config.destinations = experiment.destinations();
    return config;
  }
  void step(bool bump = false) {
    PhaseSensed sensed = robot.step(command);
    sensed.bump_left = bump;
    command = mission.step(sensed);
    for (const FuzzyEvent& event : mission.log().take()) {
      events.push_back(event.kind);
    }
  }
  void run_to(double time_s) {
    while (!mission.done() && to_s(robot.now()) < time_s) {
      step();
    }
  }
  [[nodiscard]] bool standing() const { return command.wheels == WheelSpeeds{}; }
};

FuzzyMissionConfig tuned_mission() {
  FuzzyMissionConfig config;
  config.sets = kTunedSets;
  return config;
}

/// Both antennas read this tag at one instant, the left one ahead by `difference_rad`.
std::vector<UhfRead> pair_of(Instant at, const Epc& tag, double difference_rad) {
  UhfRead left;
  left.at = at;
  left.epc = tag;
  left.antenna = 1;
  left.phase_rad = 3.0 + difference_rad;
  UhfRead right = left;
  right.antenna = 2;
  right.phase_rad = 3.0;
  return {left, right};
}

PhaseCommand step_by_hand(FuzzyMission& mission, int at_ms, const Epc& tag, double difference_rad) {
  const Instant at = Instant{} + std::chrono::milliseconds{at_ms};
  const std::vector<UhfRead> reads = pair_of(at, tag, difference_rad);
  PhaseSensed sensed;
  sensed.stamp = at;
  sensed.reads = reads;
  return mission.step(sensed);
}

TEST(FuzzyMission, VisitsItsTagsInOrderAndStandsAtTheLast) {
  Drive drive{hallway(), tuned_mission()};
  drive.run_to(400.0);
  EXPECT_TRUE(drive.mission.arrived());
  EXPECT_TRUE(drive.standing());
  EXPECT_EQ(drive.mission.status().destination, 7u);
  EXPECT_LT((drive.robot.X_WR().p_m - Vec2{24, 4}).norm(), 0.06);
  EXPECT_EQ(std::count(drive.events.begin(), drive.events.end(), FuzzyEventKind::kArrived), 7);
  EXPECT_EQ(drive.events.back(), FuzzyEventKind::kDone);
}

TEST(FuzzyMission, TurnsTheDifferenceOfTheControllerIntoWheelSpeedsAtItsSpeed) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0)};
  FuzzyMission mission{config};
  const WheelSpeeds wheels = step_by_hand(mission, 15, experiment_epc(0), -1.5).wheels;
  EXPECT_NEAR((wheels.left_mps + wheels.right_mps) / 2.0, 0.2, 1e-12);
  EXPECT_NEAR((wheels.right_mps - wheels.left_mps) / 0.235, 1.1, 1e-12);
  EXPECT_EQ(mission.status().state, FuzzyState::kSteering);
  EXPECT_NEAR(mission.status().pair->difference_rad, -1.5, 1e-12);
  EXPECT_NEAR(mission.status().turn_rate_radps, 1.1, 1e-12);
}

TEST(FuzzyMission, KeepsItsSpeedWhateverItsControllerAsks) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0)};
  config.sets = fuzzy_sets(1.0, 9.0);
  FuzzyMission mission{config};
  const WheelSpeeds wheels = step_by_hand(mission, 15, experiment_epc(0), -1.5).wheels;
  EXPECT_NEAR(wheels.right_mps, 0.5, 1e-12);
  EXPECT_NEAR(wheels.left_mps, -0.1, 1e-12);
}

/// Asked for 1.1 rad/s, the wheels turn at `turned_radps` for half a second. \returns the rate commanded then
double rate_after_turning_at(double turned_radps) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0)};
  FuzzyMission mission{config};
  (void)step_by_hand(mission, 0, experiment_epc(0), -1.5);
  PhaseCommand command;
  double left_counts = 0.0;
  double right_counts = 0.0;
  PhaseSensed sensed;
  for (int at_ms = 15; at_ms <= 495; at_ms += 15) {
    const std::vector<UhfRead> reads =
        pair_of(Instant{} + std::chrono::milliseconds{at_ms}, experiment_epc(0), -1.5);
    const double old_left = std::floor(left_counts);
    const double old_right = std::floor(right_counts);
    left_counts += (0.2 - turned_radps * 0.235 / 2.0) * 0.015 / config.metres_per_count;
    right_counts += (0.2 + turned_radps * 0.235 / 2.0) * 0.015 / config.metres_per_count;
    sensed.stamp = Instant{} + std::chrono::milliseconds{at_ms};
    sensed.reads = reads;
    sensed.counts_left = static_cast<int>(std::floor(left_counts) - old_left);
    sensed.counts_right = static_cast<int>(std::floor(right_counts) - old_right);
    command = mission.step(sensed);
  }
  return (command.wheels.right_mps - command.wheels.left_mps) / 0.235;
}

TEST(FuzzyMission, MakesUpForWheelsThatTurnMoreOrLessThanAsked) {
  // A count of one wheel is 1.9 mrad, of which 6 a second are asked for.
  EXPECT_NEAR(rate_after_turning_at(1.1), 1.1, 0.03);
  EXPECT_NEAR(rate_after_turning_at(1.0), 1.1 + 6.0 * 0.1 * 0.495, 0.03);
  EXPECT_NEAR(rate_after_turning_at(1.2), 1.1 - 6.0 * 0.1 * 0.495, 0.03);
  // No more than so much is ever owed: wheels that cannot turn the robot are not driven ever harder.
  EXPECT_NEAR(rate_after_turning_at(0.0), 1.1 + 6.0 * 0.2, 0.03);
}

TEST(FuzzyMission, OwesNothingOnABaseWithoutEncoders) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0)};
  FuzzyMission mission{config};
  for (int at_ms = 15; at_ms <= 600; at_ms += 15) {
    const WheelSpeeds wheels = step_by_hand(mission, at_ms, experiment_epc(0), -1.5).wheels;
    EXPECT_NEAR((wheels.right_mps - wheels.left_mps) / 0.235, 1.1, 1e-12) << at_ms;
  }
  EXPECT_EQ(mission.status().owed_rad, 0.0);
}

TEST(FuzzyMission, TurnsOnUntilTheNextPhaseDifferenceButNotForLong) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0)};
  FuzzyMission mission{config};
  (void)step_by_hand(mission, 15, experiment_epc(0), -1.5);
  PhaseSensed sensed;
  for (int at_ms = 30; at_ms <= 600; at_ms += 15) {
    sensed.stamp = Instant{} + std::chrono::milliseconds{at_ms};
    const WheelSpeeds wheels = mission.step(sensed).wheels;
    EXPECT_EQ(wheels.right_mps > wheels.left_mps, at_ms <= 15 + 250) << at_ms;
  }
  EXPECT_EQ(mission.status().state, FuzzyState::kKeepingHeading);
  EXPECT_EQ(mission.status().decisions, 1u);
}

TEST(FuzzyMission, ListensToNoTagButItsDestination) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0), experiment_epc(1)};
  FuzzyMission mission{config};
  (void)step_by_hand(mission, 15, experiment_epc(1), -1.5);
  EXPECT_EQ(mission.status().decisions, 0u);
  PhaseSensed sensed;
  sensed.stamp = Instant{} + std::chrono::milliseconds{30};
  sensed.floor_tag = experiment_epc(1);
  (void)mission.step(sensed);
  EXPECT_EQ(mission.status().destination, 0u);
}

TEST(FuzzyMission, SteersToTheNextTagInTheVeryStepInWhichItArrives) {
  FuzzyMissionConfig config;
  config.destinations = {experiment_epc(0), experiment_epc(1)};
  FuzzyMission mission{config};
  std::vector<UhfRead> reads = pair_of({}, experiment_epc(0), 1.0);
  for (const UhfRead& read : pair_of({}, experiment_epc(1), -1.5)) {
    reads.push_back(read);
  }
  PhaseSensed sensed;
  sensed.reads = reads;
  sensed.floor_tag = experiment_epc(0);
  const WheelSpeeds wheels = mission.step(sensed).wheels;
  EXPECT_EQ(mission.status().destination, 1u);
  EXPECT_NEAR(mission.status().pair->difference_rad, -1.5, 1e-12);
  EXPECT_GT(wheels.right_mps, wheels.left_mps);
}

TEST(FuzzyMission, StopsAndWaitsWhenItsTagFallsSilentAndGoesOnWhenItIsHeard) {
  Drive drive{line_at_90(), tuned_mission()};
  drive.robot.silence(Instant{} + from_s(10.0), Instant{} + from_s(20.0), false);
  drive.run_to(11.9);
  EXPECT_FALSE(drive.standing());
  EXPECT_EQ(drive.mission.status().state, FuzzyState::kKeepingHeading);
  drive.run_to(12.2);
  EXPECT_TRUE(drive.standing());
  EXPECT_EQ(drive.mission.status().state, FuzzyState::kWaiting);
  drive.run_to(100.0);
  EXPECT_TRUE(drive.mission.arrived());
  EXPECT_THAT(drive.events, ElementsAre(FuzzyEventKind::kLegBegun, FuzzyEventKind::kDestinationHeard,
                                        FuzzyEventKind::kDestinationSilent, FuzzyEventKind::kHeardAgain,
                                        FuzzyEventKind::kArrived, FuzzyEventKind::kLegBegun,
                                        FuzzyEventKind::kDestinationHeard, FuzzyEventKind::kArrived,
                                        FuzzyEventKind::kDone));
}

TEST(FuzzyMission, StopsAtOnceWhenItsReaderIsDown) {
  Drive drive{line_at_90(), tuned_mission()};
  drive.robot.silence(Instant{} + from_s(10.0), Instant{} + from_s(12.0), true);
  drive.run_to(10.05);
  EXPECT_TRUE(drive.standing());
  drive.run_to(100.0);
  EXPECT_TRUE(drive.mission.arrived());
  EXPECT_THAT(drive.events,
              ::testing::IsSupersetOf({FuzzyEventKind::kReaderDown, FuzzyEventKind::kReaderUp}));
}

TEST(FuzzyMission, GivesUpAfterItsPatienceAtAMissingTag) {
  PhaseExperiment experiment = line_at_90();
  experiment.tags[1].present = false;
  Drive drive{experiment, tuned_mission()};
  drive.run_to(200.0);
  EXPECT_TRUE(drive.mission.done());
  EXPECT_FALSE(drive.mission.arrived());
  EXPECT_TRUE(drive.standing());
  EXPECT_EQ(drive.events.back(), FuzzyEventKind::kGivenUp);
  // 0.2 m/s for two seconds of silence, from the first tag.
  EXPECT_LT(drive.robot.X_WR().p_m.norm(), 0.05 + 0.2 * 2.1);
}

TEST(FuzzyMission, StopsForGoodWhenItTouchesSomething) {
  Drive drive{line_at_90(), tuned_mission()};
  drive.run_to(5.0);
  drive.step(true);
  EXPECT_TRUE(drive.mission.done());
  EXPECT_FALSE(drive.mission.arrived());
  EXPECT_EQ(drive.events.back(), FuzzyEventKind::kBumped);
  drive.step();
  EXPECT_TRUE(drive.standing());
}

TEST(FuzzyMission, StopsWhenALegTakesTooLong) {
  FuzzyMissionConfig config = tuned_mission();
  config.leg_limit = std::chrono::seconds{20};
  Drive drive{line_at_90(), config};
  drive.run_to(100.0);
  EXPECT_TRUE(drive.mission.done());
  EXPECT_EQ(drive.mission.status().state, FuzzyState::kStopped);
  EXPECT_EQ(drive.events.back(), FuzzyEventKind::kLegTooLong);
  EXPECT_NEAR(to_s(drive.robot.now()), 20.0, 0.1);
}

TEST(FuzzyMission, DecidesOncePerPhaseDifferenceNotOncePerTick) {
  Drive drive{line_at_90(), tuned_mission()};
  drive.run_to(30.0);
  EXPECT_NEAR(static_cast<double>(drive.mission.status().decisions), 20.0 * 30.0, 1.0);
}

TEST(FuzzyMission, WithNoDestinationsIsDoneWhereItStands) {
  FuzzyMission mission{FuzzyMissionConfig{}};
  EXPECT_EQ(mission.step(PhaseSensed{}).wheels, WheelSpeeds{});
  EXPECT_TRUE(mission.arrived());
}

TEST(FuzzyMission, SurvivesHalfOfItsReadsBeingLost) {
  KinematicRadio radio;
  radio.loss = 0.5;
  Drive drive{hallway(), tuned_mission(), radio};
  drive.run_to(400.0);
  EXPECT_TRUE(drive.mission.arrived());
}

TEST(FuzzyEvents, AllHaveWords) {
  for (int kind = 0; kind <= static_cast<int>(FuzzyEventKind::kDone); ++kind) {
    EXPECT_THAT(std::string(words(static_cast<FuzzyEventKind>(kind))), ::testing::Not(IsEmpty()));
  }
}

}  // namespace
}  // namespace sensotwin::robot::testing
