// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/robot/phase/estimation/curve_runs.hpp"

// The project's goals over 200 seeds, without floor tags. Each test prints its row of the table: quantiles of
// the RMSE, and the bound for estimating on the same way.
namespace sensotwin::robot::testing {
namespace {

constexpr std::uint64_t kSeeds = 200;

struct Goal {
  const char* name;
  double median_cm;
};

struct Case {
  KinematicRadio radio;
  bool stop_at_corners{true};
  double echo_rad{0.0};  ///< what the robot reckons with
};

void judge(PhaseExperiment experiment, const Case& c, const Goal& goal) {
  for (KinematicTag& tag : experiment.tags) {
    tag.floor_tag = false;
  }
  CeilingMissionConfig config = mission_for(experiment, c.radio, c.stop_at_corners);
  config.estimator.reader.noise.echo_rad = c.echo_rad;
  std::vector<double> rmse_cm;
  std::vector<double> time_s;
  std::vector<double> off_cm;
  std::uint64_t arrived = 0;
  int false_alarms = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const MissionRun run = run_mission(experiment, config, c.radio, {}, seed, 600.0);
    arrived += run.arrived ? 1 : 0;
    false_alarms += run.said(CeilingEventKind::kCablesSwapped) ? 1 : 0;
    rmse_cm.push_back(run.rmse_cm);
    time_s.push_back(run.time_s);
    off_cm.push_back(run.off_path_cm);
  }
  const double bound_cm = 100.0 * posterior_bound(bound_for(experiment, config, c.radio)).rms_m;
  std::printf("| %-12s | %-10s | %llu/%llu | %.2f / %.2f / %.2f | %.2f | %.2f | %.1f | %.1f |\n", goal.name,
              experiment.name.c_str(), static_cast<unsigned long long>(arrived),
              static_cast<unsigned long long>(kSeeds), quantile(rmse_cm, 0.1), quantile(rmse_cm, 0.5),
              quantile(rmse_cm, 0.9), goal.median_cm, bound_cm, quantile(time_s, 0.5), quantile(off_cm, 1.0));
  EXPECT_EQ(arrived, kSeeds);
  EXPECT_EQ(false_alarms, 0);
  // A goal below the bound is nobody's to reach.
  EXPECT_LT(quantile(rmse_cm, 0.5), std::max(goal.median_cm, bound_cm));
}

void judge_all(const Case& c, const char* name, double line_cm, double star_cm, double hallway_cm) {
  judge(line_at_90(), c, {name, line_cm});
  judge(star(), c, {name, star_cm});
  judge(hallway(), c, {name, hallway_cm});
}

TEST(TwoHundredSeeds, AtConstantSpeed) {
  judge_all({.radio = {}, .stop_at_corners = false}, "constant", 1.3, 4.0, 3.0);
}

TEST(TwoHundredSeeds, SlowingAndTurningOnTheSpot) {
  judge_all({.radio = {}}, "slow", 1.0, 1.5, 2.0);
}

TEST(TwoHundredSeeds, WithAntennasReadFiftyMillisecondsApart) {
  KinematicRadio radio;
  radio.simultaneous = false;
  judge_all({.radio = radio}, "multiplexed", 1.5, 2.0, 3.0);
}

TEST(TwoHundredSeeds, MonostaticAndKnownUpToPi) {
  KinematicRadio radio;
  radio.monostatic = true;
  radio.pi_ambiguous = true;
  judge_all({.radio = radio}, "mono, pi", 2.0, 2.0, 5.0);
}

TEST(TwoHundredSeeds, WithThreeEchoesOfATenth) {
  KinematicRadio radio;
  radio.images = 3;
  radio.image_amplitude = 0.1;
  // Of the two ways together 0.17 rad root mean square; half as much again, because echoes are no
  // Gauss-Markov process.
  judge_all({.radio = radio, .echo_rad = 0.25}, "echoes 0.1", 2.5, 3.0, 4.0);
}

TEST(TwoHundredSeeds, WithHalfTheReadsLost) {
  KinematicRadio radio;
  radio.loss = 0.5;
  judge_all({.radio = radio}, "half lost", 1.5, 2.0, 3.0);
}

void judge_curve(const CurveExperiment& curve, const char* name) {
  std::vector<double> first;
  std::vector<double> later;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const CurveRun run = run_curve(curve, seed);
    EXPECT_TRUE(run.arrived) << name << ", seed " << seed;
    first.push_back(run.first_lap_cm);
    later.push_back(run.later_laps_cm);
  }
  std::printf("| %-12s | first lap %.2f / %.2f / %.2f | later %.2f / %.2f / %.2f |\n", name,
              quantile(first, 0.1), quantile(first, 0.5), quantile(first, 0.9), quantile(later, 0.1),
              quantile(later, 0.5), quantile(later, 0.9));
  EXPECT_LT(quantile(first, 0.5), 1.5);
  EXPECT_LT(quantile(later, 0.5), 0.5);
}

TEST(TwoHundredSeeds, OnCurves) {
  judge_curve(circle_of_tags(2.0, 8, 2), "circle");
  judge_curve(figure_of_eight(2), "eight");
  judge_curve(s_curve(), "S");
}

}  // namespace
}  // namespace sensotwin::robot::testing
