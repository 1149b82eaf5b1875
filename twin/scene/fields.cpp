// SPDX-License-Identifier: MIT
#include "twin/scene/fields.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "robot/settings/mission_fields.hpp"
#include "robot/settings/shared_fields.hpp"
#include "twin/scene/phase_fields.hpp"

namespace sensotwin::twin {
namespace {

using robot::Pose2;

// Chosen: a kilometre is more than any floor, and floats of the physics still resolve 0.1 mm there.
constexpr robot::Range kWhere{-1000.0, 1000.0};
constexpr robot::Range kHeading{-360.0, 360.0};
constexpr robot::Range kFraction{0.0, 1.0};
// Box2D polygons have at most 8 corners (b2_maxPolygonVertices).
constexpr robot::Count kPolygon{3, 8};

constexpr std::array<std::string_view, 9> kLandmarkWords{
    "door_opening_side",     "door_fixed_side", "front_door_opening_side",
    "front_door_fixed_side", "window_left",     "window_right",
    "power_outlet",          "closet_left",     "closet_right"};
constexpr std::array<std::string_view, 1> kNoneWord{"none"};

void pose_fields(robot::FieldVisitor& v, Pose2& pose, bool heading_required = false) {
  v.point({"at_m", "x and y in the world, m", true}, pose.p_m, kWhere);
  v.angle({"heading_deg", "counter-clockwise from +x, degrees", heading_required}, pose.yaw_rad, kHeading);
}

void room_fields(robot::FieldVisitor& v, RoomPlan& room) {
  v.points({"walls_m", "corners of the outer wall, closed by itself, m", true}, room.walls_m, kWhere,
           {3, 10000});
  v.list({"partitions", "inner walls"}, room.partitions, [&](Partition& wall) {
    v.points({"points_m", "the wall runs straight from each to the next, m", true}, wall.points_m, kWhere,
             {2, 10000});
    v.flag({"closed", "and from the last back to the first"}, wall.closed);
  });
}

void carpet_fields(robot::FieldVisitor& v, CarpetPlan& carpet) {
  v.number({"tile_m", "side of a tile, m"}, carpet.tile_m, {0.1, 5.0});
  v.maybe({"origin_m", "a corner of the grid of tiles; without it, the lower left of the floor"},
          carpet.origin_m, [&](Vec2& origin) {
            v.point({"origin_m", "x and y, m"}, origin, kWhere);
          });
  v.maybe({"region_m", "two opposite corners: lay carpet only between them"}, carpet.region_m,
          [&](std::pair<Vec2, Vec2>& region) {
            std::vector<Vec2> corners{region.first, region.second};
            v.points({"region_m", "two opposite corners, m"}, corners, kWhere, {2, 2});
            if (corners.size() == 2) {
              region = {corners[0], corners[1]};
            }
          });
  v.maybe({"tiles", "[column, row]: lay exactly these"}, carpet.tiles, [&](robot::Cells& tiles) {
    v.cells({"tiles", "[column, row] of each tile"}, tiles);
  });
  v.cells({"without", "[column, row]: leave these out"}, carpet.without);
  v.cells({"unreadable", "[column, row]: their tags are dead"}, carpet.unreadable);
  v.number({"tag_offset_sigma_m", "how far tags sit from the middle, 1 sigma per axis, m"},
           carpet.tag_offset_sigma_m, {0.0, 0.2});
}

void shape_fields(robot::FieldVisitor& v, world::Furniture& piece) {
  using Shape = world::FurnitureShape;
  const auto choose = [&piece](Shape shape) { return [&piece, shape] { piece.shape = shape; }; };
  const std::array<robot::FieldVisitor::Alternative, 4> shapes{{
      {"radius_m", choose(Shape::kCircle),
       [&] {
         v.number({"radius_m", "a circle: its radius, m"}, piece.radius_m, {0.005, 100.0});
       }},
      {"size_m", choose(Shape::kBox),
       [&] {
         v.point({"size_m", "a box: its size along its own x and y, m"}, piece.size_m, {0.005, 100.0});
       }},
      {"points_m", choose(Shape::kPolygon),
       [&] {
         v.points({"points_m", "a convex polygon: its corners, in its own frame, m"}, piece.points_m, kWhere,
                  kPolygon);
       }},
      {"legs_m", choose(Shape::kLegs),
       [&] {
         v.points({"legs_m", "legs: their middles, in the piece's own frame, m"}, piece.points_m, kWhere,
                  {1, 64});
         v.number({"leg_radius_m", "radius of a leg, m"}, piece.leg_radius_m, {0.005, 1.0});
       }},
  }};
  v.one_of(static_cast<std::size_t>(piece.shape), shapes);
}

void furniture_fields(robot::FieldVisitor& v, world::Furniture& piece) {
  v.text({"name", "for messages, the picture and events", true}, piece.name);
  v.point({"at_m", "its own frame in the world: x and y, m"}, piece.X_WF.p_m, kWhere);
  v.angle({"heading_deg", "its own frame in the world, degrees"}, piece.X_WF.yaw_rad, kHeading);
  shape_fields(v, piece);
  v.number({"height_m", "of its top, for the picture, m"}, piece.height_m, {0.01, 10.0});
  v.number({"clearance_m", "free height below; the robot drives under it when it fits, m"}, piece.clearance_m,
           {0.0, 10.0});
  v.flag({"pushable", "the robot can push it"}, piece.pushable);
  v.number({"mass_kg", "of a pushable piece, kg"}, piece.mass_kg, {0.01, 1000.0});
  v.number({"friction", "of a pushable piece on the floor, dimensionless"}, piece.friction, {0.0, 2.0});
  v.maybe({"tag", "what its tags say of it (SensoBot, Table 2)"}, piece.tag, [&](world::ObjectTag& tag) {
    v.section({"tag", "what its tags say of it (SensoBot, Table 2)"}, [&] {
      v.whole({"category", "block 1, byte 0", true}, tag.category, 0, 255);
      v.whole({"length", "block 1, byte 1", true}, tag.length, 0, 255);
      v.whole({"width", "block 1, byte 2", true}, tag.width, 0, 255);
      v.whole({"color", "block 1, byte 3", true}, tag.color, 0, 255);
    });
  });
}

void floor_fields(robot::FieldVisitor& v, world::Floor& floor) {
  v.number({"friction", "of the wheels on the floor, dimensionless"}, floor.friction, {0.0, 2.0, true});
  v.number({"rolling_resistance", "drag / weight, dimensionless"}, floor.rolling_resistance, kFraction);
  v.number({"creep", "slip of a wheel at its friction limit, dimensionless"}, floor.creep, kFraction);
  v.number({"roughness", "unevenness: 1 sigma of a wheel's slip, dimensionless"}, floor.roughness, kFraction);
  v.number({"roughness_length_m", "distance over which that slip stays the same, m"},
           floor.roughness_length_m, {0.001, 10.0});
  v.number({"nap_drift", "sideways drift per metre across the lie of the pile"}, floor.nap_drift,
           {-1.0, 1.0});
  v.angle({"nap_yaw_deg", "direction the pile lies in, degrees"}, floor.nap_yaw_rad, kHeading);
}

void marker_fields(robot::FieldVisitor& v, world::WorldDescription& world) {
  v.list({"landmarks", "tags on the wall base (SensoBot, Table 1)"}, world.landmarks,
         [&](world::Landmark& landmark) {
           v.choice({"kind", "what the tag marks", true}, landmark.kind, kLandmarkWords);
           v.point({"at_m", "x and y in the world, m", true}, landmark.at_m, kWhere);
         });
}

void hazard_fields(robot::FieldVisitor& v, world::WorldDescription& world) {
  v.list({"cliffs", "holes in the floor"}, world.cliffs, [&](world::Cliff& cliff) {
    v.points({"corners_m", "of a convex polygon, m", true}, cliff.corners_m, kWhere, kPolygon);
  });
  v.list({"virtual_walls", "iRobot virtual walls"}, world.virtual_walls, [&](world::VirtualWall& wall) {
    pose_fields(v, wall.X_WV, true);
    v.number({"range_m", "length of its beam, m"}, wall.range_m, {0.0, 10.0, true});
    v.angle({"half_angle_deg", "half the width of its beam, degrees"}, wall.half_angle_rad,
            {0.0, 90.0, true});
  });
  v.maybe({"home_base", "the charger; the robot docks facing against its heading"}, world.home_base,
          [&](world::HomeBase& base) {
            v.section({"home_base", "the charger"}, [&] { pose_fields(v, base.X_WH, true); });
          });
  v.list(
      {"compass_distortions", "places where iron bends the earth's field"}, world.compass_distortions,
      [&](world::CompassDistortion& distortion) {
        v.point({"at_m", "x and y in the world, m", true}, distortion.at_m, kWhere);
        v.number({"radius_m", "where the error has fallen to 37 %, m"}, distortion.radius_m, {0.01, 100.0});
        v.angle({"peak_deg", "heading error in the middle, degrees", true}, distortion.peak_rad,
                {-180.0, 180.0});
      });
}

void people_fields(robot::FieldVisitor& v, world::WorldDescription& world) {
  v.list({"people", "who walk about, and stop before the robot"}, world.people, [&](world::Person& person) {
    v.points({"path_m", "where somebody walks, or one point to stand at, m", true}, person.path_m, kWhere,
             {1, 1000});
    v.number({"start_s", "when somebody comes, s"}, person.start_s, {0.0, 1.0e7});
    const robot::Field leaves{"leaves_s", "when somebody is gone; else at the end of the path, s"};
    v.maybe(leaves, person.leaves_s, [&](double& s) { v.number(leaves, s, {0.0, 1.0e7}); });
    v.number({"speed_mps", "walking, m/s"}, person.speed_mps, {0.01, 3.0});
    v.number({"radius_m", "of the disc that the robot meets, m"}, person.radius_m, {0.05, 1.0});
    v.flag({"to_and_fro", "turns at the ends of the path"}, person.to_and_fro);
  });
  v.section({"shoves", "somebody turns the robot where it stands at a place of the hallway map"}, [&] {
    v.number({"share", "of its stops"}, world.shoves.share, kFraction);
    v.angle({"turn_deg", "to the left or to the right, degrees"}, world.shoves.turn_rad, {0.0, 180.0});
    v.number({"within_m", "of the place, m"}, world.shoves.within_m, {0.1, 10.0});
  });
}

void world_fields(robot::FieldVisitor& v, Scene& scene) {
  Layout& layout = scene.layout;
  const std::array<robot::FieldVisitor::Alternative, 3> places{{
      {"room", [&] { layout.room.emplace(); },
       [&] {
         v.section({"room", "a room drawn by its corners"}, [&] { room_fields(v, *layout.room); });
       }},
      {"map", [&] { layout.map.emplace(); },
       [&] {
         v.section({"map", "a ROS map_server map"}, [&] {
           v.text({"file", "its YAML file, relative to the scene file", true}, layout.map->file);
           const robot::Field hallways{"hallways", "hallway map of the building, relative to the scene file"};
           v.maybe(
               hallways, !layout.map->hallways.empty(), [] {},
               [&] { v.text(hallways, layout.map->hallways); });
         });
       }},
      {"hallways", [&] { layout.hallways.emplace(); },
       [&] {
         v.section({"hallways", "a building drawn from its hallway map"}, [&] {
           v.text({"file", "the hallway map, relative to the scene file", true}, layout.hallways->file);
           v.list({"rooms", "floor beside the hallways: doorways and rooms"}, layout.hallways->rooms,
                  [&](FloorPiece& piece) {
                    v.point({"low_m", "its corner of least x and y, m", true}, piece.low_m, kWhere);
                    v.point({"high_m", "the corner across, m", true}, piece.high_m, kWhere);
                  });
         });
       }},
  }};
  v.one_of(layout.room       ? std::optional<std::size_t>{0}
           : layout.map      ? std::optional<std::size_t>{1}
           : layout.hallways ? std::optional<std::size_t>{2}
                             : std::nullopt,
           places);
  v.section_or_word(
      {"carpet", "tiles with a tag in the middle of each"}, kNoneWord,
      layout.carpet.laid ? std::nullopt : std::optional<std::size_t>{0},
      [&](std::size_t) { layout.carpet.laid = false; }, [&] { carpet_fields(v, layout.carpet); });
  v.list({"furniture", "fixed and pushable pieces"}, scene.world.furniture,
         [&](world::Furniture& piece) { furniture_fields(v, piece); });
  marker_fields(v, scene.world);
  people_fields(v, scene.world);
  v.section({"floor", "what is under the wheels"}, [&] { floor_fields(v, scene.world.floor); });
  hazard_fields(v, scene.world);
  radio_world_fields(v, scene.world);
  v.number({"ceiling_m", "height of the room, m"}, scene.world.ceiling_m, {0.2, 100.0});
  v.angle({"north_deg", "magnetic north, counter-clockwise from +x, degrees"}, scene.world.north_yaw_rad,
          kHeading);
}

void base_fields(robot::FieldVisitor& v, world::RoombaDescription& base) {
  robot::base_fields(v, base);
  v.number({"height_m", "of the body, m"}, base.height_m, {0.02, 1.0});
  v.number({"mass_kg", "of the machine, kg"}, base.mass_kg, {0.1, 50.0});
  v.number({"wheel_acceleration_mps2", "of a wheel, m/s^2"}, base.wheel_acceleration_mps2, {0.01, 100.0});
  v.number({"wheel_diameter_sigma", "1 sigma of each wheel's diameter, as a fraction"},
           base.wheel_diameter_sigma, {0.0, 0.2});
  v.number({"wheel_base_sigma", "1 sigma of the effective wheel base, as a fraction"}, base.wheel_base_sigma,
           {0.0, 0.2});
  v.number({"battery_capacity_mah", "mAh"}, base.battery_capacity_mah, {1.0, 100000.0});
  v.number({"battery_charge_mah", "at the start, mAh"}, base.battery_charge_mah, {0.0, 100000.0});
}

void reader_fields(robot::FieldVisitor& v, world::ReaderDescription& reader) {
  v.point({"at_m", "middle of its spot, in the robot's frame, m"}, reader.at_m, {-1.0, 1.0});
  v.number({"read_radius_m", "a tag answers within this radius, m"}, reader.read_radius_m, {0.005, 1.0});
  v.number({"exchange_s", "time of one command and its answer, s"}, reader.exchange_s, {0.0, 1.0});
  v.number({"latency_s", "from a tag's coming into the field to its answering, s"}, reader.latency_s,
           {0.0, 5.0});
  v.number({"missed_share", "of tags come upon that are not heard until they are left again"},
           reader.missed_share, kFraction);
  v.number({"torn_write_probability", "that a write cut off leaves a mixed block"},
           reader.torn_write_probability, kFraction);
}

void sonar_fields(robot::FieldVisitor& v, std::optional<world::SonarDescription>& sonar) {
  const robot::Field field{"sonar", "seven ultrasonic rangefinders on the sensor board; there in hallways"};
  v.maybe(field, sonar, [&](world::SonarDescription& s) {
    v.section(field, [&] {
      v.angle({"half_angle_deg", "of the cone, degrees"}, s.half_angle_rad, {1.0, 45.0});
      v.number({"min_range_m", "nearer things are told to be as far, m"}, s.min_range_m, {0.0, 1.0});
      v.number({"max_range_m", "farther things are not heard, m"}, s.max_range_m, {0.5, 20.0});
      v.number({"noise_sigma_m", "1 sigma, m"}, s.noise_sigma_m, {0.0, 1.0});
      v.angle({"specular_limit_deg", "from its normal a wall answers up to here, degrees"},
              s.specular_limit_rad, {0.0, 90.0});
      v.number({"corner_range_m", "a corner is heard this near, m"}, s.corner_range_m, {0.0, 20.0});
      v.number({"dropout", "share of readings without an echo"}, s.dropout, kFraction);
      v.number({"crosstalk", "share of readings that hear a neighbour's nearer echo"}, s.crosstalk,
               kFraction);
    });
  });
}

void robot_fields(robot::FieldVisitor& v, Scene& scene) {
  world::RobotDescription& robot = scene.robot;
  static constexpr std::array<std::string_view, 1> kAutoWord{"auto"};
  v.section_or_word(
      {"start", "pose at the start; auto, or none given: a tile's middle, found by the twin"}, kAutoWord,
      std::nullopt, [](std::size_t) {},
      [&] {
        pose_fields(v, robot.X_WR_start);
        v.number({"within_m",
                  "more than 0: each seed starts somewhere within this radius of at_m, with any heading, m"},
                 robot.start_within_m, {0.0, 100.0});
      });
  v.section({"base", "the Roomba"}, [&] { base_fields(v, robot.base); });
  v.section({"floor_reader", "reads the tags under the robot"},
            [&] { reader_fields(v, robot.floor_reader); });
  v.section({"forward_reader", "reads the tags ahead"}, [&] { reader_fields(v, robot.forward_reader); });
  uhf_reader_fields(v, scene.world);
  sonar_fields(v, robot.sonar);
  const robot::Field known{"hallways",
                           "the hallway map that it is given, where that is not the building's own"};
  v.maybe(
      known, !scene.known_file.empty(), [] {}, [&] { v.text(known, scene.known_file); });
  v.section({"compass", "heading from the earth's field"}, [&] {
    v.number({"rate_hz", "sentences a second, Hz"}, robot.compass.rate_hz, {0.1, 66.0});
    v.angle({"noise_sigma_deg", "1 sigma, degrees"}, robot.compass.noise_sigma_rad, {0.0, 180.0});
    v.angle({"resolution_deg", "smallest step it can tell, degrees"}, robot.compass.resolution_rad,
            {0.0, 90.0});
  });
}

void bounds_fields(robot::FieldVisitor& v, std::optional<double>& min, std::optional<double>& max) {
  v.maybe({"min", "not less than this"}, min, [&](double& value) {
    v.number({"min", "not less than this"}, value, {});
  });
  v.maybe({"max", "not more than this"}, max, [&](double& value) {
    v.number({"max", "not more than this"}, value, {});
  });
}

void expect_fields(robot::FieldVisitor& v, std::vector<Expectation>& expect) {
  v.named(
      {"expect", "figures of the summary and the bounds they must keep"}, expect.size(),
      [&](std::size_t i) { return expect[i].name; },
      [&](const std::string& name) {
        expect.push_back({.name = name, .min = std::nullopt, .max = std::nullopt});
        return expect.size() - 1;
      },
      [&](std::size_t i) {
        bounds_fields(v, expect[i].min, expect[i].max);
        const robot::Field rate{"rate", "share of the seeds of a validation that must keep min and max"};
        v.maybe(rate, expect[i].rate_min, [&](double& value) {
          v.section(rate, [&] {
            v.number({"min", "above 0, at most 1; 1 is every seed", true}, value, {0.0, 1.0, true});
          });
        });
        for (std::size_t k = 0; k < kSeedStatistics.size(); ++k) {
          const robot::Field field{kSeedStatistics[k].key, kSeedStatistics[k].help};
          v.maybe(field, expect[i].statistics[k], [&](Bounds& bounds) {
            v.section(field, [&] {
              bounds_fields(v, bounds.min, bounds.max);
              v.some_of({"min", "max"});
            });
          });
        }
        v.some_of(
            {"min", "max", "mean", "median", "quantile_2_5", "quantile_5", "quantile_95", "quantile_97_5"});
      });
}

}  // namespace

void visit_fields(robot::FieldVisitor& v, Scene& scene) {
  v.whole({"version", "of this file format: 1", true}, scene.version, 1, 1);
  v.seed({"seed", "every random stream of the run forks from this", true}, scene.seed);
  v.maybe(
      {"title", "what the scene shows; else the first comment line"}, !scene.title.empty(), [] {},
      [&] {
        v.text({"title", "what the scene shows, in a sentence"}, scene.title);
      });
  v.section({"world", "what there is", true}, [&] { world_fields(v, scene); });
  v.section({"robot", "the machine"}, [&] { robot_fields(v, scene); });
  v.section({"physics", "settings of the physics itself"}, [&] {
    v.whole({"steps_per_tick", "physics steps in one tick of 15 ms"}, scene.physics.steps_per_tick, 1, 100);
  });
  v.section({"mission", "what the robot is to do; by default, map the carpet"},
            [&] { robot::mission_fields(v, scene.mission); });
  expect_fields(v, scene.expect);
  v.number({"time_limit_s", "the run ends undone after this time, s"}, scene.limits.time_limit_s,
           {0.0, 1.0e7, true});
}

}  // namespace sensotwin::twin
