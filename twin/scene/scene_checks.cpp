// SPDX-License-Identifier: MIT
#include "twin/scene/scene_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "twin/scene/plane.hpp"

namespace sensotwin::twin {
namespace {

/// Tags and chargers stand at walls: this far outside still counts as at the wall. Chosen: a wall's
/// thickness.
constexpr double kAtWall_m = 0.1;

std::string in_words(const Vec2& p) {
  // + 0.0 turns -0 into 0.
  const auto rounded = [](double m) { return std::round(m * 1000.0) / 1000.0 + 0.0; };
  return fmt::format("[{}, {}]", rounded(p.x()), rounded(p.y()));
}

bool near_floor(const FloorPlan& floor, const Vec2& point) {
  if (floor.has_floor_at(point)) {
    return true;
  }
  for (int step = 0; step < 16; ++step) {
    const double yaw = step * robot::kPi / 8.0;
    if (floor.has_floor_at(point + kAtWall_m * Vec2{std::cos(yaw), std::sin(yaw)})) {
      return true;
    }
  }
  return false;
}

}  // namespace

void SceneChecks::add(const std::string& path, std::string what, std::string hint) {
  problems_.push_back({reader_.place(path), path, std::move(what), std::move(hint)});
}

bool SceneChecks::sound(const std::string& path) const {
  return std::none_of(problems_.begin(), problems_.end(), [&](const robot::Problem& problem) {
    const bool below = problem.path.compare(0, path.size(), path) == 0 &&
                       (problem.path.size() == path.size() || problem.path[path.size()] == '.' ||
                        problem.path[path.size()] == '[');
    return below;
  });
}

bool SceneChecks::apart(const std::string& path, const std::vector<Vec2>& points, bool closed) {
  // Chosen: twice what Box2D merges into one corner (b2_linearSlop, 0.005 m).
  constexpr double kApart_m = 0.01;
  for (const Segment& side : sides(points, closed)) {
    const double length_m = (side.b_m - side.a_m).norm();
    if (length_m < kApart_m) {
      add(path, fmt::format("two corners at {} are {:.3f} m apart", in_words(side.a_m), length_m),
          "expected at least 0.01 m");
      return false;
    }
  }
  return true;
}

bool SceneChecks::room() {
  if (!sound("world.room") || !scene_.layout.room) {
    return false;
  }
  bool all_apart = apart("world.room.walls_m", scene_.layout.room->walls_m, true);
  for (std::size_t i = 0; i < scene_.layout.room->partitions.size(); ++i) {
    const Partition& partition = scene_.layout.room->partitions[i];
    all_apart &=
        apart(fmt::format("world.room.partitions[{}].points_m", i), partition.points_m, partition.closed);
  }
  if (!all_apart) {
    return false;
  }
  const std::vector<Vec2>& walls = scene_.layout.room->walls_m;
  if (crosses_itself(walls)) {
    add("world.room.walls_m", "the outer wall crosses or touches itself",
        "expected the corners in order around the room, each once");
    return false;
  }
  // Chosen: the robot's own footprint is 0.09 m2.
  constexpr double kLeast_m2 = 0.1;
  const double area_m2 = std::abs(signed_area_m2(walls));
  if (area_m2 < kLeast_m2) {
    add("world.room.walls_m", fmt::format("the room has {:.3f} m2", area_m2), "expected at least 0.1 m2");
    return false;
  }
  return true;
}

bool SceneChecks::carpet_size(const FloorPlan& floor) {
  if (!sound("world.carpet")) {
    return false;
  }
  // Chosen: 25 000 m2 of 0.5 m tiles; more is a slip in a unit.
  constexpr double kTilesMax = 100000.0;
  const Vec2 size = floor.bounds().high_m - floor.bounds().low_m;
  const double tile_m = scene_.layout.carpet.tile_m;
  const double tiles = size.x() * size.y() / (tile_m * tile_m);
  if (scene_.layout.carpet.laid && !scene_.layout.carpet.tiles && tiles > kTilesMax) {
    add("world.carpet", fmt::format("{:.0f} tiles of {} m would be laid", tiles, tile_m),
        fmt::format("expected at most {:.0f}: is tile_m right?", kTilesMax));
    return false;
  }
  return true;
}

void SceneChecks::by_itself() {
  names();
  shapes();
  figures();
  radio();
  reader_faults();
  phase_mission();
}

void SceneChecks::names() {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < scene_.world.furniture.size(); ++i) {
    const std::string path = fmt::format("world.furniture[{}].name", i);
    const auto [known, is_new] = first.try_emplace(scene_.world.furniture[i].name, i);
    if (!is_new && sound(path)) {
      add(path, fmt::format("'{}' is the name of world.furniture[{}] too", known->first, known->second),
          "expected a name of its own");
    }
  }
}

