// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/base/geometry.hpp"
#include "world/radio_description.hpp"

/// What there is: plain values, in the order of the scene file. twin/scene fills them, world/ obeys them.
/// Each number's default lives here and nowhere else, with its source.
namespace sensotwin::world {

using robot::Pose2;
using robot::Vec2;

/// A wall: straight segments through `points_m`, and back to the first when closed. Infinitely thin, solid on
/// both sides, as high as the room.
struct Wall {
  std::vector<Vec2> points_m;
  bool closed{true};
};

/// What a tag on a piece of furniture says of it (SensoBot, Table 2): block 1, bytes 0 to 3.
struct ObjectTag {
  std::uint8_t category{0};
  std::uint8_t length{0};
  std::uint8_t width{0};
  std::uint8_t color{0};
};

enum class FurnitureShape : std::uint8_t { kCircle, kBox, kPolygon, kLegs };

struct Furniture {
  std::string name;
  FurnitureShape shape{FurnitureShape::kBox};
  Pose2 X_WF;                  ///< furniture frame in the world; legs and polygon corners are in F
  double radius_m{0.0};        ///< circle
  Vec2 size_m{0.0, 0.0};       ///< box: along x and y of F
  std::vector<Vec2> points_m;  ///< polygon: convex corners; legs: their centres
  double leg_radius_m{0.025};  ///< chosen: a 5 cm table leg
  double height_m{0.75};       ///< of its top, for the picture. Chosen: a table
  /// Free height below a box, circle or polygon; the robot (0.092 m high) drives under it when this is
  /// larger.
  double clearance_m{0.0};
  bool pushable{false};
  double mass_kg{8.0};           ///< of a pushable piece. Chosen: a kitchen chair is 4 to 8 kg
  double friction{0.4};          ///< of a pushable piece on the floor. Chosen: felt on carpet
  std::optional<ObjectTag> tag;  ///< one tag per leg, or one in the middle of each side, read from the front
};

/// SensoBot, Table 1: what a tag on the wall base says (block 0, bytes 0 and 1).
enum class LandmarkKind : std::uint8_t {
  kDoorOpeningSide,
  kDoorFixedSide,
  kFrontDoorOpeningSide,
  kFrontDoorFixedSide,
  kWindowLeft,
  kWindowRight,
  kPowerOutlet,
  kClosetLeft,
  kClosetRight,
};
struct Landmark {
  LandmarkKind kind{LandmarkKind::kPowerOutlet};
  Vec2 at_m{0.0, 0.0};
};

/// A rectangular grid of carpet tiles with one ISO 15693 tag in the middle of each. Tile (column, row) covers
/// origin_m + tile_m * [column, column+1] x [row, row+1]. Only the tiles listed exist.
struct Carpet {
  double tile_m{0.508};  ///< 20 inches (SensoBot, section III.A)
  Vec2 origin_m{0.0, 0.0};
  std::vector<std::pair<int, int>> tiles;       ///< (column, row), in reading order; empty = no carpet
  std::vector<std::pair<int, int>> unreadable;  ///< tiles whose tag is dead
  /// How far tags sit from the middle (1 sigma, per axis). Chosen: hand-laid.
  double tag_offset_sigma_m{0.005};
};

/// The floor under the wheels.
struct Floor {
  double friction{0.6};  ///< rubber on carpet, dimensionless. Chosen in 0.5 to 0.8
  /// Drag of castor and pile / weight, dimensionless. Chosen: low pile carpet.
  double rolling_resistance{0.04};
  /// Creep: slip ratio of a driven wheel per unit of (tractive force / friction limit), dimensionless.
  double creep{0.02};
  /// Unevenness: mean, and equally standard deviation, of the part of each wheel's way that the pile takes
  /// (exponentially distributed, so never negative), and the distance over which it stays the same. Chosen:
  /// with these the odometry is the "typ" class of the algorithms study, C.2 (tests/world/odometry_test.cpp
  /// measures it).
  double roughness{0.01};
  double roughness_length_m{0.05};
  /// Arm of the moment with which a tyre's contact patch resists turning on itself. Chosen: 2/3 of the radius
  /// of a patch 2 cm across, evenly pressed.
  double scrub_arm_m{0.007};
  /// Nap: sideways drift per metre driven across the lie of the pile, and the direction the pile lies in.
  double nap_drift{0.01};
  double nap_yaw_rad{0.0};
};

/// A hole in the floor (stairs): convex polygon.
struct Cliff {
  std::vector<Vec2> corners_m;
};
/// iRobot virtual wall: an infrared fan that the robot's receiver sees inside it.
struct VirtualWall {
  Pose2 X_WV;
  double range_m{2.5};         ///< chosen: the accessory's middle setting is about 2.5 m
  double half_angle_rad{0.1};  ///< chosen
};
struct HomeBase {
  Pose2 X_WH;  ///< contacts at the origin, facing along +x; the robot docks facing -x
};

/// A place where iron bends the earth's field: heading error = peak * exp(-(distance/radius)^2).
struct CompassDistortion {
  Vec2 at_m{0.0, 0.0};
  double radius_m{0.5};
  double peak_rad{0.0};
};

/// A tag on the floor near a junction (Tsukiyama, section 3): its unique number is all that is asked of it.
struct HallwayTag {
  std::uint64_t uid{0};
  Vec2 at_m{0.0, 0.0};
};

/// Somebody who walks about: seen by sonars and felt by the bumper as a disc. Stops before a robot.
struct Person {
  std::vector<Vec2> path_m;          ///< at least one point; of one point: stands there
  double start_s{0.0};               ///< comes then, or as soon as the robot is not on the spot
  std::optional<double> leaves_s{};  ///< is gone from then on; else at the end of the path
  double speed_mps{1.0};             ///< Chosen: unhurried; 1.4 is brisk
  double radius_m{0.22};             ///< Chosen: two feet and what swings between them, at the robot's height
  bool to_and_fro{false};            ///< turns at the ends of the path, and does not leave
};

/// Somebody who turns the robot where it stands at a place of the hallway map, as a wrong exit that no wheel
/// tells of (algorithms study, D: "wrong (90-deg) exits").
struct ShoveDescription {
  double share{0.0};  ///< of the stops at a place, at most one a visit
  double turn_rad{1.5707963267948966};
  double within_m{0.8};  ///< of the place. Chosen: where a robot stops that comes to it
  std::vector<Vec2> places_m;
};

struct WorldDescription {
  std::vector<Wall> walls;
  std::vector<Furniture> furniture;
  std::vector<Landmark> landmarks;
  Carpet carpet;
  Floor floor;
  std::vector<Cliff> cliffs;
  std::vector<VirtualWall> virtual_walls;
  std::optional<HomeBase> home_base;
  std::vector<CompassDistortion> compass_distortions;
  double ceiling_m{3.0};  ///< for the picture; each ceiling tag has a height of its own
  /// Direction of magnetic north as a yaw in W. pi/2: north is +y, as on a plan.
  double north_yaw_rad{1.5707963267948966};
  std::vector<HallwayTag> hallway_tags;
  double hallway_tag_reach_m{0.3};  ///< algorithms study, D: 0.3 to 1 m
  std::vector<Person> people;
  ShoveDescription shoves;
  std::optional<RadioWorld> radio;  ///< ceiling tags and who hears them; the floor tags below are TagField's
};

enum class RoombaKind : std::uint8_t { kCreate2, kRoomba400 };

/// What the mainboard's program answers wrongly (protocols study, 1.7): nothing since 3.4.1; the angle packet
/// before it; distance and requested radius too before 3.3.0; the Open Interface mode one too high on Wi-Fi
/// models.
enum class RoombaFirmware : std::uint8_t { kCurrent, kBefore341, kBefore330, kWifi };

/// Defaults: Create 2 Open Interface 2016 (wheel base, wheel, counts, speed); iRobot's published size and
/// weight.
struct RoombaDescription {
  RoombaKind kind{RoombaKind::kCreate2};
  RoombaFirmware firmware{RoombaFirmware::kCurrent};
  double radius_m{0.17};
  double height_m{0.092};
  double mass_kg{3.5};
  double wheel_base_m{0.235};
  double wheel_diameter_m{0.072};
  double counts_per_turn{508.8};
  double speed_max_mps{0.5};
  double wheel_acceleration_mps2{1.5};  ///< chosen: 0 to 0.3 m/s in 0.2 s, as Create 2 users report
  double drive_wheel_load{0.9};  ///< part of the weight on the driven wheels, the rest on the castor. Chosen
  /// Manufacturing: each wheel's diameter and the effective wheel base differ from nominal by these fractions
  /// (1 sigma, drawn once per run). "1 % after calibration" (algorithms study, C.2) for base and turns; the
  /// diameters are chosen so that their difference bends the path by 0.35 degrees a metre, no more than the
  /// carpet does.
  double wheel_diameter_sigma{0.001};
  double wheel_base_sigma{0.01};
  double battery_capacity_mah{2696.0};  ///< group packet example of the Create 2; 3000 mAh nominal NiMH
  double battery_charge_mah{2696.0};
};

/// A reading spot of an HF antenna: a disc on the floor in which a tag answers.
struct ReaderDescription {
  Vec2 at_m{0.0, 0.0};  ///< middle of the disc in R
  double read_radius_m{0.08};
  double exchange_s{0.012};  ///< one APDU exchange: ISO 15693 at 26 kbit/s plus USB. Chosen in 8 to 30 ms
  /// From a tag's coming into the field to its being reported and answering: its power-up, the reader's
  /// polling. 0: at once.
  double latency_s{0.0};
  double missed_share{0.0};  ///< of the tags come upon that are not heard until they are left again
  double torn_write_probability{0.25};  ///< that a cut-off write leaves a mixed block. Chosen
};

struct CompassDescription {
  double rate_hz{10.0};
  double noise_sigma_rad{0.017};  ///< 1 degree. Chosen: low-cost fluxgate or MEMS on a running robot
  double resolution_rad{0.0017453292519943296};  ///< 0.1 degree: the one decimal of HCHDM
};

/// Ultrasonic rangefinders on the front of the robot, "for forward and lateral sensing and the sensitivity
/// range is up to 5 meters" (Tsukiyama, section 4). What the two pages at hand leave open is assumed:
/// algorithms study, D.
struct SonarDescription {
  /// Where each looks in R, counter-clockwise from forward, left to right. Assumed: two to each side, square
  /// to the wall and 30 degrees ahead of that, and three forward.
  std::vector<double> bearings_rad{1.5707963267948966,  1.0471975511965976,  0.3490658503988659, 0.0,
                                   -0.3490658503988659, -1.0471975511965976, -1.5707963267948966};
  double mount_radius_m{0.15};  ///< of the ring they stand on, about the middle of R. Chosen: on the shell
  double half_angle_rad{
      0.2617993877991494};     ///< of the cone: 15 degrees (40 kHz transducers such as HC-SR04, MB10x0)
  double min_range_m{0.03};    ///< nearer things are told to be as far; algorithms study, D
  double max_range_m{5.0};     ///< Tsukiyama, section 4
  double noise_sigma_m{0.01};  ///< 1 sigma. Chosen: the resolution of MB12x0 rangefinders
  /// A wall answers while the sound meets it within this of its normal; beyond, it is a mirror. Chosen:
  /// painted plaster at 40 kHz (8.6 mm) is smooth; 30 degrees with the 15 of the cone loses walls met at more
  /// than 45.
  double specular_limit_rad{0.5235987755982988};
  /// An edge or corner scatters weakly and is heard this near. Chosen: half the range.
  double corner_range_m{2.5};
  double dropout{0.01};  ///< share of readings without an echo for no reason of geometry. Chosen
  double crosstalk{
      0.0};  ///< share of readings that hear a neighbour's nearer echo; 0: they fire one after the other
  double rate_hz{10.0};  ///< readings a second of each
};

struct RobotDescription {
  RoombaDescription base;
  ReaderDescription floor_reader;
  ReaderDescription forward_reader{.at_m = {0.20, 0.0}, .read_radius_m = 0.10};
  CompassDescription compass;
  std::optional<SonarDescription> sonar;
  Pose2 X_WR_start;
  /// More than 0: each run starts at a place of its own, uniform over the disc of this radius about
  /// X_WR_start, with any heading.
  double start_within_m{0.0};
};

/// Settings of the physics itself.
struct PhysicsDescription {
  /// Physics steps in one 15 ms tick. Chosen: the largest step whose halving moves the end of a reference
  /// drive by less than half a millimetre (tests/world/motion_test.cpp).
  int steps_per_tick{3};
};

}  // namespace sensotwin::world
