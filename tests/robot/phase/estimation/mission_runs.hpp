// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "robot/phase/estimation/ceiling_mission.hpp"
#include "robot/phase/estimation/path_bound.hpp"
#include "tests/robot/phase/kinematic_robot.hpp"
#include "tests/robot/phase/phase_experiments.hpp"

namespace sensotwin::robot::testing {

/// What the robot is told of the kinematic robot's antennas and reader.
[[nodiscard]] PhaseReaderModel model_of(const KinematicRadio& radio);

/// The mission for an experiment: at constant speed, or braking and turning on the spot.
[[nodiscard]] CeilingMissionConfig mission_for(const PhaseExperiment& experiment, const KinematicRadio& radio,
                                               bool stop_at_corners);

/// The bound for estimating on the way of an experiment.
[[nodiscard]] PathBoundTask bound_for(const PhaseExperiment& experiment, const CeilingMissionConfig& config,
                                      const KinematicRadio& radio);

struct MissionRun {
  bool arrived{false};
  double rmse_cm{0.0};
  double worst_cm{0.0};
  double time_s{0.0};
  double driven_m{0.0};
  int skipped{0};
  int drops{0};
  int found{0};
  double end_error_cm{0.0};  ///< from the last tag's projection, at the end
  double off_path_cm{0.0};   ///< largest distance from the nearest point of the whole path
  std::vector<CeilingEvent> events;
  [[nodiscard]] bool said(CeilingEventKind kind) const;
};

/// Called before every step.
using MissionHook = std::function<void(KinematicRobot&, const CeilingMission&)>;
/// Signed distance from the true path, for paths that are not polylines. Frame: W.
using PathError = std::function<double(const CeilingMission&, const Vec2& p_W_m)>;

/// \param limit_s  a run is given up after this
[[nodiscard]] MissionRun run_mission(const PhaseExperiment& experiment, const CeilingMissionConfig& config,
                                     const KinematicRadio& radio, const KinematicErrors& errors,
                                     std::uint64_t seed, double limit_s = 900.0, const MissionHook& hook = {},
                                     const PathError& error = {});

/// The q-quantile, by linear interpolation. \pre !values.empty()
[[nodiscard]] double quantile(std::vector<double> values, double q);

}  // namespace sensotwin::robot::testing
