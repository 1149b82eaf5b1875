// SPDX-License-Identifier: MIT
#include "tests/benchmarks/bare_house.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cassert>

#include "robot/base/time.hpp"
#include "world/obstacles.hpp"

namespace sensotwin::twin {
namespace {

// As world/world.cpp has them.
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;
constexpr float kShellFriction = 0.3F;

struct Velocity {
  b2Vec2 linear_mps;
  float turn_radps;
};

b2Vec2 to_box(const world::Vec2& p_m, const world::Vec2& origin_m) {
  return {static_cast<float>(p_m.x() - origin_m.x()), static_cast<float>(p_m.y() - origin_m.y())};
}

/// The middle of the walls: single precision is finest where the robot is.
world::Vec2 middle_m(const Scene& scene) {
  world::Vec2 low_m = scene.robot.X_WR_start.p_m;
  world::Vec2 high_m = low_m;
  for (const world::Wall& wall : scene.world.walls) {
    for (const world::Vec2& p_m : wall.points_m) {
      low_m = low_m.cwiseMin(p_m);
      high_m = high_m.cwiseMax(p_m);
    }
  }
  return 0.5 * (low_m + high_m);
}

}  // namespace

struct BareHouse::State {
  b2World box{b2Vec2{0.0F, 0.0F}};
  b2Body* body{nullptr};
  b2Vec2 start_m;
  float start_rad{0.0F};
  float step_s{0.0F};
  int steps_per_tick{1};
  std::vector<Velocity> velocities;  ///< one for each tick
  std::size_t next{0};
  double farthest_m{0.0};
  std::uint64_t touching_steps{0};

  void add_fixtures(const world::Outline& outline, const world::Vec2& origin_m);
  void add_robot(const Scene& scene);
  void learn(const std::vector<robot::Pose2>& path, const world::Vec2& origin_m);
  void step(const Velocity& v) {
    body->SetLinearVelocity(v.linear_mps);
    body->SetAngularVelocity(v.turn_radps);
    box.Step(step_s, kVelocityIterations, kPositionIterations);
  }
  [[nodiscard]] bool touches() const {
    for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
      if (edge->contact->IsTouching()) {
        return true;
      }
    }
    return false;
  }
};

void BareHouse::State::add_fixtures(const world::Outline& outline, const world::Vec2& origin_m) {
  b2BodyDef def;
  b2Body* ground = box.CreateBody(&def);
  b2FixtureDef fixture;
  fixture.friction = kShellFriction;
  for (const world::Segment& segment : outline.segments) {
    b2EdgeShape edge;
    edge.SetTwoSided(to_box(segment.a_m, origin_m), to_box(segment.b_m, origin_m));
    edge.m_radius = 0.0F;
    fixture.shape = &edge;
    ground->CreateFixture(&fixture);
  }
  for (const world::Disc& disc : outline.discs) {
    b2CircleShape circle;
    circle.m_p = to_box(disc.middle_m, origin_m);
    circle.m_radius = static_cast<float>(disc.radius_m);
    fixture.shape = &circle;
    ground->CreateFixture(&fixture);
  }
}

void BareHouse::State::add_robot(const Scene& scene) {
  const world::RoombaDescription& base = scene.robot.base;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.allowSleep = false;
  def.position = start_m;
  def.angle = start_rad;
  body = box.CreateBody(&def);
  b2CircleShape shell;
  shell.m_radius = static_cast<float>(base.radius_m);
  b2FixtureDef fixture;
  fixture.shape = &shell;
  fixture.friction = kShellFriction;
  fixture.density = static_cast<float>(base.mass_kg / (robot::kPi * base.radius_m * base.radius_m));
  body->CreateFixture(&fixture);
}

// Drives the path once in a closed loop, aiming each tick at the twin's next pose from where the body is, and
// keeps the velocities: Box2D gives the same drive again when they are played back.
void BareHouse::State::learn(const std::vector<robot::Pose2>& path, const world::Vec2& origin_m) {
  const auto tick_s = static_cast<float>(robot::to_s(robot::kTick));
  velocities.reserve(path.size());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const b2Vec2 target_m = to_box(path[i].p_m, origin_m);
    const b2Vec2 way_m = target_m - body->GetPosition();
    const auto turn_rad = static_cast<float>(robot::wrap_angle(path[i].yaw_rad - path[i - 1].yaw_rad));
    velocities.push_back({(1.0F / tick_s) * way_m, turn_rad / tick_s});
    for (int k = 0; k < steps_per_tick; ++k) {
      step(velocities.back());
      touching_steps += touches() ? 1 : 0;
    }
    farthest_m = std::max(farthest_m, static_cast<double>((target_m - body->GetPosition()).Length()));
  }
}

BareHouse::BareHouse(const Scene& scene, const std::vector<robot::Pose2>& path)
    : state_(std::make_unique<State>()) {
  assert(std::none_of(scene.world.furniture.begin(), scene.world.furniture.end(),
                      [](const world::Furniture& piece) { return piece.pushable; }));
  const world::Vec2 origin_m = middle_m(scene);
  state_->steps_per_tick = scene.physics.steps_per_tick;
  state_->step_s = static_cast<float>(robot::to_s(robot::kTick) / scene.physics.steps_per_tick);
  state_->start_m = to_box(path.front().p_m, origin_m);
  state_->start_rad = static_cast<float>(path.front().yaw_rad);
  state_->box.SetContinuousPhysics(false);
  state_->add_fixtures(world::fixed_outline(scene.world, scene.robot.base.height_m), origin_m);
  state_->add_robot(scene);
  state_->learn(path, origin_m);
  restart();
}

BareHouse::~BareHouse() = default;

void BareHouse::restart() {
  state_->body->SetTransform(state_->start_m, state_->start_rad);
  state_->next = 0;
}

void BareHouse::tick() {
  State& s = *state_;
  assert(s.next < s.velocities.size());
  const Velocity& v = s.velocities[s.next++];
  for (int k = 0; k < s.steps_per_tick; ++k) {
    s.step(v);
  }
}

std::size_t BareHouse::ticks() const {
  return state_->velocities.size();
}
double BareHouse::farthest_m() const {
  return state_->farthest_m;
}
std::uint64_t BareHouse::touching_steps() const {
  return state_->touching_steps;
}

}  // namespace sensotwin::twin
