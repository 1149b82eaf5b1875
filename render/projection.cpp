// SPDX-License-Identifier: MIT
#include "render/projection.hpp"

#include <Eigen/Geometry>

namespace sensotwin::render {

Projection Projection::top(const Vec2& center_m, const Vec2& center_px, double px_per_m) {
  Eigen::Matrix<double, 3, 4> m = Eigen::Matrix<double, 3, 4>::Zero();
  m(0, 0) = px_per_m;
  m(0, 3) = center_px.x() - px_per_m * center_m.x();
  m(1, 1) = -px_per_m;
  m(1, 3) = center_px.y() + px_per_m * center_m.y();
  m(2, 3) = 1.0;
  // Heights from -100 m to 100 m lie inside the view; higher is nearer to the eye.
  return {m, Eigen::RowVector4d{0.0, 0.0, -0.01, 0.0}};
}

Vec2 Projection::pixel(const Vec3& p_W) const {
  const Vec3 h = pixel_from_W_ * p_W.homogeneous();
  return h.head<2>() / h.z();
}

double Projection::px_per_m(const Vec3& p_W) const {
  // Third row = distance along the line of sight; the first row's slope is the focal length in pixels.
  const double w = (pixel_from_W_ * p_W.homogeneous()).z();
  const Eigen::RowVector3d across = pixel_from_W_.row(0).head<3>();
  const Eigen::RowVector3d forward = pixel_from_W_.row(2).head<3>();
  const double n = forward.squaredNorm();
  const Eigen::RowVector3d pure =
      n > 0.0 ? Eigen::RowVector3d(across - across.dot(forward) / n * forward) : across;
  return pure.norm() / w;
}

Eigen::Matrix4d Projection::clip_from_world(int width_px, int height_px) const {
  Eigen::Matrix4d clip;
  clip.row(0) = 2.0 / width_px * pixel_from_W_.row(0) - pixel_from_W_.row(2);
  clip.row(1) = pixel_from_W_.row(2) - 2.0 / height_px * pixel_from_W_.row(1);
  clip.row(2) = depth_from_W_;
  clip.row(3) = pixel_from_W_.row(2);
  return clip;
}

Projection Projection::scaled_and_moved(double scale, const Vec2& by_px) const {
  Projection out = *this;
  for (int axis = 0; axis < 2; ++axis) {
    out.pixel_from_W_.row(axis) = scale * pixel_from_W_.row(axis) + by_px[axis] * pixel_from_W_.row(2);
  }
  return out;
}

Projection perspective(const Vec3& eye_m, const Vec3& target_m, double near_m, double far_m) {
  const Vec3 forward = (target_m - eye_m).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 down = forward.cross(right);
  Eigen::Matrix<double, 3, 4> m;
  m.row(0) << right.transpose(), -right.dot(eye_m);
  m.row(1) << down.transpose(), -down.dot(eye_m);
  m.row(2) << forward.transpose(), -forward.dot(eye_m);
  const double a = (far_m + near_m) / (far_m - near_m);
  const double b = -2.0 * far_m * near_m / (far_m - near_m);
  Eigen::RowVector4d depth = a * m.row(2);
  depth(3) += b;
  return {m, depth};
}

}  // namespace sensotwin::render
