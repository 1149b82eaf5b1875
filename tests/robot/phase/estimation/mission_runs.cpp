// SPDX-License-Identifier: MIT
#include "tests/robot/phase/estimation/mission_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sensotwin::robot::testing {
namespace {

constexpr double kLightSpeed_mps = 299792458.0;

double off_path_m(const PhaseExperiment& experiment, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < experiment.order.size(); ++i) {
    const Vec2& a = experiment.tags[experiment.order[i - 1]].at_m;
    const Vec2 along = experiment.tags[experiment.order[i]].at_m - a;
    const double part = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - part * along).norm());
  }
  return nearest;
}

}  // namespace

PhaseReaderModel model_of(const KinematicRadio& radio) {
  PhaseReaderModel model;
  model.antennas = antenna_pair(radio.spacing_m, radio.antenna_height_m);
  model.monostatic = radio.monostatic;
  model.transmitter_R_m = {0.0, 0.0, radio.antenna_height_m};
  model.phase_sign = radio.phase_sign;
  model.pi_ambiguous = radio.pi_ambiguous;
  model.centre_hz = kLightSpeed_mps / radio.wavelength_m;
  model.noise.per_m_rad = radio.noise_rad_per_m;
  return model;
}

CeilingMissionConfig mission_for(const PhaseExperiment& experiment, const KinematicRadio& radio,
                                 bool stop_at_corners) {
  CeilingMissionConfig config;
  config.estimator.reader = model_of(radio);
  config.estimator.floor_radius_m = radio.floor_radius_m;
  config.follower.stop_at_corners = stop_at_corners;
  for (const Epc& epc : experiment.destinations()) {
    config.route.push_back({.epc = epc, .height_m = 3.0});
  }
  return config;
}

PathBoundTask bound_for(const PhaseExperiment& experiment, const CeilingMissionConfig& config,
                        const KinematicRadio& radio) {
  PathBoundTask task;
  task.reader = config.estimator.reader;
  task.wheels = config.estimator.wheels;
  task.height_sigma_m = config.estimator.height_sigma_m;
  for (const KinematicTag& tag : experiment.tags) {
    task.tags_m.emplace_back(tag.at_m.x(), tag.at_m.y(), tag.height_m);
  }
  task.route = experiment.order;
  task.X_WR_start = experiment.X_WR_start;
  task.speed_mps = config.follower.speed_mps;
  task.rate_hz = radio.rate_hz;
  task.slot_s = radio.simultaneous ? 0.0 : radio.slot_s;
  task.tags_ahead = config.tags_ahead;
  task.tags_behind = config.tags_behind;
  return task;
}

bool MissionRun::said(CeilingEventKind kind) const {
  return std::any_of(events.begin(), events.end(), [kind](const CeilingEvent& e) { return e.kind == kind; });
}

MissionRun run_mission(const PhaseExperiment& experiment, const CeilingMissionConfig& config,
                       const KinematicRadio& radio, const KinematicErrors& errors, std::uint64_t seed,
                       double limit_s, const MissionHook& hook, const PathError& error) {
  KinematicRobot robot{experiment.tags, experiment.X_WR_start, errors, radio, seed};
  CeilingMission mission{config};
  PathScore score{experiment};
  MissionRun run;
  double squares = 0.0;
  int samples = 0;
  PhaseCommand command;
  while (!mission.done() && to_s(robot.now()) < limit_s) {
    if (hook) {
      hook(robot, mission);
    }
    command = mission.step(robot.step(command));
    const Vec2& p = robot.X_WR().p_m;
    if (mission.leg() > 0) {
      if (experiment.order.size() > 1) {
        run.off_path_cm = std::max(run.off_path_cm, 100.0 * off_path_m(experiment, p));
      }
      if (error) {
        const double e = error(mission, p);
        squares += e * e;
        ++samples;
        run.worst_cm = std::max(run.worst_cm, 100.0 * std::abs(e));
      } else {
        score.sample(mission.leg(), p);
      }
    }
    for (const CeilingEvent& event : mission.events()) {
      run.events.push_back(event);
      run.found += event.kind == CeilingEventKind::kTagFound ? 1 : 0;
    }
    mission.forget_events();
  }
  run.arrived = mission.arrived();
  run.skipped = mission.skipped();
  run.drops = mission.estimator().drops();
  run.time_s = to_s(robot.now());
  run.driven_m = robot.driven_m();
  if (error) {
    run.rmse_cm = samples > 0 ? 100.0 * std::sqrt(squares / samples) : 0.0;
  } else {
    run.rmse_cm = 100.0 * score.rmse_m();
    run.worst_cm = 100.0 * std::max(-score.error_min_m(), score.error_max_m());
  }
  run.end_error_cm = 100.0 * (experiment.tags[experiment.order.back()].at_m - robot.X_WR().p_m).norm();
  return run;
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

}  // namespace sensotwin::robot::testing
