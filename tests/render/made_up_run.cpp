// SPDX-License-Identifier: MIT
#include "made_up_run.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/base/random.hpp"

namespace sensotwin::render::testing {
namespace {

constexpr double kStep_s = 0.05;
constexpr double kSpeed_mps = 0.2;

struct Drive {
  Pose2 from;
  std::vector<Vec2> tags_m;
  double turn_rps{1.1};
  double zone_m{0.03};
  bool first_counts{true};  ///< whether the way to the first tag is part of the path
  std::uint64_t seed{7};
};

/// Left of travel positive.
[[nodiscard]] double beside(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = (b - a).normalized();
  return along.x() * (p - a).y() - along.y() * (p - a).x();
}

void add_estimates(PhaseRunView& view, const Drive& drive) {
  robot::RandomStream random = robot::RandomStream{drive.seed}.fork("estimates");
  const double end_s = view.driven.back().t_s;
  const std::size_t n = view.tags.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double seen_s = end_s * (static_cast<double>(i) / static_cast<double>(n + 2));
    const Vec2 bias{0.03 * random.normal(), 0.03 * random.normal()};
    const double lean = random.uniform(0.0, robot::kPi);
    Vec2 draw{random.normal(), random.normal()};
    for (double t = 1.0; t <= std::min(60.0, end_s - seen_s); t *= 1.35) {
      const double major = 0.012 + 0.55 / t;
      const Eigen::Rotation2Dd turn(lean + 0.02 * t);
      const Eigen::Matrix2d root = turn.toRotationMatrix() * Eigen::Vector2d(major, 0.4 * major).asDiagonal();
      // One estimate is much like the one before.
      draw = 0.9 * draw + 0.3 * Vec2{random.normal(), random.normal()};
      view.estimates.push_back({view.tags[i].name, view.tags[i].at_m + 0.3 * bias + root * (0.7 * draw),
                                root * root.transpose(), seen_s + t});
    }
  }
  std::stable_sort(view.estimates.begin(), view.estimates.end(),
                   [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
}

[[nodiscard]] PhaseRunView driven_by(const Drive& drive) {
  PhaseRunView view;
  view.seed = drive.seed;
  robot::RandomStream random = robot::RandomStream{drive.seed}.fork("drive");
  Pose2 X = drive.from;
  view.start = X;
  double t_s = 0.0;
  double bias = 0.0;
  double square = 0.0;
  Vec2 last = X.p_m;
  for (std::size_t i = 0; i < drive.tags_m.size(); ++i) {
    const Vec2& tag = drive.tags_m[i];
    const bool counted = i > 0 || drive.first_counts;
    view.segments.push_back({t_s, fmt::format("→ T{}", i + 1), counted});
    const double until_s = t_s + 200.0;
    while ((tag - X.p_m).norm() > drive.zone_m && t_s < until_s) {
      const Vec2 way = X.inverse() * tag;
      bias += 0.04 * (0.25 * random.normal() - bias);
      const double wanted = 2.0 * (std::atan2(way.y(), way.x()) + bias);
      const double turn = std::clamp(wanted, -drive.turn_rps, drive.turn_rps) * kStep_s;
      X = X * Pose2{{kSpeed_mps * kStep_s, 0.0}, turn};
      t_s += kStep_s;
      view.driven.push_back({X.p_m, t_s});
      if (counted) {
        view.errors.push_back({t_s, beside(last, tag, X.p_m)});
        square += std::pow(view.errors.back().error_m, 2);
      }
    }
    last = tag;
  }
  view.end = X;
  view.rmse_m = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, view.errors.size())));
  return view;
}

void name_tags(PhaseRunView& view, const std::vector<Vec2>& at_m) {
  for (const Vec2& p : at_m) {
    view.tags.push_back({fmt::format("T{}", view.tags.size() + 1), p, false});
  }
}

[[nodiscard]] std::vector<Vec2> hallway_corners() {
  return {{0, 0}, {8, 0}, {8, 6}, {16, 6}, {16, -2}, {24, -2}, {24, 4}};
}

[[nodiscard]] WallView hallway_walls() {
  return {{{-1, -1},
           {9, -1},
           {9, 5},
           {15, 5},
           {15, -3},
           {25, -3},
           {25, 5},
           {23, 5},
           {23, -1},
           {17, -1},
           {17, 7},
           {7, 7},
           {7, 1},
           {-1, 1}},
          true};
}

}  // namespace

