// SPDX-License-Identifier: MIT
#include "tests/robot/phase/fuzzy_study.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot::testing {

FuzzySetup reproduction() {
  FuzzySetup setup;
  setup.radio.floor_radius_m = 0.015;
  return setup;
}

FuzzySetup tuned() {
  FuzzySetup setup;
  setup.sets = kTunedSets;
  setup.radio.floor_radius_m = 0.05;
  return setup;
}

FuzzyRun run_fuzzy(const PhaseExperiment& experiment, const FuzzySetup& setup, std::uint64_t seed) {
  KinematicRobot robot{experiment.tags, experiment.X_WR_start, setup.errors, setup.radio, seed};
  FuzzyMissionConfig config;
  config.destinations = experiment.destinations();
  config.sets = setup.sets;
  config.pairing = setup.pairing;
  FuzzyMission mission{config};
  PathScore score{experiment};
  FuzzyRun run;
  PhaseCommand command;
  while (!mission.done()) {
    command = mission.step(robot.step(command));
    score.sample(mission.status().destination, robot.X_WR().p_m);
    if (mission.status().destination == 0) {
      run.first_tag_s = to_s(robot.now());
    }
  }
  run.arrived = mission.arrived();
  run.rmse_m = score.rmse_m();
  run.error_min_m = score.error_min_m();
  run.error_max_m = score.error_max_m();
  run.seconds = to_s(robot.now());
  return run;
}

std::vector<FuzzyRun> run_fuzzy(const PhaseExperiment& experiment, const FuzzySetup& setup,
                                std::uint64_t first, int count) {
  std::vector<FuzzyRun> runs;
  for (int i = 0; i < count; ++i) {
    runs.push_back(run_fuzzy(experiment, setup, first + static_cast<std::uint64_t>(i)));
  }
  return runs;
}

double share_arrived(const std::vector<FuzzyRun>& runs) {
  const auto arrived =
      std::count_if(runs.begin(), runs.end(), [](const FuzzyRun& run) { return run.arrived; });
  return static_cast<double>(arrived) / static_cast<double>(runs.size());
}

double quantile(const std::vector<FuzzyRun>& runs, double FuzzyRun::*what, double part) {
  std::vector<double> values;
  for (const FuzzyRun& run : runs) {
    values.push_back(run.*what);
  }
  std::sort(values.begin(), values.end());
  const double at = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
}

}  // namespace sensotwin::robot::testing
