// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/robot/phase/estimation/mission_runs.hpp"

namespace sensotwin::robot::testing {

/// A closed or open curve through tags, driven once or twice (algorithms study, A.5). The robot starts under
/// the first tag, heading along the curve.
struct CurveExperiment {
  PhaseExperiment tags;
  std::size_t tags_per_lap{0};
};

[[nodiscard]] CurveExperiment circle_of_tags(double radius_m, int tags, int laps);
/// 6 x 3.6 m, 12 tags.
[[nodiscard]] CurveExperiment figure_of_eight(int laps);
[[nodiscard]] CurveExperiment s_curve();

struct CurveRun {
  bool arrived{false};
  double first_lap_cm{0.0};   ///< RMS distance from the curve through the true projections
  double later_laps_cm{0.0};  ///< the same; zero where there is one lap
};

[[nodiscard]] CurveRun run_curve(const CurveExperiment& curve, std::uint64_t seed);

}  // namespace sensotwin::robot::testing
