// SPDX-License-Identifier: MIT
#include "twin/scene/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace sensotwin::twin {
namespace {

using Tile = std::pair<int, int>;

Box box_around(const std::vector<Vec2>& points) {
  Box box{points.front(), points.front()};
  for (const Vec2& point : points) {
    box.low_m = box.low_m.cwiseMin(point);
    box.high_m = box.high_m.cwiseMax(point);
  }
  return box;
}

Box box_around_free_cells(const OccupancyMap& map) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Box box{{kFar, kFar}, {-kFar, -kFar}};
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      if (map.at(column, row) == Cell::kFree) {
        for (const int corner : {0, 1, 2, 3}) {
          const Vec2 p_W = map.X_WO * (Vec2{column + corner % 2, row + corner / 2} * map.resolution_m);
          box.low_m = box.low_m.cwiseMin(p_W);
          box.high_m = box.high_m.cwiseMax(p_W);
        }
      }
    }
  }
  return box.low_m.x() > box.high_m.x() ? Box{} : box;
}

/// Obstacles sorted into square buckets, so that a question looks at the few walls around it.
class Clearance {
 public:
  Clearance(const Scene& scene, double reach_m) : scene_(scene), reach_m_(reach_m) {
    for (const world::Wall& wall : scene.world.walls) {
      for (const Segment& side : sides(wall.points_m, wall.closed)) {
        insert(side);
      }
    }
  }
  /// True when nothing is nearer than the reach to any point of the way.
  [[nodiscard]] bool free(const Segment& way) const {
    const Vec2 low = way.a_m.cwiseMin(way.b_m).array() - reach_m_;
    const Vec2 high = way.a_m.cwiseMax(way.b_m).array() + reach_m_;
    for (int y = bucket(low.y()); y <= bucket(high.y()); ++y) {
      for (int x = bucket(low.x()); x <= bucket(high.x()); ++x) {
        const auto found = buckets_.find({x, y});
        if (found == buckets_.end()) {
          continue;
        }
        for (const Segment& side : found->second) {
          if (distance_m(way, side) < reach_m_) {
            return false;
          }
        }
      }
    }
    return furniture_leaves(way);
  }

 private:
  // Chosen: about two tiles; any size gives the same answer.
  static constexpr double kBucket_m = 1.0;
  static int bucket(double m) { return static_cast<int>(std::floor(m / kBucket_m)); }

  void insert(const Segment& side) {
    const Vec2 low = side.a_m.cwiseMin(side.b_m);
    const Vec2 high = side.a_m.cwiseMax(side.b_m);
    for (int y = bucket(low.y()); y <= bucket(high.y()); ++y) {
      for (int x = bucket(low.x()); x <= bucket(high.x()); ++x) {
        buckets_[{x, y}].push_back(side);
      }
    }
  }
  [[nodiscard]] bool furniture_leaves(const Segment& way) const {
    for (const world::Furniture& piece : scene_.world.furniture) {
      if (piece.clearance_m <= scene_.robot.base.height_m && distance_m(way, piece) < reach_m_) {
        return false;
      }
    }
    for (const world::Cliff& cliff : scene_.world.cliffs) {
      if (inside(way.a_m, cliff.corners_m)) {
        return false;
      }
      for (const Segment& side : sides(cliff.corners_m, true)) {
        if (distance_m(way, side) < reach_m_) {
          return false;
        }
      }
    }
    return true;
  }

  const Scene& scene_;
  double reach_m_;
  std::map<std::pair<int, int>, std::vector<Segment>> buckets_;
};

Vec2 middle_m(const world::Carpet& carpet, const Tile& tile) {
  return carpet.origin_m + carpet.tile_m * Vec2{tile.first + 0.5, tile.second + 0.5};
}

/// The tiles connected to `from` by free straight moves; they are taken out of `open`.
std::vector<Tile> take_group(const world::Carpet& carpet, const Clearance& clearance, Tile from,
                             std::set<Tile>& open) {
  std::vector<Tile> group{from};
  open.erase(from);
  for (std::size_t i = 0; i < group.size(); ++i) {
    const auto [column, row] = group[i];
    for (const Tile& next :
         {Tile{column + 1, row}, Tile{column, row + 1}, Tile{column - 1, row}, Tile{column, row - 1}}) {
      if (open.count(next) != 0 && clearance.free({middle_m(carpet, group[i]), middle_m(carpet, next)})) {
        open.erase(next);
        group.push_back(next);
      }
    }
  }
  return group;
}

}  // namespace

FloorPlan::FloorPlan(std::vector<Vec2> outer_m)
    : outer_m_(std::move(outer_m)), bounds_(box_around(outer_m_)) {}

FloorPlan::FloorPlan(OccupancyMap map) : map_(std::move(map)), bounds_(box_around_free_cells(*map_)) {}

