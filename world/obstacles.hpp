// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world/description.hpp"

namespace sensotwin::world {

struct Segment {
  Vec2 a_m;
  Vec2 b_m;
};
struct Disc {
  Vec2 middle_m;
  double radius_m{0.0};
};

/// The outline of solid things at the robot's height: edges and discs, in one frame.
struct Outline {
  std::vector<Segment> segments;
  std::vector<Disc> discs;
};

[[nodiscard]] double distance_m(const Vec2& point_m, const Segment& segment);
/// 0 when they cross.
[[nodiscard]] double distance_m(const Segment& one, const Segment& other);
/// Distance along the unit vector `direction` from `origin_m` to where the ray meets the outline, at most
/// `limit_m`. A ray that starts inside a disc meets it at once.
[[nodiscard]] double ray_m(const Vec2& origin_m, const Vec2& direction, const Segment& segment,
                           double limit_m);
[[nodiscard]] double ray_m(const Vec2& origin_m, const Vec2& direction, const Disc& disc, double limit_m);

/// Whether a robot of this height meets the piece at all: legs always, the rest unless it passes beneath.
[[nodiscard]] bool stands_in_the_way(const Furniture& piece, double robot_height_m);
/// Outline of one piece in its own frame F.
[[nodiscard]] Outline outline_F(const Furniture& piece);
[[nodiscard]] Outline moved(const Outline& outline_F, const Pose2& X_WF);
/// All walls and the fixed furniture that stands in the robot's way, in W.
[[nodiscard]] Outline fixed_outline(const WorldDescription& world, double robot_height_m);

/// Which parts of a fixed outline are near a place: square buckets, each listing what crosses it.
/// Built once; a look-up allocates nothing and costs a few buckets, however large the house.
class ObstacleIndex {
 public:
  explicit ObstacleIndex(Outline outline);

  [[nodiscard]] const Outline& outline() const { return outline_; }

  /// Calls `segment(Segment)` and `disc(Disc)` for everything in the buckets that touch the box: all that
  /// touches the box, some that does not, and a long wall once for each bucket.
  template <class OnSegment, class OnDisc>
  void near(const Vec2& low_m, const Vec2& high_m, OnSegment&& segment, OnDisc&& disc) const {
    const auto [c0, r0] = cell(low_m);
    const auto [c1, r1] = cell(high_m);
    for (int r = r0; r <= r1; ++r) {
      for (int c = c0; c <= c1; ++c) {
        const auto bucket =
            static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        for (auto i = first_[bucket]; i < first_[bucket + 1]; ++i) {
          const std::uint32_t id = ids_[i];
          if (id < outline_.segments.size()) {
            segment(outline_.segments[id]);
          } else {
            disc(outline_.discs[id - outline_.segments.size()]);
          }
        }
      }
    }
  }
  /// Distance from a point to the nearest outline, or `limit_m` when nothing is that near.
  [[nodiscard]] double clearance_m(const Vec2& at_m, double limit_m) const;
  /// Distance from a segment to the nearest outline, or `limit_m` when nothing is that near.
  [[nodiscard]] double clearance_m(const Segment& path, double limit_m) const;
  /// Whether nothing fixed lies between two points.
  [[nodiscard]] bool in_sight(const Vec2& from_m, const Vec2& to_m) const;

 private:
  [[nodiscard]] std::array<int, 2> cell(const Vec2& at_m) const;

  Outline outline_;
  Vec2 low_m_{0.0, 0.0};
  int columns_{1};
  int rows_{1};
  std::vector<std::uint32_t> first_;  ///< where each bucket's ids begin; one more than there are buckets
  std::vector<std::uint32_t> ids_;    ///< segments first, then discs
};

}  // namespace sensotwin::world
