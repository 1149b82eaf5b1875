// SPDX-License-Identifier: MIT
#include "world/world.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "robot/base/time.hpp"
#include "world/battery.hpp"
#include "world/body_sensors.hpp"
#include "world/box2d_clock.hpp"
#include "world/compass_field.hpp"
#include "world/obstacles.hpp"
#include "world/people.hpp"
#include "world/solid_bodies.hpp"
#include "world/sonar_ring.hpp"
#include "world/traction.hpp"

namespace sensotwin::world {
namespace {

/// Box2D's own recommendation (manual, "Simulating the World"): 8 velocity and 3 position iterations. They
/// cost only where something touches.
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;
constexpr double kTick_s = robot::to_s(robot::kTick);

// Currents, chosen in the range that Create 2 owners report (about 0.2 A standing, 0.5 A driving, wheel
// motors cut off near 1 A): what each drawer takes from the battery.
constexpr double kElectronics_ma = 180.0;
constexpr double kWheelIdle_ma = 60.0;
constexpr double kWheelPerForce_maN = 110.0;
constexpr double kMainBrush_ma = 450.0;
constexpr double kSideBrush_ma = 100.0;
constexpr double kVacuum_ma = 700.0;

/// Below this nothing counts as driving. Chosen: under the slowest commanded speed.
constexpr double kMoving_mps = 0.01;
/// Above this the stasis castor counts as turning (packet 58 is 0 then). Chosen.
constexpr double kTurning_rps = 0.3;

}  // namespace

struct World::State {
  State(const WorldDescription& world, const RobotDescription& robot_description,
        const PhysicsDescription& physics, const robot::RandomStream& random);

  void step(const std::array<double, 2>& target_mps);
  void feel_contacts();
  void draw_current(const RoombaOutputs& outputs);
  void follow_furniture();
  void turn_by_hand();
  void place();
  /// Of an antenna in R, in W.
  [[nodiscard]] Vec2 in_W(const Vec2& p_R_m) const {
    return {X_WR.p_m.x() + ahead.x() * p_R_m.x() - ahead.y() * p_R_m.y(),
            X_WR.p_m.y() + ahead.y() * p_R_m.x() + ahead.x() * p_R_m.y()};
  }

  [[nodiscard]] Pose2 pose(const b2Body& of) const {
    return {origin_m + Vec2{of.GetPosition().x, of.GetPosition().y},
            robot::wrap_angle(static_cast<double>(of.GetAngle()))};
  }