void SceneChecks::shapes() {
  const auto check = [this](const std::string& path, const std::vector<Vec2>& corners) {
    if (sound(path) && apart(path, corners, true) && !convex(corners)) {
      add(path, "the polygon is not convex",
          "expected corners that all turn the same way; split it into several");
    }
  };
  for (std::size_t i = 0; i < scene_.world.furniture.size(); ++i) {
    const world::Furniture& piece = scene_.world.furniture[i];
    if (piece.shape == world::FurnitureShape::kPolygon) {
      check(fmt::format("world.furniture[{}].points_m", i), piece.points_m);
    }
  }
  for (std::size_t i = 0; i < scene_.world.cliffs.size(); ++i) {
    check(fmt::format("world.cliffs[{}].corners_m", i), scene_.world.cliffs[i].corners_m);
  }
}

void SceneChecks::figures() {
  expectations();
  const world::RoombaDescription& base = scene_.robot.base;
  if (sound("robot.base") && base.battery_charge_mah > base.battery_capacity_mah) {
    add("robot.base.battery_charge_mah",
        fmt::format("{} mAh do not fit a battery of {} mAh", base.battery_charge_mah,
                    base.battery_capacity_mah),
        "expected at most battery_capacity_mah");
  }
  if (sound("robot.base") && base.wheel_base_m >= 2.0 * base.radius_m) {
    add("robot.base.wheel_base_m",
        fmt::format("the wheels, {} m apart, stand outside the body", base.wheel_base_m),
        fmt::format("expected less than {} m, twice radius_m", 2.0 * base.radius_m));
  }
  if (sound("world.carpet") && scene_.mission.map && !scene_.layout.carpet.laid) {
    add("world.carpet", "is none, but the mission is to map the carpet",
        "expected a carpet, or another mission");
  }
}

void SceneChecks::expectations() {
  const auto check = [this](const std::string& path, const std::optional<double>& min,
                            const std::optional<double>& max) {
    if (min && max && *min > *max) {
      add(path, fmt::format("min {} is above max {}", *min, *max), "no run can keep both");
    }
  };
  for (const Expectation& expectation : scene_.expect) {
    const std::string path = "expect." + expectation.name;
    check(path, expectation.min, expectation.max);
    for (std::size_t i = 0; i < kSeedStatistics.size(); ++i) {
      if (const auto& bounds = expectation.statistics[i]) {
        check(fmt::format("{}.{}", path, kSeedStatistics[i].key), bounds->min, bounds->max);
      }
    }
    if (expectation.rate_min && !expectation.min && !expectation.max) {
      add(path + ".rate", "there is no limit for it", "expected min or max beside it");
    }
  }
}

void SceneChecks::on_floor(const FloorPlan& floor) {
  carpet(floor);
  furniture(floor);
  markers(floor);
  start(floor);
}

void SceneChecks::carpet(const FloorPlan& floor) {
  const CarpetPlan& plan = scene_.layout.carpet;
  if (!plan.laid || !sound("world.carpet")) {
    return;
  }
  if (scene_.world.carpet.tiles.empty()) {
    add("world.carpet", "has no tile", "expected at least one tile whose middle lies on the floor");
    return;
  }
  std::set<std::pair<int, int>> tiles;
  for (std::size_t i = 0; plan.tiles && i < plan.tiles->size(); ++i) {
    const auto [column, row] = (*plan.tiles)[i];
    const std::string path = fmt::format("world.carpet.tiles[{}]", i);
    const Vec2 middle = scene_.world.carpet.origin_m + plan.tile_m * Vec2{column + 0.5, row + 0.5};
    if (!tiles.insert({column, row}).second) {
      add(path, fmt::format("[{}, {}] is listed twice", column, row), "expected each tile once");
    } else if (!floor.has_floor_at(middle)) {
      add(path,
          fmt::format("the middle of [{}, {}] is at {} m, where no floor is", column, row, in_words(middle)),
          "expected tiles whose tag lies on the floor");
    }
  }
  tiles = {scene_.world.carpet.tiles.begin(), scene_.world.carpet.tiles.end()};
  for (std::size_t i = 0; i < plan.unreadable.size(); ++i) {
    const auto [column, row] = plan.unreadable[i];
    if (tiles.count({column, row}) == 0) {
      add(fmt::format("world.carpet.unreadable[{}]", i),
          fmt::format("there is no tile [{}, {}]", column, row),
          "expected [column, row] of a tile that is laid");
    }
  }
}

