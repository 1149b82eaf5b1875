// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/error.hpp"
#include "robot/base/geometry.hpp"

/// What a picture of a scene is made from: plain values in frame W, metres, radians, seconds. Whoever wants a
/// picture fills them; render/ knows neither Box2D nor the types of world/, robot/mapping or twin/.
namespace sensotwin::render {

using robot::Pose2;
using robot::Vec2;

/// White, grey and black are the colours of SensoBot, section IV; the others are how a mapping can end
/// otherwise.
enum class TileState : std::uint8_t {
  kUnvisited,    ///< the antenna has not been there
  kGrey,         ///< visited, some neighbour still open
  kBlack,        ///< visited, all neighbours visited or closed off
  kBlocked,      ///< something stands on it
  kUnreachable,  ///< given up: no way for the antenna to its tag
  kMissed,       ///< reachable in truth, yet not mapped
  kWrong,        ///< mapped at a place where it is not
};

struct TileView {
  Vec2 center_m{0.0, 0.0};
  double size_m{0.508};  ///< 20 inches (SensoBot, section III.A)
  double yaw_rad{0.0};   ///< other than 0 when a recovered map lies askew over the truth
  TileState state{TileState::kUnvisited};
  std::string label;  ///< drawn in the middle where it fits; usually empty
};

/// Straight segments through the points, and back to the first when closed.
struct WallView {
  std::vector<Vec2> points_m;
  bool closed{true};
};

struct CircleView {
  Vec2 center_m{0.0, 0.0};
  double radius_m{0.0};
};

enum class FurnitureKind : std::uint8_t {
  kSolid,   ///< stands on the floor: the robot bumps into its outline
  kRaised,  ///< the robot drives under it
  kLegs,    ///< the robot bumps into the circles only; outline_m is the top
};

struct FurnitureView {
  std::string name;
  FurnitureKind kind{FurnitureKind::kSolid};
  /// Simple polygon (no edge crosses another), either sense. Empty: the circles are the body, or for kLegs
  /// the top is the convex hull around them.
  std::vector<Vec2> outline_m;
  std::vector<CircleView> circles;
  double height_m{0.75};
  double clearance_m{0.0};  ///< free height below a raised body
};

struct TimedPoint {
  Vec2 p_m{0.0, 0.0};
  double t_s{0.0};
};

/// Half axes and direction.
struct Ellipse {
  double major_m{0.0};
  double minor_m{0.0};
  double yaw_rad{0.0};  ///< of the major axis
};

struct AntennaView {
  Vec2 at_m{0.0, 0.0};  ///< in R: x forward, y left
  double height_m{0.1};
};

struct RobotView {
  Pose2 X_WR;
  double radius_m{0.17};
  double height_m{0.092};
  std::vector<AntennaView> antennas{};
};

/// A mark on the floor: where a tag truly lies.
struct TagView {
  Vec2 at_m{0.0, 0.0};
  bool dead{false};  ///< its chip does not answer
};

struct LandmarkView {
  Vec2 at_m{0.0, 0.0};
  std::string label;
};

struct CeilingTagView {
  Vec2 at_m{0.0, 0.0};
  double height_m{3.0};
  std::string label;
};

/// Where the robot believes the projection of a ceiling tag to be.
struct EstimateView {
  Vec2 at_m{0.0, 0.0};
  Ellipse ellipse;  ///< usually of 95 % (ellipse_of() in plane_geometry.hpp)
};

struct VirtualWallView {
  Pose2 X_WV;
  double range_m{2.5};
  double half_angle_rad{0.1};
};

struct SceneView {
  std::string title;     ///< what the picture shows
  std::string subtitle;  ///< figures, in words; may be empty
  std::string scene;     ///< name of the scene; printed with the seed
  std::uint64_t seed{0};

  std::vector<WallView> walls;
  std::vector<FurnitureView> furniture;
  std::vector<TileView> tiles;
  std::vector<TagView> tags;
  std::vector<LandmarkView> landmarks;
  std::vector<std::vector<Vec2>> cliffs_m;  ///< simple polygons
  std::vector<VirtualWallView> virtual_walls;
  std::optional<Pose2> home_base;  ///< facing along its x
  std::optional<Pose2> start;
  std::optional<RobotView> robot;
  std::vector<TimedPoint> trajectory;  ///< in order of time
  std::optional<double> time_end_s;    ///< end of the colour scale; the last point's time when absent

  double ceiling_m{3.0};
  std::vector<CeilingTagView> ceiling_tags;
  std::optional<std::size_t> target_tag;  ///< of ceiling_tags: rays run from the robot's antennas to it
  std::vector<Vec2> ideal_path_m;         ///< dashed on the floor: corners, or close points of a curve
  bool ideal_closed{false};
  std::vector<EstimateView> estimates;
  /// Yaw of magnetic north in W; pi/2 is up, as on a plan.
  double north_yaw_rad{robot::kPi / 2.0};
};

/// Smallest upright rectangle around things.
struct Extent {
  Vec2 min_m{0.0, 0.0};
  Vec2 max_m{0.0, 0.0};
  [[nodiscard]] Vec2 size_m() const { return max_m - min_m; }
  [[nodiscard]] Vec2 center_m() const { return 0.5 * (min_m + max_m); }
};

/// Convex hull of everything that stands or lies in the view, counter-clockwise; empty when there is nothing.
[[nodiscard]] std::vector<Vec2> outline_of(const SceneView& view);
/// Around everything that stands or lies in the view. A square metre about the origin when there is nothing.
[[nodiscard]] Extent extent_of(const SceneView& view);

/// \returns the first number of the view that cannot be drawn (NaN, infinite, beyond 10 km, a negative size)
/// as a sentence naming it; nothing when all is well.
[[nodiscard]] std::optional<RenderError> first_fault(const SceneView& view);

}  // namespace sensotwin::render
