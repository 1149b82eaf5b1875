// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "twin/scene/map_import.hpp"

namespace sensotwin::twin {
namespace {

/// Directions along cell sides, counter-clockwise from +x of the picture.
enum Way : std::uint8_t { kEast, kNorth, kWest, kSouth };
constexpr std::array<int, 4> kStepX{1, 0, -1, 0};
constexpr std::array<int, 4> kStepY{0, 1, 0, -1};

/// The border of free space as sides between grid corners, each directed so that free space is on its left.
/// Every corner has as many sides in as out, so a walk that takes unused sides closes.
class Border {
 public:
  explicit Border(const OccupancyMap& map)
      : map_(map),
        stride_(static_cast<std::size_t>(map.columns) + 1),
        walked_(stride_ * (static_cast<std::size_t>(map.rows) + 1), 0) {}

  /// All closed walks, from the lowest row up.
  [[nodiscard]] std::vector<world::Wall> walks() {
    std::vector<world::Wall> walls;
    for (int y = 0; y <= map_.rows; ++y) {
      for (int x = 0; x <= map_.columns; ++x) {
        // The lowest corner of a walk around free space leaves east, around an obstacle north.
        for (const Way way : {kEast, kNorth}) {
          if (is_side(x, y, way) && !used(x, y, way)) {
            walls.push_back(walk(x, y, way));
          }
        }
      }
    }
    return walls;
  }

 private:
  [[nodiscard]] bool free(int column, int row) const { return map_.at(column, row) == Cell::kFree; }
  /// Is there a side that leaves corner (x, y) this way, free on its left and not free on its right?
  [[nodiscard]] bool is_side(int x, int y, Way way) const {
    switch (way) {
      case kEast:
        return free(x, y) && !free(x, y - 1);
      case kNorth:
        return free(x - 1, y) && !free(x, y);
      case kWest:
        return free(x - 1, y - 1) && !free(x - 1, y);
      case kSouth:
        break;
    }
    return free(x, y - 1) && !free(x - 1, y - 1);
  }
  std::uint8_t& marks(int x, int y) {
    return walked_[static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x)];
  }
  [[nodiscard]] bool used(int x, int y, Way way) { return (marks(x, y) >> way & 1) != 0; }

  world::Wall walk(int x, int y, Way way) {
    world::Wall wall;
    const int first_x = x;
    const int first_y = y;
    Way last = way;
    bool at_start = true;
    while (at_start || x != first_x || y != first_y || !used(x, y, way)) {
      marks(x, y) = static_cast<std::uint8_t>(marks(x, y) | 1u << way);
      if (at_start || way != last) {
        wall.points_m.push_back(map_.X_WO * (robot::Vec2{x, y} * map_.resolution_m));
      }
      at_start = false;
      last = way;
      x += kStepX[way];
      y += kStepY[way];
      way = onwards(x, y, way);
    }
    // The first corner may lie within a straight run that was entered in the middle.
    if (last == way) {
      wall.points_m.erase(wall.points_m.begin());
    }
    return wall;
  }
  /// Left where it can: where two free cells touch at a corner only, the walk stays with its own, since
  /// nothing passes between them.
  [[nodiscard]] Way onwards(int x, int y, Way way) const {
    for (const int turn : {1, 0, 3}) {
      const auto next = static_cast<Way>((way + turn) & 3);
      if (is_side(x, y, next)) {
        return next;
      }
    }
    return way;
  }

  const OccupancyMap& map_;
  std::size_t stride_;
  std::vector<std::uint8_t> walked_;  ///< per corner, a bit for each way that was taken
};

}  // namespace

std::vector<world::Wall> outline(const OccupancyMap& map) {
  return Border(map).walks();
}

}  // namespace sensotwin::twin