void SceneChecks::furniture(const FloorPlan& floor) {
  for (std::size_t i = 0; i < scene_.world.furniture.size(); ++i) {
    const world::Furniture& piece = scene_.world.furniture[i];
    const std::string path = fmt::format("world.furniture[{}]", i);
    if (!sound(path)) {
      continue;
    }
    for (const Vec2& point : footprint_m(piece)) {
      if (!near_floor(floor, point)) {
        add(path, fmt::format("'{}' reaches {} m, where no floor is", piece.name, in_words(point)),
            "expected it to stand inside the walls");
        break;
      }
    }
  }
}

void SceneChecks::markers(const FloorPlan& floor) {
  const auto check = [&](const std::string& path, const Vec2& point) {
    if (sound(path) && !near_floor(floor, point)) {
      add(path, fmt::format("{} m is not on the floor", in_words(point)),
          "expected a place inside the walls");
    }
  };
  for (std::size_t i = 0; i < scene_.world.landmarks.size(); ++i) {
    check(fmt::format("world.landmarks[{}].at_m", i), scene_.world.landmarks[i].at_m);
  }
  for (std::size_t i = 0; i < scene_.world.virtual_walls.size(); ++i) {
    check(fmt::format("world.virtual_walls[{}].at_m", i), scene_.world.virtual_walls[i].X_WV.p_m);
  }
  if (scene_.world.home_base) {
    check("world.home_base.at_m", scene_.world.home_base->X_WH.p_m);
  }
}

void SceneChecks::start(const FloorPlan& floor) {
  const std::string path = "robot.start.at_m";
  if (!reader_.has(path) || !sound(path) || !sound("robot.base")) {
    return;
  }
  const Vec2 at = scene_.robot.X_WR_start.p_m;
  const double radius_m = scene_.robot.base.radius_m + scene_.robot.start_within_m;
  if (!floor.has_floor_at(at)) {
    add(path, fmt::format("{} m is not on the floor", in_words(at)), "expected a place inside the walls");
    return;
  }
  const std::string hint =
      scene_.robot.start_within_m > 0.0
          ? fmt::format("expected {:g} m, within_m and the robot's radius, free all round", radius_m)
          : fmt::format("expected the robot's radius, {} m, free all round", radius_m);
  // A start given to the millimetre may touch.
  constexpr double kTouch_m = 0.0005;
  double nearest_m = std::numeric_limits<double>::max();
  for (const world::Wall& wall : scene_.world.walls) {
    for (const Segment& side : sides(wall.points_m, wall.closed)) {
      nearest_m = std::min(nearest_m, distance_m(at, side));
    }
  }
  if (nearest_m < radius_m - kTouch_m) {
    add(path, fmt::format("is {:.3f} m from a wall", nearest_m), hint);
  }
  for (std::size_t i = 0; i < scene_.world.furniture.size(); ++i) {
    const world::Furniture& piece = scene_.world.furniture[i];
    const double gap_m = distance_m({at, at}, piece);
    const bool blocks =
        piece.shape == world::FurnitureShape::kLegs || piece.clearance_m <= scene_.robot.base.height_m;
    if (blocks && sound(fmt::format("world.furniture[{}]", i)) && gap_m < radius_m - kTouch_m) {
      add(path,
          gap_m > 0.0 ? fmt::format("is {:.3f} m from furniture '{}'", gap_m, piece.name)
                      : fmt::format("is inside furniture '{}'", piece.name),
          hint);
    }
  }
  for (std::size_t i = 0; i < scene_.world.cliffs.size(); ++i) {
    if (inside(at, scene_.world.cliffs[i].corners_m)) {
      add(path, fmt::format("is over world.cliffs[{}]", i), "expected floor under the robot");
    }
  }
}

}  // namespace sensotwin::twin
