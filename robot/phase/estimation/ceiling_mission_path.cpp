// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/phase/estimation/ceiling_mission.hpp"

namespace sensotwin::robot {
namespace {

/// A tag is steered to when its place is known this well against its distance, or a metre.
constexpr double kSteerable = 0.5;
/// Or, at first, when its direction is: one sigma. Chosen: 2 cm astray after a length of the robot.
constexpr double kDirection_rad = 0.06;
/// Which says something of a tag this far off only.
constexpr double kFar_m = 2.0;
/// Two tags nearer than this make no leg.
constexpr double kShortest_m = 0.02;
constexpr std::size_t kMostCirclePoints = 16;

}  // namespace

std::optional<Vec2> CeilingMission::place_of(int tag) const {
  const TagEstimate estimate = estimator_.tag(tag);
  const double away_m = std::max(1.0, (estimate.p_M_m - estimator_.pose().p_m).norm());
  if (estimate.knowledge != TagKnowledge::kUnheard &&
      std::sqrt(estimate.covariance_m2.trace()) < kSteerable * away_m) {
    return estimate.p_M_m;
  }
  return std::nullopt;
}

std::optional<Vec2> CeilingMission::towards(int tag) const {
  const TagEstimate estimate = estimator_.tag(tag);
  const Vec2 way = estimate.p_M_m - estimator_.pose().p_m;
  const double away_m = way.norm();
  if (estimate.knowledge == TagKnowledge::kUnheard || away_m < kFar_m) {
    return std::nullopt;
  }
  const Vec2 across{-way.y() / away_m, way.x() / away_m};
  const double beside_m = std::sqrt(across.dot(estimate.covariance_m2 * across));
  return beside_m < kDirection_rad * away_m ? std::optional{estimate.p_M_m} : std::nullopt;
}

std::optional<Vec2> CeilingMission::place(std::ptrdiff_t route_index) const {
  if (route_index < 0 || route_index >= static_cast<std::ptrdiff_t>(route_.size())) {
    return std::nullopt;
  }
  return place_of(route_[static_cast<std::size_t>(route_index)]);
}

Vec2 CeilingMission::leg_origin(std::size_t leg) const {
  const std::optional<std::size_t> from = leg == leg_ ? from_ : std::optional{leg_};
  if (from && *from < route_.size()) {
    if (const std::optional<Vec2> p = place_of(route_[*from])) {
      return *p;
    }
  }
  return origin_M_m_;
}

std::optional<PathReference> CeilingMission::reference(std::size_t leg) const {
  if (config_.path == TagPathKind::kCircleAbout || (config_.path == TagPathKind::kCircleThrough && leg > 0)) {
    return circle_reference(leg);
  }
  const std::optional<Vec2> known = place(static_cast<std::ptrdiff_t>(leg));
  // A straight leg needs no more than the direction to begin with.
  const std::optional<Vec2> to =
      known || config_.path != TagPathKind::kPolyline ? known : towards(route_[leg]);
  if (!to) {
    return std::nullopt;
  }
  if (config_.path == TagPathKind::kSmooth && leg > 0) {
    return smooth_reference(leg);
  }
  const Vec2 from = leg_origin(leg);
  if ((*to - from).norm() < kShortest_m) {
    const Pose2 X_MR = estimator_.pose();
    return on_line(*to - X_MR.direction(), *to, X_MR.p_m);
  }
  return on_line(from, *to, estimator_.pose().p_m);
}

std::optional<PathReference> CeilingMission::smooth_reference(std::size_t leg) const {
  const auto i = static_cast<std::ptrdiff_t>(leg);
  const Vec2 to = *place(i);
  const Vec2 from = leg_origin(leg);
  if ((to - from).norm() < kShortest_m) {
    return std::nullopt;
  }
  const std::ptrdiff_t before = leg == leg_ && from_ ? static_cast<std::ptrdiff_t>(*from_) - 1 : i - 2;
  return SmoothLeg(place(before), from, to, place(i + 1)).at(estimator_.pose().p_m);
}

std::optional<Circle> CeilingMission::fitted_circle() const {
  std::array<Vec2, kMostCirclePoints> points;
  std::size_t count = 0;
  for (int id = 0; id < estimator_.tags() && count < kMostCirclePoints; ++id) {
    const TagKnowledge knowledge = estimator_.tag(id).knowledge;
    if (knowledge == TagKnowledge::kTracked || knowledge == TagKnowledge::kKept) {
      points[count++] = estimator_.tag(id).p_M_m;
    }
  }
  return circle_through({points.data(), count});
}

std::optional<PathReference> CeilingMission::circle_reference(std::size_t leg) const {
  const Pose2 X_MR = estimator_.pose();
  if (config_.path == TagPathKind::kCircleThrough) {
    const std::optional<Vec2> to = place(static_cast<std::ptrdiff_t>(leg));
    const std::optional<Circle> circle = fitted_circle();
    if (!to || !circle) {
      // Too little is known for the circle: towards the tag meanwhile.
      return to ? std::optional{on_line(leg_origin(leg), *to, X_MR.p_m)} : std::nullopt;
    }
    return on_circle(*circle, config_.circle_left, leg_origin(leg), *to, X_MR.p_m);
  }
  const std::optional<Vec2> centre = place(0);
  if (!centre) {
    return std::nullopt;
  }
  const Circle circle{*centre, config_.circle_radius_m};
  const Vec2 out = X_MR.p_m - *centre;
  if (leg == 0) {
    // To the circle's nearest point, radially.
    const double away_m = out.norm() - circle.radius_m;
    const Vec2 inward = out.norm() > kShortest_m ? Vec2{-out / out.norm()} : X_MR.direction();
    const Vec2 heading = away_m > 0.0 ? inward : Vec2{-inward};
    return PathReference{.across_m = 0.0,
                         .yaw_rad = std::atan2(heading.y(), heading.x()),
                         .curvature_per_m = 0.0,
                         .to_go_m = std::abs(away_m),
                         .part = 0.0};
  }
  PathReference path = on_circle(circle, config_.circle_left, origin_M_m_, origin_M_m_, X_MR.p_m);
  path.part = circled_rad_ / (2.0 * kPi * config_.circle_laps);
  path.to_go_m = circle.radius_m * (2.0 * kPi * config_.circle_laps - circled_rad_);
  return path;
}

double CeilingMission::corner_rad() const {
  const std::optional<Vec2> at = place(static_cast<std::ptrdiff_t>(leg_));
  const std::optional<Vec2> next = place(static_cast<std::ptrdiff_t>(leg_) + 1);
  if (!at || !next || (*next - *at).norm() < kShortest_m) {
    // Not known: as if it were sharp.
    return kPi / 2.0;
  }
  const Vec2 in = *at - leg_origin(leg_);
  const Vec2 out = *next - *at;
  return wrap_angle(std::atan2(out.y(), out.x()) - std::atan2(in.y(), in.x()));
}

void CeilingMission::attend() {
  attended_.clear();
  if (config_.path == TagPathKind::kCircleAbout) {
    attended_.push_back(route_[0]);
  }
  const auto last = static_cast<std::ptrdiff_t>(route_.size()) - 1;
  const auto here = static_cast<std::ptrdiff_t>(leg_);
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(here - 1 - config_.tags_behind, 0);
  for (std::ptrdiff_t i = first; i <= std::min(here + config_.tags_ahead, last); ++i) {
    const int id = route_[static_cast<std::size_t>(i)];
    if (std::find(attended_.begin(), attended_.end(), id) == attended_.end()) {
      attended_.push_back(id);
    }
  }
  estimator_.attend(attended_);
}

}  // namespace sensotwin::robot