  RobotDescription robot;
  int steps_per_tick;
  float step_s;
  ObstacleIndex fixed;
  Vec2 origin_m;  ///< of Box2D's frame in W: the middle of the house, where single precision is finest
  b2World box{b2Vec2{0.0F, 0.0F}};
  b2Body* ground{nullptr};
  b2Body* body{nullptr};
  Pose2 X_WR;            ///< of the body, at the end of the last tick
  Vec2 ahead{1.0, 0.0};  ///< its direction
  std::vector<Pushable> pushables;
  std::vector<Outline> pushed_near;  ///< in W, of the pushables the light bumpers could see
  std::vector<Pose2> X_WF;
  Traction traction;
  BodySensors sensors;
  Battery battery;
  TagField tags;
  double floor_tag_radius_m;
  CompassField compass;
  std::optional<SonarRing> sonar;
  People people;
  Shoves shoves;
  std::uint64_t ticks{0};
  ContactCounts contacts;
  BumpSwitches bumped;
  std::array<double, 4> motor_ma{};
  bool docked{false};
  bool forward{false};
};

namespace {

BodyMass robot_mass(const RoombaDescription& base) {
  return {.mass_kg = base.mass_kg, .inertia_kgm2 = 0.5 * base.mass_kg * base.radius_m * base.radius_m};
}

}  // namespace

World::State::State(const WorldDescription& world, const RobotDescription& robot_description,
                    const PhysicsDescription& physics, const robot::RandomStream& random)
    : robot(robot_description),
      steps_per_tick(physics.steps_per_tick),
      step_s(static_cast<float>(kTick_s / physics.steps_per_tick)),
      fixed(fixed_outline(world, robot.base.height_m)),
      // From the walls alone, so that a piece added in a corner does not shift the frame and with it the
      // rounding.
      origin_m(middle_m(world.walls, robot.X_WR_start.p_m)),
      traction(robot.base, world.floor, robot_mass(robot.base), kTick_s / physics.steps_per_tick,
               random.fork("traction")),
      sensors(world, robot.base),
      battery(robot.base),
      tags(world, random.fork("tags")),
      floor_tag_radius_m(world.radio ? world.radio->floor_tag_radius_m : world.hallway_tag_reach_m),
      compass(world, robot.compass, random.fork("compass")),
      people(box, world.people, origin_m),
      shoves(world.shoves, random.fork("shoves")) {
  assert(steps_per_tick > 0);
  [[maybe_unused]] const bool stands = box2d_clock_stands();
  assert(stands);
  [[maybe_unused]] const bool known = contact_types_known();
  assert(known);
  // A step moves the robot at most 2.5 mm: nothing is thin enough to jump over.
  box.SetContinuousPhysics(false);
  ground = make_ground(box, fixed.outline(), origin_m);
  for (std::uint32_t i = 0; i < world.furniture.size(); ++i) {
    X_WF.push_back(world.furniture[i].X_WF);
    if (world.furniture[i].pushable) {
      pushables.push_back(make_pushable(*ground, i, world.furniture[i], robot.base.height_m, origin_m));
    }
  }
  body = make_shell(box, robot, origin_m);
  if (robot.sonar) {
    sonar.emplace(*robot.sonar, random.fork("sonar"));
  }
}

void World::State::step(const std::array<double, 2>& target_mps) {
  traction.turn_wheels(target_mps);
  const b2Rot& turn = body->GetTransform().q;
  const double c = turn.c;
  const double s = turn.s;
  const b2Vec2& v_W = body->GetLinearVelocity();
  const Footing footing{
      .on_floor = sensors.floor_is_whole() ? std::array{true, true} : sensors.wheels_on_floor(pose(*body)),
      .yaw_rad = static_cast<double>(body->GetAngle())};
  const BodyVelocity v = traction.apply({.forward_mps = c * v_W.x + s * v_W.y,
                                         .left_mps = c * v_W.y - s * v_W.x,
                                         .turn_rps = static_cast<double>(body->GetAngularVelocity())},
                                        footing);
  body->SetLinearVelocity({static_cast<float>(c * v.forward_mps - s * v.left_mps),
                           static_cast<float>(s * v.forward_mps + c * v.left_mps)});
  body->SetAngularVelocity(static_cast<float>(v.turn_rps));
  box.Step(step_s, kVelocityIterations, kPositionIterations);
  feel_contacts();
}

void World::State::feel_contacts() {
  bool wall = false;
  bool pushable = false;
  for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
    if (!edge->contact->IsTouching()) {
      continue;
    }
    (edge->other == ground ? wall : pushable) = true;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const b2Vec2 touch = body->GetLocalPoint(manifold.points[0]);
    const BumpSwitches pressed =
        switches_pressed(std::atan2(static_cast<double>(touch.y), static_cast<double>(touch.x)));
    bumped.left = bumped.left || pressed.left;
    bumped.right = bumped.right || pressed.right;
  }
  contacts.wall += wall && !contacts.touching_wall ? 1 : 0;
  contacts.push += pushable && !contacts.touching_pushable ? 1 : 0;
  contacts.touching_wall = wall;
  contacts.touching_pushable = pushable;
}

void World::State::draw_current(const RoombaOutputs& outputs) {
  motor_ma = {};
  double draw_ma = 0.0;
  if (!battery.empty()) {
    for (std::size_t i = 0; i < 2; ++i) {
      const bool turns = std::abs(traction.wheel_mps()[i]) > 0.0;
      motor_ma[i] = turns ? kWheelIdle_ma + kWheelPerForce_maN * std::abs(traction.force_N()[i]) : 0.0;
    }
    motor_ma[2] = kMainBrush_ma * std::abs(outputs.main_brush);
    motor_ma[3] = kSideBrush_ma * std::abs(outputs.side_brush);
    draw_ma =
        kElectronics_ma + motor_ma[0] + motor_ma[1] + motor_ma[2] + motor_ma[3] + kVacuum_ma * outputs.vacuum;
  }
  battery.pass(kTick_s, draw_ma, docked && outputs.charging_allowed);
}

