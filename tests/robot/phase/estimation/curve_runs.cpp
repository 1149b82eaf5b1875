// SPDX-License-Identifier: MIT
#include "tests/robot/phase/estimation/curve_runs.hpp"

#include <cmath>

namespace sensotwin::robot::testing {
namespace {

CurveExperiment through(const std::vector<Vec2>& tags_m, bool closed, int laps) {
  CurveExperiment curve;
  curve.tags_per_lap = tags_m.size();
  for (std::size_t i = 0; i < tags_m.size(); ++i) {
    curve.tags.tags.push_back({.epc = experiment_epc(i), .at_m = tags_m[i], .floor_tag = false});
  }
  for (int lap = 0; lap < laps; ++lap) {
    for (std::size_t i = 0; i < tags_m.size(); ++i) {
      curve.tags.order.push_back(i);
    }
  }
  if (closed) {
    curve.tags.order.push_back(0);
  }
  const SmoothLeg first{std::nullopt, tags_m[0], tags_m[1], tags_m[2]};
  curve.tags.X_WR_start = {tags_m[0], first.at(tags_m[0]).yaw_rad};
  return curve;
}

}  // namespace

CurveExperiment circle_of_tags(double radius_m, int tags, int laps) {
  std::vector<Vec2> tags_m;
  for (int i = 0; i < tags; ++i) {
    const double angle = 2.0 * kPi * i / tags;
    tags_m.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle));
  }
  return through(tags_m, true, laps);
}

CurveExperiment figure_of_eight(int laps) {
  std::vector<Vec2> tags_m;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.0 * kPi * i / 12.0 + kPi / 12.0;
    tags_m.emplace_back(3.0 * std::sin(angle), 1.8 * std::sin(2.0 * angle));
  }
  return through(tags_m, true, laps);
}

CurveExperiment s_curve() {
  return through({{0, 0}, {2, 1}, {4, 0}, {6, -1}, {8, 0}, {10, 1}}, false, 1);
}

CurveRun run_curve(const CurveExperiment& curve, std::uint64_t seed) {
  CeilingMissionConfig config = mission_for(curve.tags, {}, false);
  config.path = TagPathKind::kSmooth;
  double first_squares = 0.0;
  double later_squares = 0.0;
  int first_samples = 0;
  int later_samples = 0;
  const auto place = [&](std::ptrdiff_t i) -> std::optional<Vec2> {
    if (i < 0 || i >= static_cast<std::ptrdiff_t>(curve.tags.order.size())) {
      return std::nullopt;
    }
    return curve.tags.tags[curve.tags.order[static_cast<std::size_t>(i)]].at_m;
  };
  const PathError error = [&](const CeilingMission& mission, const Vec2& p_W_m) {
    const auto leg = static_cast<std::ptrdiff_t>(mission.leg());
    const double across_m =
        SmoothLeg(place(leg - 2), *place(leg - 1), *place(leg), place(leg + 1)).at(p_W_m).across_m;
    const bool first = mission.leg() <= curve.tags_per_lap;
    (first ? first_squares : later_squares) += across_m * across_m;
    ++(first ? first_samples : later_samples);
    return across_m;
  };
  CurveRun out;
  out.arrived = run_mission(curve.tags, config, {}, {}, seed, 900.0, {}, error).arrived;
  out.first_lap_cm = first_samples > 0 ? 100.0 * std::sqrt(first_squares / first_samples) : 0.0;
  out.later_laps_cm = later_samples > 0 ? 100.0 * std::sqrt(later_squares / later_samples) : 0.0;
  return out;
}

}  // namespace sensotwin::robot::testing
