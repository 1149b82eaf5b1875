// SPDX-License-Identifier: MIT
#include "render/phase_views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "render/chart_style.hpp"

namespace sensotwin::render {
namespace {

[[nodiscard]] RenderError bad(const std::string& message) {
  return {RenderError::Kind::kBadView, message};
}

/// Keeps the first fault it is shown.
class FirstFault {
 public:
  void number(double value, std::string_view what, std::size_t index) {
    if (!fault_) {
      fault_ = value_fault(value, false, fmt::format("{} {}", what, index));
    }
  }
  void point(const Vec2& p, std::string_view what, std::size_t index) {
    number(p.x(), what, index);
    number(p.y(), what, index);
  }
  void point(const ChartPoint& p, std::string_view what, std::size_t index) {
    number(p.x, what, index);
    number(p.y, what, index);
  }
  void not_negative(double value, std::string_view what, std::size_t index) {
    number(value, what, index);
    if (!fault_ && value < 0.0) {
      fault_ = bad(fmt::format("cannot draw {} {}: {} is negative", what, index, value));
    }
  }
  [[nodiscard]] const std::optional<RenderError>& fault() const { return fault_; }

 private:
  std::optional<RenderError> fault_;
};

void check_estimates(const PhaseRunView& view, FirstFault& find) {
  for (std::size_t i = 0; i < view.estimates.size(); ++i) {
    const TagEstimateView& estimate = view.estimates[i];
    find.point(estimate.at_m, "estimate", i);
    find.number(estimate.t_s, "estimate", i);
    for (const double entry : estimate.covariance_m2.reshaped()) {
      find.number(entry, "covariance of estimate", i);
    }
  }
}

}  // namespace

std::optional<RenderError> first_fault(const PhaseRunView& view) {
  // Walls, furniture, tags and path lie under the limits of every scene picture.
  SceneView scene;
  scene.walls = view.walls;
  scene.furniture = view.furniture;
  scene.trajectory = view.driven;
  scene.cliffs_m.push_back(view.ideal_m);
  scene.start = view.start;
  scene.robot = RobotView{view.end.value_or(Pose2{}), view.robot_radius_m};
  for (const PhaseTagView& tag : view.tags) {
    scene.tags.push_back({tag.at_m, tag.missing});
  }
  if (auto fault = first_fault(scene)) {
    return fault;
  }
  FirstFault find;
  for (std::size_t i = 0; i < view.segments.size(); ++i) {
    find.number(view.segments[i].from_s, "segment", i);
  }
  for (std::size_t i = 0; i < view.errors.size(); ++i) {
    find.number(view.errors[i].t_s, "error", i);
    find.number(view.errors[i].error_m, "error", i);
  }
  for (std::size_t i = 0; i < view.people.size(); ++i) {
    for (const Vec2& p : view.people[i].path_m) {
      find.point(p, "person", i);
    }
    find.not_negative(view.people[i].radius_m, "radius of person", i);
  }
  check_estimates(view, find);
  for (const auto& figure : {view.rmse_m, view.bound_m, view.paper_rmse_m}) {
    find.not_negative(figure.value_or(0.0), "root mean square", 0);
  }
  return find.fault();
}

std::optional<RenderError> first_fault(const NoiseView& view) {
  FirstFault find;
  for (std::size_t i = 0; i < view.reads.size(); ++i) {
    find.point(view.reads[i], "read", i);
  }
  for (const NoiseSet& set : view.measured) {
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const NoisePoint& point = set.points[i];
      find.number(point.x, "deviation", i);
      find.not_negative(point.sigma_rad, "deviation", i);
      if (point.interval_rad) {
        find.number(point.interval_rad->low, "interval", i);
        find.number(point.interval_rad->high, "interval", i);
      }
    }
  }
  for (const NoiseLawView& law : view.laws) {
    for (std::size_t i = 0; i < law.curve.size(); ++i) {
      find.point(law.curve[i], "law point", i);
    }
  }
  return find.fault();
}

std::optional<RenderError> first_fault(const FuzzyControllerView& view) {
  FirstFault find;
  for (const auto* sets : {&view.inputs, &view.outputs}) {
    for (std::size_t i = 0; i < sets->size(); ++i) {
      for (const ChartPoint& corner : (*sets)[i].corners) {
        find.point(corner, "fuzzy set", i);
      }
    }
  }
  for (std::size_t i = 0; i < view.curves.size(); ++i) {
    for (const ChartPoint& point : view.curves[i].points) {
      find.point(point, "control curve", i);
    }
  }
  return find.fault();
}

Extent extent_of(const PhaseRunView& view) {
  SceneView scene;
  scene.walls = view.walls;
  scene.furniture = view.furniture;
  scene.trajectory = view.driven;
  scene.cliffs_m.push_back(view.ideal_m);
  for (const PersonView& person : view.people) {
    scene.cliffs_m.push_back(person.path_m);
  }
  for (const PhaseTagView& tag : view.tags) {
    scene.ceiling_tags.push_back({tag.at_m, 0.0, ""});
  }
  if (view.start) {
    scene.trajectory.push_back({view.start->p_m, 0.0});
  }
  return extent_of(scene);
}

ChartRange counted_span_s(const PhaseRunView& view) {
  const double last_s =
      view.driven.empty() ? (view.errors.empty() ? 0.0 : view.errors.back().t_s) : view.driven.back().t_s;
  const double first_s =
      view.driven.empty() ? (view.errors.empty() ? 0.0 : view.errors.front().t_s) : view.driven.front().t_s;
  if (view.segments.empty()) {
    return {first_s, last_s};
  }
  const auto counts = [](const SegmentView& segment) { return segment.counted; };
  const auto from = std::find_if(view.segments.begin(), view.segments.end(), counts);
  if (from == view.segments.end()) {
    return {last_s, last_s};
  }
  const auto after = std::find_if_not(from, view.segments.end(), counts);
  return {from->from_s, after == view.segments.end() ? std::max(last_s, from->from_s) : after->from_s};
}

}  // namespace sensotwin::render
