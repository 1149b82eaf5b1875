// SPDX-License-Identifier: MIT
#pragma once

#include "render/mapping_pictures.hpp"
#include "render/plane_geometry.hpp"
#include "render/views.hpp"

namespace sensotwin::render::testing {

/// An L-shaped living and dining area that nobody lives in, with 207 tiles, a table, a sofa, a shelf on legs,
/// and a path in the manner of a depth-first mapping. `progress` 0 to 1 is how much of the path has been
/// driven.
[[nodiscard]] SceneView made_up_house(double progress = 1.0);
/// The same with every kind of mark that a view can hold.
[[nodiscard]] SceneView house_with_everything();
/// Made-up progress of four explorers on it.
[[nodiscard]] TagsOverTime made_up_runs();

}  // namespace sensotwin::render::testing
