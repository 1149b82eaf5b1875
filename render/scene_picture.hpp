// SPDX-License-Identifier: MIT
#pragma once

#include "render/image.hpp"
#include "render/offscreen_context.hpp"
#include "render/picture_layout.hpp"
#include "render/projection.hpp"
#include "render/views.hpp"

namespace sensotwin::render {

struct PictureOptions {
  int width_px{1600};
  int height_px{0};  ///< 0: from the aspect of the scene
  TileStyle tiles{TileStyle::kStates};
};

/// A finished picture, and where in it the points of W are.
struct Picture {
  Image image;
  Projection pixel_from_W;
  RectPx plot;         ///< the part that shows the scene
  ScaleBar scale_bar;  ///< oblique view: a length across the line of sight in the middle of the floor
};

/// The scene from straight above: fitted, never distorted, x right and y up, with title, legend, scale bar
/// and north. The same view gives the same bytes on the same driver. \returns kBadView naming the first
/// number that cannot be drawn, or what the context returns.
[[nodiscard]] Rendered<Picture> draw_top_view(OffscreenContext& context, const SceneView& view,
                                              const PictureOptions& options = {});

/// The room from above its south-west corner, in perspective: floor, tiles and path; furniture with its
/// height; the walls behind as walls, those in front cut low so that they hide nothing; the ceiling as an
/// outline, with its tags and their plumb lines. Errors as draw_top_view().
[[nodiscard]] Rendered<Picture> draw_oblique_view(OffscreenContext& context, const SceneView& view,
                                                  const PictureOptions& options = {});

/// The plot of a top view alone, without title, legend or names: for sheets of many. `X` of the picture
/// covers `extent` in the middle.
[[nodiscard]] Rendered<Picture> draw_plan(OffscreenContext& context, const SceneView& view,
                                          const Extent& extent, int width_px, int height_px, double line_px,
                                          TileStyle tiles);

}  // namespace sensotwin::render