bool FloorPlan::has_floor_at(const Vec2& p_W) const {
  return map_ ? map_->at(p_W) == Cell::kFree : inside(p_W, outer_m_);
}

std::vector<Vec2> footprint_m(const world::Furniture& piece) {
  std::vector<Vec2> corners_F = piece.points_m;
  if (piece.shape == world::FurnitureShape::kBox) {
    const Vec2 half = piece.size_m / 2.0;
    corners_F = {{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
  } else if (piece.shape == world::FurnitureShape::kCircle) {
    corners_F = {{0.0, 0.0}};
  }
  for (Vec2& corner : corners_F) {
    corner = piece.X_WF * corner;
  }
  return corners_F;
}

double distance_m(const Segment& way, const world::Furniture& piece) {
  const std::vector<Vec2> points = footprint_m(piece);
  double nearest_m = std::numeric_limits<double>::max();
  if (piece.shape == world::FurnitureShape::kCircle || piece.shape == world::FurnitureShape::kLegs) {
    const double radius_m =
        piece.shape == world::FurnitureShape::kCircle ? piece.radius_m : piece.leg_radius_m;
    for (const Vec2& point : points) {
      nearest_m = std::min(nearest_m, distance_m(point, way) - radius_m);
    }
    return std::max(0.0, nearest_m);
  }
  if (inside(way.a_m, points)) {
    return 0.0;
  }
  for (const Segment& side : sides(points, true)) {
    nearest_m = std::min(nearest_m, distance_m(way, side));
  }
  return nearest_m;
}

world::Carpet lay_carpet(const CarpetPlan& plan, const FloorPlan& floor) {
  world::Carpet carpet{.tile_m = plan.tile_m,
                       .origin_m = plan.origin_m.value_or(floor.bounds().low_m),
                       .tiles = {},
                       .unreadable = plan.unreadable,
                       .tag_offset_sigma_m = plan.tag_offset_sigma_m};
  if (!plan.laid) {
    return carpet;
  }
  const std::set<Tile> without(plan.without.begin(), plan.without.end());
  if (plan.tiles) {
    carpet.tiles = *plan.tiles;
    std::erase_if(carpet.tiles, [&](const Tile& tile) { return without.count(tile) != 0; });
    return carpet;
  }
  Box box = floor.bounds();
  if (plan.region_m) {
    const Box region = box_around({plan.region_m->first, plan.region_m->second});
    box = {box.low_m.cwiseMax(region.low_m), box.high_m.cwiseMin(region.high_m)};
  }
  const Vec2 first = (box.low_m - carpet.origin_m) / carpet.tile_m;
  const Vec2 last = (box.high_m - carpet.origin_m) / carpet.tile_m;
  for (int row = static_cast<int>(std::floor(first.y())); row <= static_cast<int>(std::floor(last.y()));
       ++row) {
    for (int column = static_cast<int>(std::floor(first.x()));
         column <= static_cast<int>(std::floor(last.x())); ++column) {
      const Vec2 middle = middle_m(carpet, {column, row});
      const bool within =
          (middle.array() >= box.low_m.array()).all() && (middle.array() <= box.high_m.array()).all();
      if (within && floor.has_floor_at(middle) && without.count({column, row}) == 0) {
        carpet.tiles.emplace_back(column, row);
      }
    }
  }
  return carpet;
}

std::optional<robot::Pose2> find_start(const Scene& scene) {
  // Chosen: room for a first turn with the bumper in front of the body and tags off their middles.
  constexpr double kSpare_m = 0.05;
  const world::Carpet& carpet = scene.world.carpet;
  const Clearance roomy(scene, scene.robot.base.radius_m + kSpare_m);
  const Clearance passable(scene, scene.robot.base.radius_m);
  std::set<Tile> open;
  for (const Tile& tile : carpet.tiles) {
    const Vec2 middle = middle_m(carpet, tile);
    if (roomy.free({middle, middle})) {
      open.insert(tile);
    }
  }
  std::vector<Tile> largest;
  while (!open.empty()) {
    std::vector<Tile> group = take_group(carpet, passable, *open.begin(), open);
    if (group.size() > largest.size()) {
      largest = std::move(group);
    }
  }
  if (largest.empty()) {
    return std::nullopt;
  }
  std::vector<Vec2> middles;
  middles.reserve(largest.size());
  for (const Tile& tile : largest) {
    middles.push_back(middle_m(carpet, tile));
  }
  const Box box = box_around(middles);
  const Vec2 centre = (box.low_m + box.high_m) / 2.0;
  const auto nearest = std::min_element(middles.begin(), middles.end(), [&](const Vec2& a, const Vec2& b) {
    return (a - centre).squaredNorm() < (b - centre).squaredNorm();
  });
  return robot::Pose2{*nearest, 0.0};
}

}  // namespace sensotwin::twin
