// SPDX-License-Identifier: MIT
#include "world/obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::world {
namespace {

/// Chosen: near the width of what the robot senses around it, so that a look-up opens four to nine buckets.
constexpr double kBucket_m = 0.5;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

void add_chain(const std::vector<Vec2>& points_m, bool closed, std::vector<Segment>& out) {
  for (std::size_t i = 0; i + 1 < points_m.size(); ++i) {
    out.push_back({points_m[i], points_m[i + 1]});
  }
  if (closed && points_m.size() > 2) {
    out.push_back({points_m.back(), points_m.front()});
  }
}

struct Box {
  Vec2 low_m;
  Vec2 high_m;
};
Box box_of(const Segment& s) {
  return {s.a_m.cwiseMin(s.b_m), s.a_m.cwiseMax(s.b_m)};
}
Box box_of(const Disc& d) {
  const Vec2 reach_m{d.radius_m, d.radius_m};
  return {d.middle_m - reach_m, d.middle_m + reach_m};
}

}  // namespace

double distance_m(const Vec2& point_m, const Segment& segment) {
  const Vec2 along_m = segment.b_m - segment.a_m;
  const double length2 = along_m.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point_m - segment.a_m).dot(along_m) / length2, 0.0, 1.0) : 0.0;
  return (point_m - segment.a_m - t * along_m).norm();
}

double distance_m(const Segment& one, const Segment& other) {
  const Vec2 u = one.b_m - one.a_m;
  const Vec2 v = other.b_m - other.a_m;
  const double a0 = cross(u, other.a_m - one.a_m);
  const double a1 = cross(u, other.b_m - one.a_m);
  const double b0 = cross(v, one.a_m - other.a_m);
  const double b1 = cross(v, one.b_m - other.a_m);
  if (a0 * a1 < 0.0 && b0 * b1 < 0.0) {
    return 0.0;
  }
  return std::min({distance_m(one.a_m, other), distance_m(one.b_m, other), distance_m(other.a_m, one),
                   distance_m(other.b_m, one)});
}

double ray_m(const Vec2& origin_m, const Vec2& direction, const Segment& segment, double limit_m) {
  const Vec2 along_m = segment.b_m - segment.a_m;
  const double sine = cross(direction, along_m);
  if (sine == 0.0) {
    return limit_m;
  }
  const Vec2 to_a_m = segment.a_m - origin_m;
  const double range_m = cross(to_a_m, along_m) / sine;
  const double t = cross(to_a_m, direction) / sine;
  return range_m >= 0.0 && range_m < limit_m && t >= 0.0 && t <= 1.0 ? range_m : limit_m;
}

double ray_m(const Vec2& origin_m, const Vec2& direction, const Disc& disc, double limit_m) {
  const Vec2 to_middle_m = disc.middle_m - origin_m;
  const double outside_m2 = to_middle_m.squaredNorm() - disc.radius_m * disc.radius_m;
  if (outside_m2 <= 0.0) {
    return 0.0;
  }
  const double along_m = to_middle_m.dot(direction);
  const double root_m2 = along_m * along_m - outside_m2;
  if (along_m < 0.0 || root_m2 < 0.0) {
    return limit_m;
  }
  return std::min(limit_m, along_m - std::sqrt(root_m2));
}

bool stands_in_the_way(const Furniture& piece, double robot_height_m) {
  return piece.shape == FurnitureShape::kLegs || piece.clearance_m <= robot_height_m;
}

Outline outline_F(const Furniture& piece) {
  Outline out;
  const Vec2 half_m = 0.5 * piece.size_m;
  switch (piece.shape) {
    case FurnitureShape::kCircle:
      out.discs.push_back({{0.0, 0.0}, piece.radius_m});
      break;
    case FurnitureShape::kBox:
      add_chain({{-half_m.x(), -half_m.y()},
                 {half_m.x(), -half_m.y()},
                 {half_m.x(), half_m.y()},
                 {-half_m.x(), half_m.y()}},
                true, out.segments);
      break;
    case FurnitureShape::kPolygon:
      add_chain(piece.points_m, true, out.segments);
      break;
    case FurnitureShape::kLegs:
      for (const Vec2& leg_m : piece.points_m) {
        out.discs.push_back({leg_m, piece.leg_radius_m});
      }
      break;
  }
  return out;
}

Outline moved(const Outline& outline_F, const Pose2& X_WF) {
  Outline out = outline_F;
  for (Segment& s : out.segments) {
    s = {X_WF * s.a_m, X_WF * s.b_m};
  }
  for (Disc& d : out.discs) {
    d.middle_m = X_WF * d.middle_m;
  }
  return out;
}

