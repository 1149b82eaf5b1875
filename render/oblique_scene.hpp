// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "render/mesh.hpp"
#include "render/projection.hpp"
#include "render/scene_layers.hpp"
#include "render/views.hpp"

/// The shapes of the oblique view, before anything is drawn.
namespace sensotwin::render {

/// What is left of the walls of a map: in a home of many rooms some wall is always in front.
inline constexpr double kTracedWall_m = 0.22;

/// Triangles in W, and the picture they are made for.
struct Scene3d {
  Mesh ground;  ///< painted on the floor, in order
  Mesh solid;   ///< hides and is hidden
  Mesh glass;   ///< see-through, after everything
  Vec3 eye_m{0.0, 0.0, 1.0};
  double px_per_m{100.0};
  double line_px{1.0};
  [[nodiscard]] double line_m() const { return line_px / px_per_m; }
};

/// The view as triangles. `line_px` is the picture's unit of line width.
[[nodiscard]] Scene3d oblique_scene(const SceneView& view, const Vec3& eye_m, double px_per_m, double line_px,
                                    TileStyle style);

/// Whether the view has no floor of its own: no room and no tiles.
[[nodiscard]] bool needs_open_floor(const SceneView& view);
/// Low and high corner of the floor that is drawn then.
[[nodiscard]] std::pair<Vec2, Vec2> open_floor(const SceneView& view);

}  // namespace sensotwin::render
