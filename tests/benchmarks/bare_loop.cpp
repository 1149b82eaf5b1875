// SPDX-License-Identifier: MIT
#include "tests/benchmarks/bare_loop.hpp"

#include <box2d/box2d.h>

#include <algorithm>

namespace sensotwin::twin {
namespace {

// As world/world.cpp has them.
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;
constexpr float kShellFriction = 0.3F;

class Box2dLoop final : public BareLoop {
 public:
  explicit Box2dLoop(const BareLoopInput& input);

  void restart() override { body_->SetTransform(start_m_, start_rad_); }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t tick = first; tick < last; ++tick) {
      for (int k = 0; k < steps_per_tick_; ++k) {
        step(velocities_[tick]);
      }
    }
  }
  [[nodiscard]] double farthest_m() const override { return farthest_m_; }
  [[nodiscard]] std::uint64_t touching_steps() const override { return touching_steps_; }

 private:
  struct Velocity {
    b2Vec2 linear_mps;
    float turn_radps;
  };

  void add_fixtures(const BareLoopInput& input);
  void add_robot(const BareLoopInput& input);
  void learn(const BareLoopInput& input);
  [[nodiscard]] bool touches() const;
  void step(const Velocity& v) {
    body_->SetLinearVelocity(v.linear_mps);
    body_->SetAngularVelocity(v.turn_radps);
    box_.Step(step_s_, kVelocityIterations, kPositionIterations);
  }

  b2World box_{b2Vec2{0.0F, 0.0F}};
  b2Body* body_{nullptr};
  b2Vec2 start_m_;
  float start_rad_;
  float step_s_;
  int steps_per_tick_;
  std::vector<Velocity> velocities_;  ///< one for each tick
  double farthest_m_{0.0};
  std::uint64_t touching_steps_{0};
};

Box2dLoop::Box2dLoop(const BareLoopInput& input)
    : start_m_(input.x_m, input.y_m),
      start_rad_(input.yaw_rad),
      step_s_(input.tick_s / static_cast<float>(input.steps_per_tick)),
      steps_per_tick_(input.steps_per_tick) {
  box_.SetContinuousPhysics(false);
  add_fixtures(input);
  add_robot(input);
  learn(input);
  body_->SetTransform(start_m_, start_rad_);
}

void Box2dLoop::add_fixtures(const BareLoopInput& input) {
  b2BodyDef def;
  b2Body* ground = box_.CreateBody(&def);
  b2FixtureDef fixture;
  fixture.friction = kShellFriction;
  for (const BareLoopInput::Edge& e : input.edges) {
    b2EdgeShape edge;
    edge.SetTwoSided({e.ax_m, e.ay_m}, {e.bx_m, e.by_m});
    edge.m_radius = 0.0F;
    fixture.shape = &edge;
    ground->CreateFixture(&fixture);
  }
  for (const BareLoopInput::Disc& disc : input.discs) {
    b2CircleShape circle;
    circle.m_p.Set(disc.x_m, disc.y_m);
    circle.m_radius = disc.radius_m;
    fixture.shape = &circle;
    ground->CreateFixture(&fixture);
  }
}

void Box2dLoop::add_robot(const BareLoopInput& input) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.allowSleep = false;
  def.position = start_m_;
  def.angle = start_rad_;
  body_ = box_.CreateBody(&def);
  b2CircleShape shell;
  shell.m_radius = input.shell_radius_m;
  b2FixtureDef fixture;
  fixture.shape = &shell;
  fixture.friction = kShellFriction;
  fixture.density = input.mass_kg / (b2_pi * input.shell_radius_m * input.shell_radius_m);
  body_->CreateFixture(&fixture);
}

// Drives the way once in a closed loop, aiming each tick at the twin's next place from where the body is, and
// keeps the velocities: Box2D gives the same drive again when they are played back.
void Box2dLoop::learn(const BareLoopInput& input) {
  velocities_.reserve(input.ticks.size());
  for (const BareLoopInput::Way& way : input.ticks) {
    const b2Vec2 target_m{way.x_m, way.y_m};
    velocities_.push_back(
        {(1.0F / input.tick_s) * (target_m - body_->GetPosition()), way.turn_rad / input.tick_s});
    for (int k = 0; k < steps_per_tick_; ++k) {
      step(velocities_.back());
      touching_steps_ += touches() ? 1 : 0;
    }
    farthest_m_ = std::max(farthest_m_, static_cast<double>((target_m - body_->GetPosition()).Length()));
  }
}

bool Box2dLoop::touches() const {
  for (const b2ContactEdge* edge = body_->GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching()) {
      return true;
    }
  }
  return false;
}

}  // namespace
}  // namespace sensotwin::twin

extern "C" sensotwin::twin::BareLoop* make_bare_loop(const sensotwin::twin::BareLoopInput& input) {
  return new sensotwin::twin::Box2dLoop(input);
}
