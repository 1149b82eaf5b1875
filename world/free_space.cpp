// SPDX-License-Identifier: MIT
#include "world/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "world/obstacles.hpp"

namespace sensotwin::world {
namespace {

using TileAt = std::pair<int, int>;

std::optional<TileAt> tile_under(const Carpet& carpet, const Vec2& at_m) {
  const Vec2 tile = (at_m - carpet.origin_m) / carpet.tile_m;
  const TileAt found{static_cast<int>(std::floor(tile.x())), static_cast<int>(std::floor(tile.y()))};
  const bool exists = std::find(carpet.tiles.begin(), carpet.tiles.end(), found) != carpet.tiles.end();
  return exists ? std::optional{found} : std::nullopt;
}

Vec2 middle_of(const Carpet& carpet, const TileAt& tile) {
  return carpet.origin_m + carpet.tile_m * Vec2{tile.first + 0.5, tile.second + 0.5};
}

/// Positions of the disc's middle on a fine grid: blocked, free, or free and connected to the start.
class PositionGrid {
 public:
  PositionGrid(const Vec2& low_m, const Vec2& high_m, double cell_m)
      : low_m_(low_m),
        cell_m_(cell_m),
        columns_(1 + static_cast<int>(std::ceil((high_m.x() - low_m.x()) / cell_m))),
        rows_(1 + static_cast<int>(std::ceil((high_m.y() - low_m.y()) / cell_m))),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kFree) {}

  /// Blocks every position whose exact distance to the thing is below `reach_m`.
  void block(const Segment& s, double reach_m) {
    for_cells(s.a_m.cwiseMin(s.b_m), s.a_m.cwiseMax(s.b_m), reach_m,
              [&](std::uint8_t& cell, const Vec2& at_m) {
                if (distance_m(at_m, s) < reach_m) {
                  cell = kBlocked;
                }
              });
  }
  void block(const Disc& d, double reach_m) {
    const double sum_m = reach_m + d.radius_m;
    for_cells(d.middle_m, d.middle_m, sum_m, [&](std::uint8_t& cell, const Vec2& at_m) {
      if ((at_m - d.middle_m).squaredNorm() < sum_m * sum_m) {
        cell = kBlocked;
      }
    });
  }
  void block(const Cliff& cliff) {
    for (std::size_t i = 2; i < cliff.corners_m.size(); ++i) {
      block_triangle({cliff.corners_m[0], cliff.corners_m[i - 1], cliff.corners_m[i]});
    }
  }
  /// Marks what is connected to the free position nearest to `start_m`, steps going to the four neighbours.
  void flood(const Vec2& start_m) {
    std::vector<std::size_t> open;
    const auto visit = [&](std::size_t i) {
      if (cells_[i] == kFree) {
        cells_[i] = kReached;
        open.push_back(i);
      }
    };
    // The start itself may be nearer to a wall than the margin: begin with the free positions around it.
    for_cells(start_m, start_m, 2.0 * cell_m_ + 0.02, [&](std::uint8_t& cell, const Vec2&) {
      visit(static_cast<std::size_t>(&cell - cells_.data()));
    });
    const auto width = static_cast<std::size_t>(columns_);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      const std::size_t column = i % width;
      if (column > 0) visit(i - 1);
      if (column + 1 < width) visit(i + 1);
      if (i >= width) visit(i - width);
      if (i + width < cells_.size()) visit(i + width);
    }
  }
  /// Whether some reached position is between `near_m` and `far_m` from a point.
  [[nodiscard]] bool reached_within(const Vec2& point_m, double near_m, double far_m) {
    bool found = false;
    for_cells(point_m, point_m, far_m, [&](std::uint8_t& cell, const Vec2& at_m) {
      const double d_m = (at_m - point_m).norm();
      found = found || (cell == kReached && d_m >= near_m && d_m <= far_m);
    });
    return found;
  }

 private:
  static constexpr std::uint8_t kFree = 0;
  static constexpr std::uint8_t kBlocked = 1;
  static constexpr std::uint8_t kReached = 2;

  template <class Visit>
  void for_cells(const Vec2& low_m, const Vec2& high_m, double reach_m, Visit&& visit) {
    const auto first = [&](double x_m, double low) {
      return std::max(0, static_cast<int>(std::ceil((x_m - reach_m - low) / cell_m_)));
    };
    const auto last = [&](double x_m, double low, int count) {
      return std::min(count - 1, static_cast<int>(std::floor((x_m + reach_m - low) / cell_m_)));
    };
    for (int row = first(low_m.y(), low_m_.y()); row <= last(high_m.y(), low_m_.y(), rows_); ++row) {
      for (int column = first(low_m.x(), low_m_.x()); column <= last(high_m.x(), low_m_.x(), columns_);
           ++column) {
        visit(cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column)],
              Vec2{low_m_.x() + column * cell_m_, low_m_.y() + row * cell_m_});
      }
    }
  }
  void block_triangle(const std::array<Vec2, 3>& t) {
    const Vec2 low_m = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    const Vec2 high_m = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    for_cells(low_m, high_m, 0.0, [&](std::uint8_t& cell, const Vec2& at_m) {
      const auto side = [&](int i) {
        const Vec2 edge = t[static_cast<std::size_t>((i + 1) % 3)] - t[static_cast<std::size_t>(i)];
        const Vec2 to = at_m - t[static_cast<std::size_t>(i)];
        return edge.x() * to.y() - edge.y() * to.x();
      };
      const bool all_left = side(0) >= 0.0 && side(1) >= 0.0 && side(2) >= 0.0;
      const bool all_right = side(0) <= 0.0 && side(1) <= 0.0 && side(2) <= 0.0;
      if (all_left || all_right) {
        cell = kBlocked;
      }
    });
  }

  Vec2 low_m_;
  double cell_m_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> cells_;
};

