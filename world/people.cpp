// SPDX-License-Identifier: MIT
#include "world/people.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::world {
namespace {

/// So far from a robot in their way people stop, shell to shell, and so near none comes out of a door.
/// Chosen: half a step.
constexpr double kBefore_m = 0.35;
/// How fast a robot is turned. Chosen: a quarter turn in 0.8 s.
constexpr double kTurn_radps = 2.0;

double length_of(const std::vector<Vec2>& path_m) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path_m.size(); ++i) {
    length_m += (path_m[i] - path_m[i - 1]).norm();
  }
  return length_m;
}

}  // namespace

People::People(b2World& box, const std::vector<Person>& people, const Vec2& origin_m) : origin_m_(origin_m) {
  for (const Person& person : people) {
    b2BodyDef def;
    def.type = b2_kinematicBody;
    def.enabled = false;
    b2Body* body = box.CreateBody(&def);
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(person.radius_m);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    body->CreateFixture(&fixture);
    walkers_.push_back({.person = person, .body = body, .length_m = length_of(person.path_m)});
  }
}

Vec2 People::at_m(const Person& person, double way_m) {
  for (std::size_t i = 1; i < person.path_m.size(); ++i) {
    const Vec2 leg_m = person.path_m[i] - person.path_m[i - 1];
    const double leg = leg_m.norm();
    if (way_m <= leg && leg > 0.0) {
      return person.path_m[i - 1] + way_m / leg * leg_m;
    }
    way_m -= leg;
  }
  return person.path_m.back();
}

void People::walk(double now_s, double tick_s, const Vec2& robot_m, double robot_radius_m) {
  outlines_.clear();
  for (Walker& walker : walkers_) {
    const Person& person = walker.person;
    const double near_m = person.radius_m + robot_radius_m + kBefore_m;
    const bool gone = (person.leaves_s && now_s >= *person.leaves_s) ||
                      (!person.to_and_fro && walker.length_m > 0.0 && walker.way_m >= walker.length_m);
    const bool comes = !walker.here && !gone && now_s >= person.start_s &&
                       (at_m(person, walker.way_m) - robot_m).norm() > near_m;
    if (comes || (gone && walker.here)) {
      walker.here = comes;
      walker.body->SetEnabled(comes);
    }
    if (walker.here) {
      step(walker, tick_s, robot_m, near_m);
    }
  }
}

void People::step(Walker& walker, double tick_s, const Vec2& robot_m, double near_m) {
  const Person& person = walker.person;
  const Vec2 from_m = at_m(person, walker.way_m);
  const double stride_m = person.speed_mps * tick_s;
  const double next = std::clamp(walker.way_m + (walker.back ? -stride_m : stride_m), 0.0, walker.length_m);
  const Vec2 to_m = at_m(person, next);
  const Vec2 off_m = robot_m - from_m;
  const bool before_robot = off_m.norm() < near_m && off_m.dot(to_m - from_m) > 0.0;
  const Vec2 in_box_m = from_m - origin_m_;
  walker.body->SetTransform({static_cast<float>(in_box_m.x()), static_cast<float>(in_box_m.y())}, 0.0F);
  Vec2 v_mps{0.0, 0.0};
  if (!before_robot) {
    v_mps = (to_m - from_m) / tick_s;
    walker.way_m = next;
    walker.back = person.to_and_fro && (next >= walker.length_m || (walker.back && next > 0.0));
  }
  walker.body->SetLinearVelocity({static_cast<float>(v_mps.x()), static_cast<float>(v_mps.y())});
  Outline outline;
  outline.discs.push_back({at_m(person, walker.way_m), person.radius_m});
  outlines_.push_back(std::move(outline));
}

double Shoves::turn_rad(const Vec2& robot_m, bool still, double tick_s) {
  if (at_ && (shoves_.places_m[*at_] - robot_m).norm() > 2.0 * shoves_.within_m) {
    at_.reset();
  }
  for (std::size_t i = 0; !at_ && still && i < shoves_.places_m.size(); ++i) {
    if ((shoves_.places_m[i] - robot_m).norm() < shoves_.within_m) {
      at_ = i;
      const bool happens = random_.chance(shoves_.share);
      const double side = random_.chance(0.5) ? 1.0 : -1.0;
      left_rad_ = happens ? side * shoves_.turn_rad : 0.0;
      count_ += happens ? 1 : 0;
    }
  }
  const double now_rad = std::clamp(left_rad_, -kTurn_radps * tick_s, kTurn_radps * tick_s);
  left_rad_ -= now_rad;
  return now_rad;
}

}  // namespace sensotwin::world