Outline fixed_outline(const WorldDescription& world, double robot_height_m) {
  Outline out;
  for (const Wall& wall : world.walls) {
    add_chain(wall.points_m, wall.closed, out.segments);
  }
  for (const Furniture& piece : world.furniture) {
    if (!piece.pushable && stands_in_the_way(piece, robot_height_m)) {
      const Outline part = moved(outline_F(piece), piece.X_WF);
      out.segments.insert(out.segments.end(), part.segments.begin(), part.segments.end());
      out.discs.insert(out.discs.end(), part.discs.begin(), part.discs.end());
    }
  }
  return out;
}

ObstacleIndex::ObstacleIndex(Outline outline) : outline_(std::move(outline)) {
  std::vector<Box> boxes;
  std::transform(outline_.segments.begin(), outline_.segments.end(), std::back_inserter(boxes),
                 [](const Segment& s) { return box_of(s); });
  std::transform(outline_.discs.begin(), outline_.discs.end(), std::back_inserter(boxes),
                 [](const Disc& d) { return box_of(d); });
  Vec2 high_m{0.0, 0.0};
  if (!boxes.empty()) {
    low_m_ = boxes.front().low_m;
    high_m = boxes.front().high_m;
  }
  for (const Box& box : boxes) {
    low_m_ = low_m_.cwiseMin(box.low_m);
    high_m = high_m.cwiseMax(box.high_m);
  }
  columns_ = 1 + static_cast<int>((high_m.x() - low_m_.x()) / kBucket_m);
  rows_ = 1 + static_cast<int>((high_m.y() - low_m_.y()) / kBucket_m);
  // Two passes, count then fill: one array without a list for each bucket.
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto for_each_bucket = [this](const Box& box, auto&& visit) {
    const auto [c0, r0] = cell(box.low_m);
    const auto [c1, r1] = cell(box.high_m);
    for (int r = r0; r <= r1; ++r) {
      for (int c = c0; c <= c1; ++c) {
        visit(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c));
      }
    }
  };
  for (const Box& box : boxes) {
    for_each_bucket(box, [this](std::size_t bucket) { ++first_[bucket + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) {
    first_[i] += first_[i - 1];
  }
  ids_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    for_each_bucket(boxes[id], [&](std::size_t bucket) { ids_[next[bucket]++] = id; });
  }
}

std::array<int, 2> ObstacleIndex::cell(const Vec2& at_m) const {
  const auto clamped = [](double cells, int count) {
    return static_cast<int>(std::clamp(std::floor(cells), 0.0, static_cast<double>(count - 1)));
  };
  return {clamped((at_m.x() - low_m_.x()) / kBucket_m, columns_),
          clamped((at_m.y() - low_m_.y()) / kBucket_m, rows_)};
}

double ObstacleIndex::clearance_m(const Vec2& at_m, double limit_m) const {
  double nearest_m = limit_m;
  const Vec2 reach_m{limit_m, limit_m};
  near(
      at_m - reach_m, at_m + reach_m,
      [&](const Segment& s) { nearest_m = std::min(nearest_m, distance_m(at_m, s)); },
      [&](const Disc& d) {
        nearest_m = std::min(nearest_m, std::max(0.0, (at_m - d.middle_m).norm() - d.radius_m));
      });
  return nearest_m;
}

double ObstacleIndex::clearance_m(const Segment& path, double limit_m) const {
  double nearest_m = limit_m;
  const Vec2 reach_m{limit_m, limit_m};
  const Box box = box_of(path);
  near(
      box.low_m - reach_m, box.high_m + reach_m,
      [&](const Segment& s) { nearest_m = std::min(nearest_m, distance_m(path, s)); },
      [&](const Disc& d) {
        nearest_m = std::min(nearest_m, std::max(0.0, distance_m(d.middle_m, path) - d.radius_m));
      });
  return nearest_m;
}

bool ObstacleIndex::in_sight(const Vec2& from_m, const Vec2& to_m) const {
  const double range_m = (to_m - from_m).norm();
  if (range_m == 0.0) {
    return true;
  }
  const Vec2 direction = (to_m - from_m) / range_m;
  double reached_m = range_m;
  near(
      from_m.cwiseMin(to_m), from_m.cwiseMax(to_m),
      [&](const Segment& s) { reached_m = std::min(reached_m, ray_m(from_m, direction, s, range_m)); },
      [&](const Disc& d) { reached_m = std::min(reached_m, ray_m(from_m, direction, d, range_m)); });
  return reached_m >= range_m;
}

}  // namespace sensotwin::world