void World::State::place() {
  X_WR = pose(*body);
  ahead = X_WR.direction();
}

void World::State::turn_by_hand() {
  const b2Vec2& v_W = body->GetLinearVelocity();
  const bool still = v_W.Length() < static_cast<float>(kMoving_mps) &&
                     std::abs(body->GetAngularVelocity()) < static_cast<float>(kTurning_rps);
  const double turn_rad = shoves.turn_rad(pose(*body).p_m, still, kTick_s);
  if (turn_rad != 0.0) {
    body->SetTransform(body->GetPosition(), body->GetAngle() + static_cast<float>(turn_rad));
  }
  contacts.shoves = shoves.count();
}

void World::State::follow_furniture() {
  pushed_near = people.outlines();
  const Vec2 at_m = X_WR.p_m;
  for (const Pushable& piece : pushables) {
    if (piece.body->IsAwake()) {
      X_WF[piece.index] = pose(*piece.body);
      tags.move_furniture(piece.index, X_WF[piece.index]);
    }
    if ((X_WF[piece.index].p_m - at_m).norm() < piece.reach_m + 2.0 * robot.base.radius_m + 0.1) {
      pushed_near.push_back(moved(piece.outline_F, X_WF[piece.index]));
    }
  }
}

World::World(const WorldDescription& world, const RobotDescription& robot, const PhysicsDescription& physics,
             const robot::RandomStream& random)
    : state_(std::make_unique<State>(world, robot, physics, random)) {
  state_->place();
  state_->follow_furniture();
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::tick(const RoombaOutputs& outputs) {
  State& s = *state_;
  const double drive = s.battery.empty() ? 0.0 : 1.0;
  const double limit_mps = s.robot.base.speed_max_mps;
  const std::array<double, 2> target_mps = {
      drive * std::clamp(outputs.wheel_left_mps, -limit_mps, limit_mps),
      drive * std::clamp(outputs.wheel_right_mps, -limit_mps, limit_mps)};
  s.bumped = {};
  s.people.walk(kTick_s * static_cast<double>(s.ticks++), kTick_s, s.X_WR.p_m, s.robot.base.radius_m);
  for (int i = 0; i < s.steps_per_tick; ++i) {
    s.step(target_mps);
  }
  // Single precision is finest near zero: an angle that has grown past a few turns is brought back.
  if (std::abs(s.body->GetAngle()) > 4.0F * b2_pi) {
    s.body->SetTransform(s.body->GetPosition(),
                         static_cast<float>(robot::wrap_angle(static_cast<double>(s.body->GetAngle()))));
  }
  s.turn_by_hand();
  s.place();
  if (!s.pushables.empty() || !s.people.none()) {
    s.follow_furniture();
  }
  s.docked = s.sensors.docked(s.X_WR);
  s.draw_current(outputs);
  const double forward_mps =
      static_cast<double>(b2Dot(s.body->GetLinearVelocity(), s.body->GetWorldVector(b2Vec2{1.0F, 0.0F})));
  s.forward = forward_mps > kMoving_mps && std::abs(s.body->GetAngularVelocity()) < kTurning_rps;
}

RoombaInputs World::roomba_inputs() const {
  const State& s = *state_;
  RoombaInputs in;
  in.bump_left = s.bumped.left;
  in.bump_right = s.bumped.right;
  s.sensors.read(s.fixed, s.pushed_near, s.X_WR, in);
  in.wheel_angle_left_rad = s.traction.wheel_angle_rad()[0];
  in.wheel_angle_right_rad = s.traction.wheel_angle_rad()[1];
  in.forward_progress = s.forward;
  std::transform(s.motor_ma.begin(), s.motor_ma.end(), in.motor_ma.begin(),
                 [](double ma) { return static_cast<std::int16_t>(std::lround(ma)); });
  in.battery_mv = static_cast<std::uint16_t>(std::lround(s.battery.voltage_mv()));
  in.battery_ma = static_cast<std::int16_t>(std::lround(s.battery.current_ma()));
  in.battery_c = 25;  // chosen: a battery in a warm room; its heating is left out
  in.battery_charge_mah = s.battery.charge_mah();
  in.battery_capacity_mah = s.battery.capacity_mah();
  in.on_home_base = s.docked;
  in.power = !s.battery.empty();
  return in;
}

Pose2 World::X_WR() const {
  return state_->X_WR;
}
std::span<const Pose2> World::X_WF() const {
  return state_->X_WF;
}
const ContactCounts& World::contacts() const {
  return state_->contacts;
}
std::span<const Tag> World::tags() const {
  return state_->tags.tags();
}
TagMemory& World::tag_memory(TagIndex tag) {
  assert(tag < tags().size());
  return state_->tags.memory(tag);
}
std::optional<TagIndex> World::floor_tag() const {
  const ReaderDescription& reader = state_->robot.floor_reader;
  const Vec2 antenna_m = state_->in_W(reader.at_m);
  const auto carpet = state_->tags.carpet_tag(antenna_m, reader.read_radius_m);
  const auto loose = state_->tags.loose_tag(antenna_m, state_->floor_tag_radius_m);
  if (!carpet || !loose) {
    return carpet ? carpet : loose;
  }
  const auto distance_m = [&](TagIndex tag) { return (tags()[tag].at_m - antenna_m).norm(); };
  return distance_m(*loose) <= distance_m(*carpet) ? loose : carpet;
}
std::optional<TagIndex> World::forward_tag() const {
  const ReaderDescription& reader = state_->robot.forward_reader;
  return state_->tags.standing_tag(state_->in_W(reader.at_m), reader.read_radius_m);
}
double World::compass_heading_rad() {
  return state_->compass.read_heading_rad(X_WR());
}

std::vector<Disc> World::people() const {
  std::vector<Disc> discs;
  for (const Outline& outline : state_->people.outlines()) {
    discs.insert(discs.end(), outline.discs.begin(), outline.discs.end());
  }
  return discs;
}

std::vector<std::optional<double>> World::sonar_ranges_m() {
  State& s = *state_;
  if (!s.sonar) {
    return {};
  }
  std::vector<Outline> pushed = s.people.outlines();
  for (const Pushable& piece : s.pushables) {
    pushed.push_back(moved(piece.outline_F, s.X_WF[piece.index]));
  }
  return s.sonar->read_m(s.fixed, pushed, X_WR());
}

double World::energy_j() const {
  const auto kinetic_j = [](const b2Body& body) {
    const double turn = static_cast<double>(body.GetAngularVelocity());
    const double inertia =
        static_cast<double>(body.GetInertia() - body.GetMass() * body.GetLocalCenter().LengthSquared());
    return 0.5 * static_cast<double>(body.GetMass() * body.GetLinearVelocity().LengthSquared()) +
           0.5 * inertia * turn * turn;
  };
  double sum_j = kinetic_j(*state_->body);
  for (const Pushable& piece : state_->pushables) {
    sum_j += kinetic_j(*piece.body);
  }
  return sum_j;
}
double World::work_j() const {
  return state_->traction.work_J();
}

std::uint64_t World::state_hash() const {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 32;  // brings high bits down, which multiplication alone never does
  };
  const auto take = [&](double value) { mix(std::bit_cast<std::uint64_t>(value)); };
  const auto take_two = [&](float one, float other) {
    mix(std::uint64_t{std::bit_cast<std::uint32_t>(one)} << 32 | std::bit_cast<std::uint32_t>(other));
  };
  const auto take_body = [&](const b2Body& body) {
    take_two(body.GetPosition().x, body.GetPosition().y);
    take_two(body.GetAngle(), body.GetAngularVelocity());
    take_two(body.GetLinearVelocity().x, body.GetLinearVelocity().y);
  };
  const State& s = *state_;
  take_body(*s.body);
  for (const Pushable& piece : s.pushables) {
    take_body(*piece.body);
  }
  for (const double value : {s.traction.wheel_angle_rad()[0], s.traction.wheel_angle_rad()[1],
                             s.traction.wheel_mps()[0], s.traction.wheel_mps()[1], s.battery.charge_mah()}) {
    take(value);
  }
  return hash;
}

}  // namespace sensotwin::world
