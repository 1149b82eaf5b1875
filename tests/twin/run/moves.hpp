// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>

#include "mapping_case.hpp"

namespace sensotwin::twin {

/// Part of the moves that may miss their tag at the default read radius of 8 cm, slip and odometry.
inline constexpr double kMissedMax = 0.03;

/// Moves over several runs, and a line of text for each run that missed.
struct MoveCount {
  int moves{0};
  int missed{0};
  int recovered{0};
  std::string report;

  void add(const Scene& scene) {
    const MapResult result = *run_of(scene).map;
    moves += result.moves;
    missed += result.moves_missed;
    recovered += result.moves_recovered;
    if (result.moves_missed > 0) {
      std::ostringstream line;
      line << scene.name << ", " << result.explorer << ", seed " << scene.seed << ": " << result.moves_missed
           << " of " << result.moves << " missed, " << result.moves_recovered << " recovered\n";
      report += line.str();
    }
  }
};

}  // namespace sensotwin::twin