PhaseRunView made_up_line() {
  const std::vector<Vec2> tags{{0, 0}, {0, 5}};
  Drive drive{{{-5, -5}, robot::kPi / 2.0}, tags};
  drive.first_counts = false;
  PhaseRunView view = driven_by(drive);
  view.title = "Following a line, start at 90°";
  view.scene = "phase_line_90";
  view.subtitle = "paper's controller · profile paper";
  view.ideal_m = tags;
  name_tags(view, tags);
  view.paper_rmse_m = 0.034;
  view.bound_m = 0.0091;
  return view;
}

PhaseRunView made_up_star() {
  std::vector<Vec2> corners;
  for (int i = 0; i <= 5; ++i) {
    const double angle = robot::rad_from_deg(90.0 + 144.0 * i);
    corners.push_back(3.0 * Vec2{std::cos(angle), std::sin(angle)});
  }
  Drive drive{{{0, 3}, -robot::kPi / 2.0}, {corners.begin() + 1, corners.end()}};
  PhaseRunView view = driven_by(drive);
  view.title = "A path with acute angles";
  view.scene = "phase_star";
  view.subtitle = "paper's controller · profile paper";
  view.ideal_m = corners;
  name_tags(view, {corners.begin(), corners.end() - 1});
  for (std::size_t i = 0; i < view.segments.size(); ++i) {
    view.segments[i].name = fmt::format("→ T{}", (i + 1) % 5 + 1);
  }
  view.coloring = PathColoring::kSegment;
  view.paper_rmse_m = 0.175;
  add_estimates(view, drive);
  return view;
}

PhaseRunView made_up_hallway() {
  const std::vector<Vec2> corners = hallway_corners();
  Drive drive{{{0, 0}, 0.0}, {corners.begin() + 1, corners.end()}};
  drive.zone_m = 0.05;
  PhaseRunView view = driven_by(drive);
  view.title = "Along a hallway of seven tags";
  view.scene = "phase_hallway";
  view.subtitle = "ours · profile impinj_r420";
  view.walls.push_back(hallway_walls());
  view.ideal_m = corners;
  name_tags(view, corners);
  for (std::size_t i = 0; i < view.segments.size(); ++i) {
    view.segments[i].name = fmt::format("→ T{}", i + 2);
  }
  view.tags[4].missing = true;
  view.paper_rmse_m = 0.13;
  view.bound_m = 0.012;
  add_estimates(view, drive);
  return view;
}

PhaseRunView made_up_circle() {
  std::vector<Vec2> tags;
  PhaseRunView view;
  robot::RandomStream random = robot::RandomStream{7}.fork("circle");
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * robot::kPi * i / 8.0;
    tags.push_back(2.0 * Vec2{std::cos(angle), std::sin(angle)});
  }
  for (int i = 0; i < 120; ++i) {
    const double angle = 2.0 * robot::kPi * i / 120.0;
    view.ideal_m.push_back(2.0 * Vec2{std::cos(angle), std::sin(angle)});
  }
  view.ideal_closed = true;
  double off = 0.0;
  double square = 0.0;
  const double lap_s = 4.0 * robot::kPi / kSpeed_mps;
  for (double t = 0.0; t <= 2.0 * lap_s; t += kStep_s) {
    off += 0.01 * ((t < lap_s ? 0.09 : 0.02) * random.normal() - 0.4 * off);
    const double angle = t * kSpeed_mps / 2.0;
    view.driven.push_back({(2.0 - off) * Vec2{std::cos(angle), std::sin(angle)}, t});
    view.errors.push_back({t, off});
    square += off * off;
  }
  view.seed = 7;
  view.title = "Two laps about a circle";
  view.scene = "phase_circle";
  view.subtitle = "ours · profile paper";
  name_tags(view, tags);
  view.start = Pose2{{2, 0}, robot::kPi / 2.0};
  view.end = Pose2{view.driven.back().p_m, robot::kPi / 2.0};
  view.segments = {{0.0, "first lap", true}, {lap_s, "second lap", true}};
  view.rmse_m = std::sqrt(square / static_cast<double>(view.errors.size()));
  add_estimates(view, {});
  return view;
}

PhaseRunView made_up_hall() {
  std::vector<Vec2> tags;
  robot::RandomStream random = robot::RandomStream{7}.fork("hall");
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 8; ++i) {
      const int column = row % 2 == 0 ? i : 7 - i;
      tags.push_back(
          {3.0 + 4.9 * column + random.uniform(-0.6, 0.6), 3.0 + 4.4 * row + random.uniform(-0.6, 0.6)});
    }
  }
  Drive drive{{{1.0, 1.0}, 0.5}, tags};
  drive.first_counts = false;
  drive.zone_m = 0.05;
  PhaseRunView view = driven_by(drive);
  view.title = "A hall of 40 tags";
  view.scene = "phase_hall";
  view.subtitle = "ours · profile impinj_r420";
  view.walls.push_back({{{0, 0}, {40, 0}, {40, 24}, {0, 24}}, true});
  view.ideal_m = tags;
  name_tags(view, tags);
  add_estimates(view, drive);
  return view;
}

