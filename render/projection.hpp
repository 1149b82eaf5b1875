// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "render/views.hpp"

namespace sensotwin::render {

using Vec3 = Eigen::Vector3d;

/// From points of W to pixels of one picture (x right, y down, from the top left corner; the middle of the
/// top left pixel is 0.5, 0.5). A projective map, so that the top view and the oblique view are one type.
class Projection {
 public:
  Projection() = default;
  /// \param pixel_from_W  3x4: homogeneous pixel coordinates from homogeneous W
  /// \param depth_from_W  1x4: the homogeneous depth row, increasing away from the eye, in [-1, 1] after
  /// division
  Projection(const Eigen::Matrix<double, 3, 4>& pixel_from_W, const Eigen::RowVector4d& depth_from_W)
      : pixel_from_W_(pixel_from_W), depth_from_W_(depth_from_W) {}

  /// Seen from straight above: x right, y up, the same scale in both.
  [[nodiscard]] static Projection top(const Vec2& center_m, const Vec2& center_px, double px_per_m);

  [[nodiscard]] Vec2 pixel(const Vec3& p_W) const;
  [[nodiscard]] Vec2 pixel(const Vec2& p_W) const { return pixel(Vec3{p_W.x(), p_W.y(), 0.0}); }
  /// Pixels per metre for lengths across the line of sight at that point.
  [[nodiscard]] double px_per_m(const Vec3& p_W) const;
  /// What OpenGL wants: clip coordinates from W, for a picture of that size.
  [[nodiscard]] Eigen::Matrix4d clip_from_world(int width_px, int height_px) const;
  /// The same view, scaled about the picture's origin and then moved.
  [[nodiscard]] Projection scaled_and_moved(double scale, const Vec2& by_px) const;

 private:
  Eigen::Matrix<double, 3, 4> pixel_from_W_{Eigen::Matrix<double, 3, 4>::Zero()};
  Eigen::RowVector4d depth_from_W_{Eigen::RowVector4d::Zero()};
};

/// A pin-hole view: `eye_m` looks at `target_m`, z is up. Pixels are in units of the focal length about 0, 0;
/// move and scale them into a picture with scaled_and_moved(). \pre eye and target differ, not only in height
[[nodiscard]] Projection perspective(const Vec3& eye_m, const Vec3& target_m, double near_m, double far_m);

}  // namespace sensotwin::render
