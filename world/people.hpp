// SPDX-License-Identifier: MIT
#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "robot/base/random.hpp"
#include "world/description.hpp"
#include "world/obstacles.hpp"

/// Those who walk about. Of world/ alone: the header is not published. Box2D's frame is W moved to an origin
/// of its own, m.
namespace sensotwin::world {

/// People on their ways: discs that Box2D moves as they walk, whatever is in the way, and that stop before a
/// robot. Deterministic: where each is follows from the time and from where the robot was.
class People {
 public:
  People(b2World& box, const std::vector<Person>& people, const Vec2& origin_m);

  /// Sets everybody's velocity for the tick that begins now. \param robot_m  in W
  void walk(double now_s, double tick_s, const Vec2& robot_m, double robot_radius_m);
  /// Who is there now, in W; one outline each.
  [[nodiscard]] const std::vector<Outline>& outlines() const { return outlines_; }
  [[nodiscard]] bool none() const { return walkers_.empty(); }

 private:
  struct Walker {
    Person person;
    b2Body* body;
    double way_m{0.0};     ///< gone along the path
    double length_m{0.0};  ///< of the path
    bool back{false};
    bool here{false};
  };
  [[nodiscard]] static Vec2 at_m(const Person& person, double way_m);
  void step(Walker& walker, double tick_s, const Vec2& robot_m, double near_m);

  std::vector<Walker> walkers_;
  std::vector<Outline> outlines_;
  Vec2 origin_m_;
};

/// Somebody turns a robot that stands at certain places, without its wheels: by chance, once a visit.
class Shoves {
 public:
  Shoves(const ShoveDescription& shoves, const robot::RandomStream& random)
      : shoves_(shoves), random_(random) {}

  /// After each tick. \param still  neither drives nor turns \returns how far it is turned now, rad
  [[nodiscard]] double turn_rad(const Vec2& robot_m, bool still, double tick_s);
  /// How many so far.
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  ShoveDescription shoves_;
  robot::RandomStream random_;
  std::optional<std::size_t> at_;  ///< the place where its chance has been drawn
  double left_rad_{0.0};           ///< of the present one
  std::uint64_t count_{0};
};

}  // namespace sensotwin::world