NoiseView made_up_noise() {
  NoiseView view;
  view.title = "Phase noise against distance";
  view.subtitle = "phase_line_90 · seed 7 · profile paper";
  robot::RandomStream random = robot::RandomStream{7}.fork("noise");
  constexpr double kPerMetre_rad = 0.024;
  for (int i = 0; i < 3000; ++i) {
    const double d = random.uniform(2.9, 7.7);
    view.reads.push_back({d, kPerMetre_rad * d * random.normal()});
  }
  for (const int antenna : {1, 2}) {
    NoiseSet set{fmt::format("antenna {}", antenna), {}};
    for (double d = 3.1; d < 7.7; d += 0.4) {
      const double sigma = kPerMetre_rad * d * (1.0 + 0.05 * random.normal());
      set.points.push_back({d, sigma, ChartRange{0.9 * sigma, 1.12 * sigma}});
    }
    view.measured.push_back(std::move(set));
  }
  view.laws.push_back({"0.024 rad/m", {{0.0, 0.0}, {8.0, 8.0 * kPerMetre_rad}}});
  NoiseLawView offset{"0.012 rad, 0.0224 rad/m", {}};
  for (double d = 0.0; d <= 8.0; d += 0.1) {
    offset.curve.push_back({d, std::hypot(0.012, 0.0224 * d)});
  }
  view.laws.push_back(std::move(offset));
  return view;
}

FuzzyControllerView made_up_controller() {
  FuzzyControllerView view;
  view.title = "The fuzzy controller";
  view.subtitle = "preset paper · half width of Zero 1.0 rad · full turn 1.1 rad/s · 20 Hz";
  view.inputs = {{"Neg", {{-robot::kPi, 1}, {-1, 1}, {0, 0}}, 0},
                 {"Zero", {{-1, 0}, {0, 1}, {1, 0}}, 1},
                 {"Pos", {{0, 0}, {1, 1}, {robot::kPi, 1}}, 2}};
  view.outputs = {{"CW", {{-2.2, 0}, {-1.1, 1}, {0, 0}}, 2},
                  {"Zero", {{-1.1, 0}, {0, 1}, {1.1, 0}}, 1},
                  {"CCW", {{0, 0}, {1.1, 1}, {2.2, 0}}, 0}};
  for (const auto& [name, width, most] : {std::tuple{"paper", 1.0, 1.1}, std::tuple{"tuned", 1.0, 2.5}}) {
    ControlCurveView curve{name, {}};
    for (int i = -314; i <= 314; ++i) {
      const double x = i * 0.01;
      const double share = std::clamp(x / width, -1.0, 1.0);
      // The centre of area of the clipped triangles bends a little against the straight line.
      curve.points.push_back({x, -most * (share - 0.12 * std::sin(2.0 * robot::kPi * share))});
    }
    view.curves.push_back(std::move(curve));
  }
  return view;
}

SceneView made_up_ceiling(const PhaseRunView& run, double until_s, std::size_t target) {
  SceneView view;
  view.title = "Under the tags: " + run.title;
  view.subtitle = run.subtitle;
  view.scene = run.scene;
  view.seed = run.seed;
  view.walls = run.walls;
  view.ideal_path_m = run.ideal_m;
  view.start = run.start;
  for (const TimedPoint& point : run.driven) {
    if (point.t_s <= until_s) {
      view.trajectory.push_back(point);
    }
  }
  view.time_end_s = run.driven.back().t_s;
  const Vec2 along = view.trajectory.back().p_m - view.trajectory[view.trajectory.size() - 2].p_m;
  view.robot = RobotView{{view.trajectory.back().p_m, std::atan2(along.y(), along.x())}, 0.17, 0.092, {}};
  view.robot->antennas = {{{0.0, 0.08}, 0.1}, {{0.0, -0.08}, 0.1}};
  for (const PhaseTagView& tag : run.tags) {
    view.ceiling_tags.push_back({tag.at_m, 3.0, tag.name});
    view.estimates.push_back({tag.at_m, {0.5, 0.25, 0.6}});
  }
  view.target_tag = target;
  return view;
}

SceneView made_up_ceiling() {
  return made_up_ceiling(made_up_hallway(), 96.0, 3);
}

}  // namespace sensotwin::render::testing
