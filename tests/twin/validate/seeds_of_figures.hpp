// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "twin/validate/report.hpp"

namespace sensotwin::twin {

/// Runs of seeds 1, 2 ... whose figure "minutes" has these values.
inline std::vector<RunOutcome> runs_with(const std::vector<double>& minutes) {
  std::vector<RunOutcome> runs;
  for (std::size_t i = 0; i < minutes.size(); ++i) {
    runs.push_back({.seed = i + 1, .figures = {{"minutes", minutes[i]}}, .state_hash = "00"});
  }
  return runs;
}

/// 1, 2 ... n.
inline std::vector<double> up_to(int n) {
  std::vector<double> values;
  for (int i = 1; i <= n; ++i) {
    values.push_back(i);
  }
  return values;
}

inline Scene expecting(const Expectation& expectation) {
  Scene scene;
  scene.name = "made_up";
  scene.expect.push_back(expectation);
  return scene;
}

/// A validation of those runs.
inline Validation validated(const Scene& scene, const std::vector<RunOutcome>& runs,
                            const JudgementOptions& options = {}) {
  Validation validation;
  validation.scene = "scenes/made_up.yaml";
  validation.name = scene.name;
  validation.scene_hash = "0123456789abcdef";
  for (const RunOutcome& run : runs) {
    validation.seeds.push_back(run.seed);
  }
  validation.runs = runs;
  validation.options = options;
  validation.judged = judge_seeds(scene, runs, options);
  validation.worst = worst_seeds(validation.judged, runs, 3);
  return validation;
}

}  // namespace sensotwin::twin