std::set<TileAt> by_free_space(const WorldDescription& world, const RobotDescription& robot,
                               const FreeSpaceSettings& settings, const ObstacleIndex& fixed,
                               const std::set<TileAt>& readable, std::span<const Vec2> tags_m) {
  const Carpet& carpet = world.carpet;
  // A tag is only reached from within a tile of it, but the way there may leave the carpet: all the house
  // counts.
  Vec2 low_m = robot.X_WR_start.p_m;
  Vec2 high_m = low_m;
  const auto take = [&](const Vec2& p_m) {
    low_m = low_m.cwiseMin(p_m);
    high_m = high_m.cwiseMax(p_m);
  };
  for (const Segment& s : fixed.outline().segments) {
    take(s.a_m);
    take(s.b_m);
  }
  for (const Vec2& tag_m : tags_m) {
    take(tag_m);
  }
  PositionGrid grid(low_m, high_m, settings.cell_m);
  const double reach_m = robot.base.radius_m + settings.margin_m;
  for (const Segment& s : fixed.outline().segments) {
    grid.block(s, reach_m);
  }
  for (const Disc& d : fixed.outline().discs) {
    grid.block(d, reach_m);
  }
  for (const Cliff& cliff : world.cliffs) {
    grid.block(cliff);
  }
  grid.flood(robot.X_WR_start.p_m);
  const double arm_m = robot.floor_reader.at_m.norm();
  const double read_m = robot.floor_reader.read_radius_m;
  std::set<TileAt> out;
  for (std::size_t i = 0; i < carpet.tiles.size(); ++i) {
    if (readable.count(carpet.tiles[i]) != 0 &&
        grid.reached_within(tags_m[i], std::max(0.0, arm_m - read_m), arm_m + read_m)) {
      out.insert(carpet.tiles[i]);
    }
  }
  return out;
}

std::set<TileAt> by_straight_moves(const WorldDescription& world, const RobotDescription& robot,
                                   const FreeSpaceSettings& settings, const ObstacleIndex& fixed,
                                   const std::set<TileAt>& readable) {
  const Carpet& carpet = world.carpet;
  const auto start = tile_under(carpet, robot.X_WR_start.p_m);
  std::set<TileAt> out;
  if (!start || readable.count(*start) == 0) {
    return out;
  }
  const double reach_m = robot.base.radius_m + settings.margin_m;
  std::vector<TileAt> open{*start};
  out.insert(*start);
  while (!open.empty()) {
    const TileAt from = open.back();
    open.pop_back();
    const auto [column, row] = from;
    for (const TileAt& to : {TileAt{column + 1, row}, TileAt{column, row + 1}, TileAt{column - 1, row},
                             TileAt{column, row - 1}}) {
      const Segment move{middle_of(carpet, from), middle_of(carpet, to)};
      if (readable.count(to) != 0 && out.count(to) == 0 && fixed.clearance_m(move, reach_m) >= reach_m) {
        out.insert(to);
        open.push_back(to);
      }
    }
  }
  return out;
}

}  // namespace

ReachableTiles reachable_tiles(const WorldDescription& world, const RobotDescription& robot,
                               const FreeSpaceSettings& settings, std::span<const Vec2> carpet_tags_m) {
  const Carpet& carpet = world.carpet;
  if (carpet.tiles.empty()) {
    return {};
  }
  const ObstacleIndex fixed(fixed_outline(world, robot.base.height_m));
  std::set<TileAt> readable(carpet.tiles.begin(), carpet.tiles.end());
  for (const TileAt& dead : carpet.unreadable) {
    readable.erase(dead);
  }
  std::vector<Vec2> tags_m(carpet_tags_m.begin(), carpet_tags_m.end());
  if (tags_m.empty()) {
    std::transform(carpet.tiles.begin(), carpet.tiles.end(), std::back_inserter(tags_m),
                   [&](const TileAt& tile) { return middle_of(carpet, tile); });
  }
  return {by_free_space(world, robot, settings, fixed, readable, tags_m),
          by_straight_moves(world, robot, settings, fixed, readable)};
}

}  // namespace sensotwin::world
