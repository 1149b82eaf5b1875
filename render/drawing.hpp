// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/color.hpp"

namespace sensotwin::render {

/// A corner of a triangle in W, metres, with its final colour: light is worked out on the way in, so that the
/// driver only fills triangles, the one thing in which drivers agree.
struct Vertex {
  float x{0.0F};
  float y{0.0F};
  float z{0.0F};
  Rgba color;
};

/// Triangles, three vertices each, drawn in order.
struct TriangleLayer {
  std::vector<Vertex> vertices;
  bool depth_test{false};   ///< hidden behind what was drawn nearer
  bool depth_write{false};  ///< hides what comes later and lies farther
};

/// All that a backend needs to make a picture.
struct Drawing {
  int width_px{0};
  int height_px{0};
  Rgba background{palette::kPaper};
  Eigen::Matrix4d clip_from_W{Eigen::Matrix4d::Identity()};
  std::vector<TriangleLayer> layers;
};

}  // namespace sensotwin::render
