// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "robot/phase/fuzzy_mission.hpp"
#include "tests/robot/phase/kinematic_robot.hpp"
#include "tests/robot/phase/phase_experiments.hpp"

namespace sensotwin::robot::testing {

/// A controller, a reader and the air, to be tried with many seeds.
struct FuzzySetup {
  FuzzySets sets{kReproductionSets};
  PairingConfig pairing;
  KinematicRadio radio;
  KinematicErrors errors;
};

/// Preset P3 of the algorithms study, A.2: floor tags are read within 1.5 cm.
[[nodiscard]] FuzzySetup reproduction();
/// A.3: full turn rate, 5 cm.
[[nodiscard]] FuzzySetup tuned();

struct FuzzyRun {
  bool arrived{false};
  double rmse_m{0.0};
  double error_min_m{0.0};
  double error_max_m{0.0};
  double first_tag_s{0.0};  ///< until the first destination was reached; of the whole run if it never was
  double seconds{0.0};
};

[[nodiscard]] FuzzyRun run_fuzzy(const PhaseExperiment& experiment, const FuzzySetup& setup,
                                 std::uint64_t seed);
/// Seeds first .. first + count - 1.
[[nodiscard]] std::vector<FuzzyRun> run_fuzzy(const PhaseExperiment& experiment, const FuzzySetup& setup,
                                              std::uint64_t first, int count);

[[nodiscard]] double share_arrived(const std::vector<FuzzyRun>& runs);
/// Linear between order statistics. \param part  0..1. \pre not empty
[[nodiscard]] double quantile(const std::vector<FuzzyRun>& runs, double FuzzyRun::*what, double part);

}  // namespace sensotwin::robot::testing
