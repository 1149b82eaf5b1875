// SPDX-License-Identifier: MIT
#pragma once

#include "render/canvas.hpp"
#include "render/label_placer.hpp"
#include "render/projection.hpp"
#include "render/views.hpp"

namespace sensotwin::render {

/// The names of ceiling tags beside their marks, off each other's marks and names and, where it can be, off
/// the path. `hanging`: at the tags' heights, with plumb lines; else where these meet the floor.
void draw_tag_names(Canvas& canvas, const SceneView& view, const Projection& X, LabelPlacer& placer,
                    bool hanging, double unit_px);

}  // namespace sensotwin::render
