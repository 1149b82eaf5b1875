// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/drawing.hpp"
#include "render/mesh.hpp"
#include "render/views.hpp"

namespace sensotwin::render {

/// How the tiles of a view are drawn.
enum class TileStyle : std::uint8_t {
  kStates,     ///< filled by state, under the furniture
  kRecovered,  ///< a see-through map laid over the true room
};

/// A short stroke on a tile, in the tile's own square from -0.5 to 0.5: what tells states apart without
/// colour.
struct TileMark {
  Vec2 from{0.0, 0.0};
  Vec2 to{0.0, 0.0};
  Rgba color;
  double width{0.05};  ///< of the tile's side
};
/// Nothing for the plain states.
[[nodiscard]] std::span<const TileMark> marks_of(TileState state);
/// The colour a tile gets in that style. Alpha < 255 in the recovered style.
[[nodiscard]] Rgba fill_of(TileState state, TileStyle style);

/// Triangles of the view from above, back to front. `px_per_m` gives lines their width, `line_px` is the
/// picture's unit of line width in pixels.
[[nodiscard]] std::vector<Vertex> top_view_triangles(const SceneView& view, double px_per_m, double line_px,
                                                     TileStyle style);

/// Parts that the oblique view shares.
namespace layers {
void floor(Mesh& mesh, const SceneView& view);
/// What the walls of a map enclose that is not floor.
void matter(Mesh& mesh, const SceneView& view);
void tiles(Mesh& mesh, const SceneView& view, double px_per_m, double line_px, TileStyle style);
void ground_marks(Mesh& mesh, const SceneView& view, double px_per_m, double line_px);
/// The ideal path, dashed, and the ellipses of estimates.
void ideal_path(Mesh& mesh, const SceneView& view, double px_per_m, double line_px);
void estimates(Mesh& mesh, const SceneView& view, double px_per_m, double line_px);
void trajectory(Mesh& mesh, const SceneView& view, double px_per_m, double line_px, double z_m);
}  // namespace layers

/// The closed wall with the largest area: the room. Null when no wall is closed.
[[nodiscard]] const WallView* room_of(const SceneView& view);
/// Walls traced from an occupancy map: staircases of its cells and specks, where drawn ones are a few long
/// lines.
[[nodiscard]] bool traced(const SceneView& view);
/// A closed wall around something solid. As a walk with free space on its left goes, it runs against the
/// room's sense and lies within it.
[[nodiscard]] bool encloses_matter(const WallView& wall, const WallView& room);
/// Where the time colours end, seconds; they begin at 0.
[[nodiscard]] double time_end_s(const SceneView& view);

}  // namespace sensotwin::render
