// SPDX-License-Identifier: MIT
#include "world/solid_bodies.hpp"

#include <algorithm>

namespace sensotwin::world {
namespace {

/// Chosen low: Box2D mixes it with the wall's 0.2 to 0.1, a friction angle of 6 degrees. A rigid disc driven
/// into a wedge narrower than its friction angle locks there for ever, where real plastic springs out.
constexpr float kShellFriction = 0.05F;
constexpr double kGravity_mps2 = 9.81;

b2FixtureDef solid(const b2Shape& shape) {
  b2FixtureDef def;
  def.shape = &shape;
  def.friction = kShellFriction;
  def.restitution = 0.0F;
  return def;
}

b2Vec2 to_box(const Vec2& p_W_m, const Vec2& origin_m) {
  return {static_cast<float>(p_W_m.x() - origin_m.x()), static_cast<float>(p_W_m.y() - origin_m.y())};
}

/// Gives the body the outline's shape. \returns how far that reaches from the body's origin
double shape_m(b2Body& made, const Outline& outline) {
  double reach_m = 0.0;
  for (const Disc& d : outline.discs) {
    b2CircleShape circle;
    circle.m_p.Set(static_cast<float>(d.middle_m.x()), static_cast<float>(d.middle_m.y()));
    circle.m_radius = static_cast<float>(d.radius_m);
    b2FixtureDef fixture = solid(circle);
    fixture.density = 1.0F;
    made.CreateFixture(&fixture);
    reach_m = std::max(reach_m, d.middle_m.norm() + d.radius_m);
  }
  // Box2D's polygons have at most eight corners: a fan of pieces around the first one.
  const auto& edges = outline.segments;
  for (std::size_t first = 1; first + 1 < edges.size(); first += b2_maxPolygonVertices - 2) {
    std::vector<b2Vec2> corners{{static_cast<float>(edges[0].a_m.x()), static_cast<float>(edges[0].a_m.y())}};
    const std::size_t end = std::min(edges.size(), first + b2_maxPolygonVertices - 1);
    for (std::size_t i = first; i < end; ++i) {
      corners.emplace_back(static_cast<float>(edges[i].a_m.x()), static_cast<float>(edges[i].a_m.y()));
      reach_m = std::max(reach_m, edges[i].a_m.norm());
    }
    reach_m = std::max(reach_m, edges[0].a_m.norm());
    b2PolygonShape polygon;
    polygon.Set(corners.data(), static_cast<int32>(corners.size()));
    polygon.m_radius = 0.0F;
    b2FixtureDef fixture = solid(polygon);
    fixture.density = 1.0F;
    made.CreateFixture(&fixture);
  }
  return reach_m;
}

/// Makes an evenly dense body weigh this.
void weigh(b2Body& made, double mass_kg) {
  b2MassData mass;
  made.GetMassData(&mass);
  if (mass.mass > 0.0F) {
    const float scale = static_cast<float>(mass_kg) / mass.mass;
    mass.I *= scale;
    mass.mass *= scale;
    made.SetMassData(&mass);
  }
}

}  // namespace

bool contact_types_known() {
  static const bool known = [] {
    b2World scratch{b2Vec2{0.0F, 0.0F}};
    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    b2CircleShape disc;
    disc.m_radius = 1.0F;
    for (int i = 0; i < 2; ++i) {
      scratch.CreateBody(&moving)->CreateFixture(&disc, 1.0F);
    }
    scratch.Step(0.01F, 1, 1);
    return scratch.GetContactCount() == 1;
  }();
  return known;
}

Vec2 middle_m(const std::vector<Wall>& walls, const Vec2& otherwise_m) {
  Vec2 low_m = otherwise_m;
  Vec2 high_m = otherwise_m;
  for (const Wall& wall : walls) {
    for (const Vec2& p_m : wall.points_m) {
      low_m = low_m.cwiseMin(p_m);
      high_m = high_m.cwiseMax(p_m);
    }
  }
  return 0.5 * (low_m + high_m);
}

b2Body* make_ground(b2World& box, const Outline& fixed_W, const Vec2& origin_m) {
  b2BodyDef still;
  b2Body* ground = box.CreateBody(&still);
  for (const Segment& s : fixed_W.segments) {
    if ((s.a_m - s.b_m).squaredNorm() == 0.0) {
      continue;
    }
    b2EdgeShape edge;
    edge.SetTwoSided(to_box(s.a_m, origin_m), to_box(s.b_m, origin_m));
    // Box2D's 1 cm skin serves continuous collision, which is off; walls are where they are.
    edge.m_radius = 0.0F;
    const b2FixtureDef def = solid(edge);
    ground->CreateFixture(&def);
  }
  for (const Disc& d : fixed_W.discs) {
    b2CircleShape circle;
    circle.m_p = to_box(d.middle_m, origin_m);
    circle.m_radius = static_cast<float>(d.radius_m);
    const b2FixtureDef def = solid(circle);
    ground->CreateFixture(&def);
  }
  return ground;
}

Pushable make_pushable(b2Body& ground, std::uint32_t index, const Furniture& piece, double robot_height_m,
                       const Vec2& origin_m) {
  b2World& box = *ground.GetWorld();
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = to_box(piece.X_WF.p_m, origin_m);
  def.angle = static_cast<float>(piece.X_WF.yaw_rad);
  b2Body* made = box.CreateBody(&def);
  // A piece the robot passes beneath still has mass, but nothing that the robot's height could meet.
  const Outline outline = stands_in_the_way(piece, robot_height_m) ? outline_F(piece) : Outline{};
  const double reach_m = shape_m(*made, outline);
  weigh(*made, piece.mass_kg);
  // Dry friction with the floor as a joint, so that Box2D solves it together with the push: a piece stands
  // until the push exceeds it. Its moment acts on 2/3 of the reach, as for an evenly pressed disc.
  const double force_N = piece.friction * piece.mass_kg * kGravity_mps2;
  b2FrictionJointDef joint;
  joint.Initialize(&ground, made, made->GetWorldCenter());
  joint.maxForce = static_cast<float>(force_N);
  joint.maxTorque = static_cast<float>(force_N * reach_m * 2.0 / 3.0);
  joint.collideConnected = true;
  box.CreateJoint(&joint);
  return {index, made, outline, reach_m};
}

b2Body* make_shell(b2World& box, const RobotDescription& robot, const Vec2& origin_m) {
  const RoombaDescription& base = robot.base;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.allowSleep = false;
  def.position = to_box(robot.X_WR_start.p_m, origin_m);
  def.angle = static_cast<float>(robot.X_WR_start.yaw_rad);
  b2Body* body = box.CreateBody(&def);
  b2CircleShape shell;
  shell.m_radius = static_cast<float>(base.radius_m);
  b2FixtureDef fixture = solid(shell);
  fixture.density = static_cast<float>(base.mass_kg / (robot::kPi * base.radius_m * base.radius_m));
  body->CreateFixture(&fixture);
  return body;
}

}  // namespace sensotwin::world
