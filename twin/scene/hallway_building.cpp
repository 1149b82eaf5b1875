// SPDX-License-Identifier: MIT
#include "twin/scene/hallway_building.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sensotwin::twin {
namespace {

using robot::CompassPoint;
using robot::Vec2;

/// Of a cell. Chosen: map_server's usual resolution; widths and places are rounded to it.
constexpr double kCell_m = 0.05;
/// Around the building, so that its border is closed.
constexpr double kMargin_m = 0.5;

struct Line {
  Vec2 a_m;
  Vec2 b_m;
};

/// Of each hallway, the line from middle to middle; both ends give it.
std::vector<Line> lines_of(const robot::HallwayFile& hallways) {
  std::vector<Line> lines;
  for (const robot::HallwayNode& node : hallways.map.nodes()) {
    for (const robot::Side& side : node.sides) {
      if (side.hallway == robot::Hallway::kLeadsTo) {
        lines.push_back({*node.at_m, *hallways.map.node(side.to).at_m});
      }
    }
  }
  return lines;
}

/// Whether it runs along the grid, to a cell.
bool is_square(const Line& line) {
  return (line.b_m - line.a_m).cwiseAbs().minCoeff() < kCell_m;
}

double distance_from(const Line& line, const Vec2& p_m) {
  const Vec2 way = line.b_m - line.a_m;
  const double along = std::clamp((p_m - line.a_m).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (p_m - line.a_m - along * way).norm();
}

/// What surrounds it, so far off.
FloorPiece around(const Line& line, double away_m) {
  const Vec2 margin{away_m, away_m};
  return {line.a_m.cwiseMin(line.b_m) - margin, line.a_m.cwiseMax(line.b_m) + margin};
}

void clear(OccupancyMap& map, const FloorPiece& piece) {
  const Vec2 from = (piece.low_m - map.X_WO.p_m) / kCell_m;
  const Vec2 to = (piece.high_m - map.X_WO.p_m) / kCell_m;
  for (int row = static_cast<int>(std::lround(from.y())); row < static_cast<int>(std::lround(to.y()));
       ++row) {
    const auto line = map.cells.begin() + static_cast<std::ptrdiff_t>(row) * map.columns;
    std::fill(line + std::lround(from.x()), line + std::lround(to.x()), Cell::kFree);
  }
}

/// A slanted hallway: what lies within half its width, round at the ends, so that no corner juts into the
/// hallways that it meets.
void clear_aslant(OccupancyMap& map, const Line& line, double half_m) {
  const FloorPiece piece = around(line, half_m);
  const Vec2 from = (piece.low_m - map.X_WO.p_m) / kCell_m;
  const Vec2 to = (piece.high_m - map.X_WO.p_m) / kCell_m;
  for (int row = static_cast<int>(std::floor(from.y())); row < static_cast<int>(std::ceil(to.y())); ++row) {
    for (int column = static_cast<int>(std::floor(from.x())); column < static_cast<int>(std::ceil(to.x()));
         ++column) {
      if (distance_from(line, map.X_WO.p_m + kCell_m * Vec2{column + 0.5, row + 0.5}) <= half_m) {
        map.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                  static_cast<std::size_t>(column)] = Cell::kFree;
      }
    }
  }
}

/// Room for all of these, and nothing free yet.
OccupancyMap solid_around(const std::vector<FloorPiece>& pieces) {
  Vec2 low_m{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Vec2 high_m = -low_m;
  for (const FloorPiece& piece : pieces) {
    low_m = low_m.cwiseMin(piece.low_m);
    high_m = high_m.cwiseMax(piece.high_m);
  }
  OccupancyMap map;
  map.resolution_m = kCell_m;
  map.X_WO = {low_m - Vec2{kMargin_m, kMargin_m}, 0.0};
  const Vec2 size_m = high_m - low_m + 2.0 * Vec2{kMargin_m, kMargin_m};
  map.columns = static_cast<int>(std::ceil(size_m.x() / kCell_m));
  map.rows = static_cast<int>(std::ceil(size_m.y() / kCell_m));
  map.cells.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows),
                   Cell::kOccupied);
  return map;
}

}  // namespace

OccupancyMap floor_of(const robot::HallwayFile& hallways, const std::vector<FloorPiece>& rooms) {
  const double half_m = 0.5 * hallways.width_m;
  const std::vector<Line> lines = lines_of(hallways);
  std::vector<FloorPiece> pieces = rooms;
  for (const Line& line : lines) {
    pieces.push_back(around(line, half_m));
  }
  OccupancyMap map = solid_around(pieces);
  for (const Line& line : lines) {
    if (is_square(line)) {
      clear(map, around(line, half_m));
    } else {
      clear_aslant(map, line, half_m);
    }
  }
  for (const FloorPiece& room : rooms) {
    clear(map, room);
  }
  return map;
}

std::vector<world::HallwayTag> tags_of(const robot::HallwayFile& hallways) {
  std::vector<world::HallwayTag> tags;
  for (const robot::HallwayNode& node : hallways.map.nodes()) {
    for (const CompassPoint point : robot::kCompassPoints) {
      for (const robot::TagNumber tag : node.side(point).tags) {
        const double yaw_rad = node.bearing_rad(point) + 0.5 * robot::kPi;
        const double away_m = node.side(point).tag_m.value_or(hallways.tag_to_middle_m);
        tags.push_back({tag, *node.at_m + away_m * Vec2{std::cos(yaw_rad), std::sin(yaw_rad)}});
      }
    }
  }
  return tags;
}

}  // namespace sensotwin::twin
